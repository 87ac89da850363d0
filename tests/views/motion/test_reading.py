"""From a file to canonical fields."""

import numpy as np
import pytest
from exr_files import write_exr

from stylit_ref import InputError
from stylit_ref.files.motion_flo import write_flo
from stylit_ref.views.motion.reading import read_motion


def test_the_convention_is_that_of_the_names_or_that_given(tmp_path):
    write_flo(tmp_path / "a.flo", np.full((2, 3, 2), (5, 7), np.float32))
    assert (read_motion(tmp_path / "a.flo").forward.field == (5, 7)).all()
    turned = read_motion(tmp_path / "a.flo", "flo-flip-y-reverse")
    assert turned.forward is None
    assert (turned.backward.field == (5, -7)).all()


def test_names_that_tell_nothing_are_refused_without_a_convention(tmp_path):
    file = f"{write_exr(tmp_path / 'a.exr', {'speed.X': 1, 'speed.Y': 2})}:speed"
    with pytest.raises(InputError, match="do not tell the convention; name it"):
        read_motion(file)
    assert (read_motion(file, "flo-swap").forward.field == (2, 1)).all()


def test_an_unknown_convention_is_refused_before_the_file_is_read():
    with pytest.raises(InputError, match="convention is 'maya'"):
        read_motion("nowhere.exr", "maya")
