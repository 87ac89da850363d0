"""Pictures that move."""

import numpy as np
import pytest
from PIL import Image

from stylit_ref import InputError
from stylit_ref.files.animation_file import check_animation_writable, write_animation


@pytest.mark.parametrize("channels", [1, 3])
def test_pixels_come_back_exactly(tmp_path, channels):
    rng = np.random.default_rng(channels)
    pictures = rng.integers(0, 256, (3, 9, 12, channels), np.uint8)
    write_animation(tmp_path / "a.webp", iter(pictures), 40)
    moving = Image.open(tmp_path / "a.webp")
    assert moving.n_frames == 3
    for number, picture in enumerate(pictures):
        moving.seek(number)
        shown = np.broadcast_to(picture, (9, 12, 3))
        np.testing.assert_array_equal(np.array(moving.convert("RGB")), shown)


def test_what_cannot_move_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"a.gif: the file name of an animation must end in .webp"):
        check_animation_writable(tmp_path / "a.gif", 3)
    with pytest.raises(InputError, match="holds grey or three colours, and the style has 4"):
        check_animation_writable(tmp_path / "a.webp", 4)


def test_a_folder_that_cannot_be_written_is_told(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(InputError, match=r"a.webp: "):
        write_animation(tmp_path / "file" / "a.webp", [np.zeros((4, 4, 3), np.uint8)], 40)
    assert [each.name for each in tmp_path.iterdir()] == ["file"]
