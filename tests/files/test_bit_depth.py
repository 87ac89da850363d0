"""Between display values and scene-linear light."""

import logging

import numpy as np
import pytest

from stylit_ref import InputError, to_uint8
from stylit_ref.files.bit_depth import to_depth, to_linear


def test_float_is_scene_linear():
    linear = np.array([-1, 0, 0.0031308, 0.18, 0.5, 1, 7], np.float32)
    np.testing.assert_array_equal(to_uint8(linear, curve="srgb"), [0, 0, 10, 118, 188, 255, 255])


def test_linear_and_display_are_inverse():
    every = np.arange(256, dtype=np.uint8)
    np.testing.assert_array_equal(to_uint8(to_linear(every), curve="srgb"), every)


def test_display_values_between_0_and_1_come_back_without_a_curve(caplog):
    every = np.arange(256, dtype=np.uint8)
    for depth in (np.float32, np.float64):
        np.testing.assert_array_equal(to_uint8((every / 255).astype(depth), curve="none"), every)
    assert not caplog.records


def test_floats_are_not_made_brighter_in_silence(caplog):
    grey = np.full((2, 2), 0.5)
    np.testing.assert_array_equal(to_uint8(grey), to_uint8(grey, curve="srgb"))
    (said,) = caplog.record_tuples
    assert said[:2] == ("stylit_ref", logging.WARNING)
    assert "curve='none'" in said[2]


def test_integers_need_no_curve(caplog):
    deep = np.arange(0, 65536, 257, dtype=np.uint16)
    np.testing.assert_array_equal(to_uint8(deep), np.arange(256))
    np.testing.assert_array_equal(to_uint8(deep, curve="srgb"), np.arange(256))
    assert not caplog.records


def test_another_curve_is_refused_by_name():
    with pytest.raises(InputError, match="curve is 'gamma'; it must be 'srgb' or 'none'"):
        to_uint8(np.zeros((2, 2)), curve="gamma")


@pytest.mark.parametrize("channels", [1, 2, 3, 4])
def test_depths_of_one_image_agree(channels):
    opaque = np.arange(256, dtype=np.uint8).reshape(16, 16, 1).repeat(channels, axis=2)
    if channels in (2, 4):
        opaque[..., -1] = 255
    deep = opaque.astype(np.uint16) * 257
    for dtype, expected in ((np.uint8, opaque), (np.uint16, deep), (np.float32, to_linear(deep))):
        for image in (opaque, deep, to_linear(deep)):
            converted = to_depth(image, np.dtype(dtype))
            assert converted.dtype == dtype
            np.testing.assert_allclose(converted, expected, rtol=1e-5, atol=1e-6)


def test_another_depth_is_refused_by_name():
    with pytest.raises(InputError, match="image has dtype int64; it must be") as refusal:
        to_uint8(np.zeros((2, 2), np.int64))
    assert refusal.value.parameter == "image"
