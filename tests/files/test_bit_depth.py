"""Between display values and scene-linear light."""

import numpy as np
import pytest

from stylit_ref import InputError, to_uint8
from stylit_ref.files.bit_depth import to_linear


def test_float_is_scene_linear():
    linear = np.array([-1, 0, 0.0031308, 0.18, 0.5, 1, 7], np.float32)
    np.testing.assert_array_equal(to_uint8(linear), [0, 0, 10, 118, 188, 255, 255])


def test_linear_and_display_are_inverse():
    every = np.arange(256, dtype=np.uint8)
    np.testing.assert_array_equal(to_uint8(to_linear(every)), every)


def test_another_depth_is_refused_by_name():
    with pytest.raises(InputError, match="image has dtype int64; it must be") as refusal:
        to_uint8(np.zeros((2, 2), np.int64))
    assert refusal.value.parameter == "image"
