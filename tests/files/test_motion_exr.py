"""Motion as an EXR of this project: exact, small, and read as one of many dialects too."""

import numpy as np
import pytest

from stylit_ref import InputError, write_image
from stylit_ref.files.motion_exr import read_written_motion, write_motion
from stylit_ref.files.motion_file import OWN, read_vectors
from stylit_ref.views.motion.reading import read_motion


def motion(height=23, width=31):
    rng = np.random.default_rng(5)
    field = rng.normal(scale=30, size=(height, width, 2)).astype(np.float32)
    return field, rng.random((height, width)) < 0.7


def test_every_bit_comes_back(tmp_path):
    field, visible = motion()
    field[0, :4, 0] = np.nan, -0.0, -np.inf, np.float32(1e-42)
    write_motion(tmp_path / "a.exr", field, visible)
    found, shown = read_written_motion(tmp_path / "a.exr")
    assert np.array_equal(found.view(np.uint32), field.view(np.uint32))
    assert np.array_equal(shown, visible)


def test_the_same_motion_gives_the_same_bytes(tmp_path):
    for name in "ab":
        write_motion(tmp_path / f"{name}.exr", *motion())
    assert (tmp_path / "a.exr").read_bytes() == (tmp_path / "b.exr").read_bytes()


def test_smooth_motion_takes_a_quarter_of_its_bytes(tmp_path):
    field = np.stack(np.meshgrid(np.arange(300), np.arange(200)), axis=2) / np.float32(64)
    field, visible = field.astype(np.float32), np.ones((200, 300), bool)
    write_motion(tmp_path / "a.exr", field, visible)
    assert (tmp_path / "a.exr").stat().st_size < (field.nbytes + visible.nbytes) / 4


def test_it_is_motion_of_the_projects_own_dialect(tmp_path):
    field, visible = motion()
    write_motion(tmp_path / "a.exr", field, visible)
    assert read_vectors(tmp_path / "a.exr").dialect == OWN
    found = read_motion(tmp_path / "a.exr")
    assert found.tells_visible
    assert np.array_equal(found.forward.field, field)
    assert np.array_equal(found.forward.visible, visible)


def test_half_a_file_is_refused(tmp_path):
    write_motion(tmp_path / "a.exr", *motion(200, 300))
    whole = (tmp_path / "a.exr").read_bytes()
    (tmp_path / "a.exr").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(InputError, match=r"a\.exr: cannot be read: "):
        read_written_motion(tmp_path / "a.exr")


def test_an_image_of_other_channels_is_refused(tmp_path):
    write_image(tmp_path / "a.exr", np.zeros((4, 5, 3), np.uint8))
    with pytest.raises(InputError, match=r"a\.exr: has the channels .*, which are not of a motion"):
        read_written_motion(tmp_path / "a.exr")
