"""Nearest-neighbour fields out, and in again."""

import numpy as np
import pytest

from stylit_ref import Field, GuideEncoding, InputError, read_nnf, write_nnf
from stylit_ref.files.nnf_file import check_nnf_writable

NNF = np.random.default_rng(0).integers(-1, 99, (5, 7, 2), dtype=np.int32)
MASK = np.random.default_rng(0).random((5, 7)) < 0.5
ENCODINGS = (
    GuideEncoding("light", high=2.5),
    GuideEncoding("labels", labels=((1, (0, 0, 0)), (7, (255, 255, 255)))),
)
FIELDS = {
    "whole": Field(NNF, 7, 4, (456, 600), MASK),
    "with encodings": Field(NNF, 5, 0, (456, 600), MASK, ENCODINGS),
    "without a mask": Field(NNF, 5, 0, (456, 600)),
    "of an unknown run": Field(NNF),
    "with the integers of NumPy": Field(NNF, np.int64(5), np.int64(1), (np.int32(4), np.int32(9))),
}


@pytest.mark.parametrize("field", FIELDS.values(), ids=FIELDS)
def test_a_field_comes_back_with_its_run(tmp_path, field):
    write_nnf(tmp_path / "nnf.npy", field)
    again = read_nnf(tmp_path / "nnf.npy")
    np.testing.assert_array_equal(again.nnf, NNF)
    for name in ("patch_width", "vote_outliers", "style_size", "guide_encodings"):
        assert getattr(again, name) == getattr(field, name)
    assert (again.mask is None) == (field.mask is None)
    if field.mask is not None:
        np.testing.assert_array_equal(again.mask, MASK)
    assert [file.name for file in tmp_path.iterdir()] == ["nnf.npy"]


@pytest.mark.parametrize("mode", [None, "r"])
def test_numpy_reads_the_array(tmp_path, mode):
    write_nnf(tmp_path / "nnf.npy", FIELDS["whole"])
    np.testing.assert_array_equal(np.load(tmp_path / "nnf.npy", mmap_mode=mode), NNF)


@pytest.mark.parametrize("order", "CF")
def test_a_file_of_numpy_is_a_field(tmp_path, order):
    np.save(tmp_path / "nnf.npy", np.asarray(NNF, order=order))
    again = read_nnf(tmp_path / "nnf.npy")
    assert again.nnf.dtype == np.int32
    assert again.nnf.flags.c_contiguous
    np.testing.assert_array_equal(again.nnf, NNF)
    assert again.patch_width is again.style_size is again.mask is None


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (None, "cannot be read: No such file"),
        (b"no array", "is not a readable .npy file: it is a file of another kind"),
        (b"PK" + bytes(100), "is not a readable .npy file"),
    ],
)
def test_what_is_no_array_is_refused(tmp_path, content, message):
    file = tmp_path / "nnf.npy"
    if content is not None:
        file.write_bytes(content)
    with pytest.raises(InputError, match=rf"nnf\.npy: {message}"):
        read_nnf(file)


@pytest.mark.parametrize("missing", [1, 40, 200, 800, 1100])
def test_a_part_of_a_file_is_refused(tmp_path, missing):
    file = tmp_path / "nnf.npy"
    write_nnf(file, FIELDS["whole"])
    file.write_bytes(file.read_bytes()[:-missing])
    with pytest.raises(InputError, match=r"nnf\.npy: is not a readable \.npy file"):
        read_nnf(file)


@pytest.mark.parametrize(
    "second",
    ["no JSON", "3", "{}", '{"patch_width": "five", "vote_outliers": 0, "style_size": null}'],
)
def test_a_second_array_of_something_else_is_refused(tmp_path, second):
    with (tmp_path / "nnf.npy").open("wb") as file:
        np.save(file, NNF)
        np.save(file, np.array(second))
    with pytest.raises(InputError, match=r"nnf\.npy: is not a readable \.npy file"):
        read_nnf(tmp_path / "nnf.npy")


def test_a_mask_of_another_size_is_refused(tmp_path):
    write_nnf(tmp_path / "nnf.npy", Field(NNF, mask=MASK[1:]))
    with pytest.raises(InputError, match=r"its mask is bool of shape \(4, 7\)"):
        read_nnf(tmp_path / "nnf.npy")


@pytest.mark.parametrize(
    ("name", "message"),
    [("nnf.txt", "must end in .npy"), ("file/nnf.npy", "is a file; name a folder")],
)
def test_unwritable_outputs_are_refused_early(tmp_path, name, message):
    (tmp_path / "file").touch()
    with pytest.raises(InputError, match=message):
        check_nnf_writable(tmp_path / name)
