"""Saved coordinates."""

import json

import numpy as np
import pytest
from small_textures import identity

from stylit_ref import InputError, TextureField, read_texture_field, write_texture_field
from stylit_ref.files.texture_field import check_texture_field_writable

FIELD = TextureField(identity(5, 7), ((5, 7), (9, 2)))


def test_a_field_comes_back(tmp_path):
    write_texture_field(tmp_path / "s.npy", FIELD)
    read = read_texture_field(tmp_path / "s.npy")
    assert np.array_equal(read.coordinates, FIELD.coordinates)
    assert read.exemplar_sizes == FIELD.exemplar_sizes
    assert np.array_equal(np.load(tmp_path / "s.npy"), FIELD.coordinates)


@pytest.mark.parametrize(
    ("coordinates", "sizes", "said"),
    [
        (np.zeros((5, 7, 2), np.int32), [[5, 7]], "it holds int32 of shape (5, 7, 2)"),
        (np.zeros((5, 7, 3), np.int64), [[5, 7]], "it holds int64 of shape (5, 7, 3)"),
        (identity(5, 7), None, "it does not say of which exemplars it is"),
        (identity(5, 7), [[5, 6]], "it points outside its exemplars"),
        (identity(5, 7) + 1, [[9, 9]], "it points to an exemplar that is none of its 1"),
        (identity(5, 7), [[5, 0]], "the sizes of its exemplars are [(5, 0)]"),
    ],
)
def test_other_files_are_refused(tmp_path, coordinates, sizes, said):
    path = tmp_path / "s.npy"
    with path.open("wb") as file:
        np.save(file, coordinates)
        if sizes is not None:
            np.save(file, np.array(json.dumps({"exemplar_sizes": sizes})))
    with pytest.raises(InputError) as error:
        read_texture_field(path)
    assert str(error.value).startswith(f"{path}: is not a readable .npy file: {said}")


def test_a_cut_off_file_is_refused(tmp_path):
    write_texture_field(tmp_path / "s.npy", FIELD)
    content = (tmp_path / "s.npy").read_bytes()
    (tmp_path / "s.npy").write_bytes(content[: len(content) // 2])
    with pytest.raises(InputError, match=r"is not a readable \.npy file"):
        read_texture_field(tmp_path / "s.npy")


def test_another_suffix_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"the file name of saved coordinates must end in \.npy"):
        check_texture_field_writable(tmp_path / "s.png")
