"""Between display values and scene-linear light."""

import logging

import numpy as np
import pytest

from stylit_ref import InputError, to_uint8
from stylit_ref.files.colour.bit_depth import to_depth, to_linear


def test_float_is_scene_linear():
    linear = np.array([-1, 0, 0.0031308, 0.18, 0.5, 1, 7], np.float32)
    np.testing.assert_array_equal(to_uint8(linear, curve="srgb"), [0, 0, 10, 118, 188, 255, 255])


def test_the_largest_floats_are_white():
    largest, tiny = np.finfo(np.float32).max, np.finfo(np.float32).tiny
    np.testing.assert_array_equal(to_uint8(np.float32([largest, -largest])), [255, 0])
    np.testing.assert_array_equal(to_uint8(np.float32([[largest, tiny]]), 1), [[255, 0]])


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


def test_data_has_no_curve():
    values = np.array([-1, 0, 0.25, 0.5, 1, 7], np.float32)
    np.testing.assert_array_equal(to_uint8(values, curve="none"), [0, 0, 64, 128, 255, 255])


def by_hand(linear, alpha):
    """The displayed value of one colour, in the words of the standard."""
    straight = linear / alpha
    if straight <= 0.0031308:
        return 12.92 * straight * alpha
    return (1.055 * straight ** (1 / 2.4) - 0.055) * alpha


@pytest.mark.parametrize("alpha_channel", [0, 1, 3])
def test_the_curve_goes_over_colours_divided_by_alpha(alpha_channel):
    rng = np.random.default_rng(0)
    alpha = rng.uniform(0.02, 1, (20, 30))
    colours = rng.random((20, 30, 3)) * alpha[..., None]
    image = np.insert(colours, alpha_channel, alpha, axis=2).astype(np.float32)
    shown = to_uint8(image, alpha_channel)
    expected = [
        [by_hand(c, alpha[y, x]) for c in colours[y, x]] for y in range(20) for x in range(30)
    ]
    expected = np.insert(np.reshape(expected, (20, 30, 3)), alpha_channel, alpha, axis=2) * 255
    np.testing.assert_allclose(shown, expected, atol=0.501)


@pytest.mark.parametrize("alpha", [0, 1, 77, 128, 254, 255])
def test_transparent_colours_come_back(alpha):
    """At alpha 0 they are light without a surface, which EXR files can hold."""
    colours = np.arange(256) if alpha in (0, 255) else np.arange(alpha + 1)
    image = np.stack([colours, np.full_like(colours, alpha)], axis=1).astype(np.uint8)
    np.testing.assert_array_equal(to_uint8(to_linear(image, 1), 1), image)


def test_alpha_is_no_light():
    alpha = np.arange(256, dtype=np.uint8)
    image = np.stack([np.zeros(256, np.uint8), alpha], axis=1)
    linear = to_linear(image, 1)
    np.testing.assert_allclose(linear[:, 1], alpha / 255, rtol=1e-6)
    np.testing.assert_array_equal(to_uint8(linear, 1)[:, 1], alpha)


def test_another_depth_is_refused_by_name():
    with pytest.raises(InputError, match="image has dtype int64; it must be") as refusal:
        to_uint8(np.zeros((2, 2), np.int64))
    assert refusal.value.parameter == "image"
