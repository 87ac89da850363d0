"""Nearest-neighbour fields out, and in again."""

import numpy as np
import pytest

from stylit_ref import InputError
from stylit_ref.files.nnf_file import check_nnf_writable, read_nnf, write_nnf


@pytest.mark.parametrize("order", "CF")
def test_a_field_comes_back(tmp_path, order):
    nnf = np.random.default_rng(0).integers(-1, 99, (5, 7, 2), dtype=np.int32)
    write_nnf(tmp_path / "nnf.npy", np.asarray(nnf, order=order))
    again = read_nnf(tmp_path / "nnf.npy")
    assert again.dtype == np.int32
    assert again.flags.c_contiguous
    np.testing.assert_array_equal(again, nnf)
    assert [file.name for file in tmp_path.iterdir()] == ["nnf.npy"]


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (None, "cannot be read: No such file"),
        (b"no array", "is not a readable .npy file"),
        (b"PK" + bytes(100), "is not a readable .npy file"),
    ],
)
def test_what_is_no_array_is_refused(tmp_path, content, message):
    file = tmp_path / "nnf.npy"
    if content is not None:
        file.write_bytes(content)
    with pytest.raises(InputError, match=rf"nnf\.npy: {message}"):
        read_nnf(file)


def test_half_a_file_is_refused(tmp_path):
    file = tmp_path / "nnf.npy"
    write_nnf(file, np.zeros((5, 7, 2), np.int32))
    file.write_bytes(file.read_bytes()[:-1])
    with pytest.raises(InputError, match=r"nnf\.npy: "):
        read_nnf(file)


@pytest.mark.parametrize(
    ("name", "message"), [("nnf.txt", "must end in .npy"), ("none/nnf.npy", "does not exist")]
)
def test_unwritable_outputs_are_refused_early(tmp_path, name, message):
    with pytest.raises(InputError, match=message):
        check_nnf_writable(tmp_path / name)
