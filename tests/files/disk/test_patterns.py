"""Names of numbered files, and frame ranges."""

import pytest

from stylit_ref import InputError
from stylit_ref.files.disk.frame_ranges import frames_of, range_text
from stylit_ref.files.disk.patterns import FramePattern, is_pattern


@pytest.mark.parametrize(
    ("text", "path"),
    [
        ("a.%04d.exr", "a.0007.exr"),
        ("a.%d.exr", "a.7.exr"),
        ("a.####.exr", "a.0007.exr"),
        ("a.#.exr", "a.7.exr"),
        ("a.$F4.exr", "a.0007.exr"),
        ("a.$F.exr", "a.7.exr"),
        ("%02d/a.%03d.exr:Combined", "07/a.007.exr:Combined"),
        ("shot#2/a.%02d.png", "shot#2/a.07.png"),
    ],
)
def test_a_placeholder_stands_for_the_number(text, path):
    assert FramePattern(text).path(7) == path


def test_negative_and_long_numbers_are_whole():
    pattern = FramePattern("a.%04d.exr")
    assert (pattern.path(-5), pattern.path(12345)) == ("a.-005.exr", "a.12345.exr")


def test_what_has_no_placeholder_is_no_pattern():
    assert not is_pattern("100%.png")
    assert not is_pattern("a$b.0001.exr")


def test_a_pair_has_two_numbers_in_one_name():
    assert FramePattern("m/%02d_to_%02d.exr").names_pairs
    assert FramePattern("m/%02d_to_%02d.exr").path_of_pair(3, 12) == "m/03_to_12.exr"
    assert not FramePattern("%02d/m.%02d.exr").names_pairs


@pytest.mark.parametrize("suffix", ["", ":Layer", ":View.Layer:x"])
def test_frames_on_the_disk(tmp_path, suffix):
    for name in ("a.0001.exr", "a.0010.exr", "a.010.exr", "a.00x1.exr", "a.-003.exr", "a.exr"):
        (tmp_path / name).touch()
    assert FramePattern(f"{tmp_path}/a.%04d.exr{suffix}").frames() == [-3, 1, 10]


def test_folders_can_be_numbered(tmp_path):
    for name in ("00", "01", "motion"):
        (tmp_path / name).mkdir()
    (tmp_path / "01" / "LDE.png").touch()
    assert FramePattern(f"{tmp_path}/%02d").frames() == [0, 1]
    assert FramePattern(f"{tmp_path}/%02d/LDE.png").frames() == [1]


def test_both_numbers_of_a_name_are_the_frame(tmp_path):
    for folder, name in (("01", "a.01.png"), ("02", "a.01.png")):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / name).touch()
    assert FramePattern(f"{tmp_path}/%02d/a.%02d.png").frames() == [1]


@pytest.mark.parametrize(
    ("text", "frames"),
    [
        ("7", (7,)),
        ("1-9x4,12", (1, 5, 9, 12)),
        ("3-1,2", (1, 2, 3)),
        ("-2-1", (-2, -1, 0, 1)),
    ],
)
def test_frame_ranges(text, frames):
    assert frames_of(text) == frames


@pytest.mark.parametrize("text", ["", "a", "1-", "1-5 7", "1.5-3", "1-99999999999"])
def test_what_is_no_frame_range(text):
    with pytest.raises(InputError, match="frames is "):
        frames_of(text)


def test_frames_become_a_short_text():
    assert range_text([9, 1, 3, 5, 20]) == "1-5x2,9,20"


@pytest.mark.parametrize(
    ("names", "respelled"),
    [
        (("a.1.exr", "a.10.exr"), "a.%d.exr"),
        (("a.00001.exr",), "a.%05d.exr"),
        (("a.0001.exr", "a.0002.exr", "a.7.exr"), "a.%04d.exr"),
        (("a.x.exr",), None),
    ],
)
def test_numbers_of_another_width(tmp_path, names, respelled):
    for name in names:
        (tmp_path / name).touch()
    for layer in ("", ":Depth"):
        expected = f"{tmp_path}/{respelled}{layer}" if respelled else None
        assert FramePattern(f"{tmp_path}/a.######.exr{layer}").respelled() == expected
