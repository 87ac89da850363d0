"""Halves, copies, interpolated pixels and records, against NumPy."""

import numpy as np
import pytest

from stylit_ref.realtime.passes import (
    make_box_records,
    make_extend,
    make_fill,
    make_halve,
    make_mip_records,
    upsample_picture,
)
from stylit_ref.realtime.passes.image import interior, make_image, whole

SIZES = [(1, 1), (1, 6), (7, 1), (8, 6), (9, 13)]


def filled(pixels, border, lanes):
    image = make_image(*pixels.shape[:2], border, lanes)
    make_fill(pixels.shape[2], lanes)(pixels.reshape(-1), image)
    return image


def noise(*shape):
    return np.random.default_rng(1).integers(0, 256, shape, np.uint8)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize(("channels", "lanes"), [(3, 4), (10, 16), (12, 16), (13, 20)])
def test_pixels_are_copied_and_the_border_repeats_them(size, channels, lanes):
    pixels = noise(*size, channels)
    image = filled(pixels, 5, lanes)
    expected = np.pad(pixels, ((5, 5), (5, 5), (0, lanes - channels)), "constant")
    expected[..., :channels] = np.pad(pixels, ((5, 5), (5, 5), (0, 0)), "edge")
    assert np.array_equal(whole(image, lanes), expected)


@pytest.mark.parametrize("size", SIZES)
def test_a_view_that_was_written_to_gets_its_border(size):
    pixels = noise(*size, 4)
    image = make_image(*size, 3, 4)
    interior(image, 4)[:] = pixels
    make_extend(4)(image)
    assert np.array_equal(whole(image, 4), np.pad(pixels, ((3, 3), (3, 3), (0, 0)), "edge"))


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("lanes", [4, 8, 16, 20])
def test_halves_are_means_of_boxes(size, lanes):
    pixels = noise(*size, lanes)
    coarse = make_image(-(-size[0] // 2), -(-size[1] // 2), 4, lanes)
    make_halve(lanes)(filled(pixels, 4, lanes), coarse)
    even = np.pad(pixels, ((0, size[0] % 2), (0, size[1] % 2), (0, 0)), "edge").astype(int)
    total = even[::2, ::2] + even[1::2, ::2] + even[::2, 1::2] + even[1::2, 1::2]
    expected = np.pad((total + 2) >> 2, ((4, 4), (4, 4), (0, 0)), "edge")
    assert np.array_equal(whole(coarse, lanes), expected)


@pytest.mark.parametrize("size", SIZES)
def test_pictures_grow_by_bilinear_interpolation(size):
    coarse = noise(-(-size[0] // 2), -(-size[1] // 2), 4)
    out = make_image(*size, 4, 4)
    upsample_picture(filled(coarse, 4, 4), out)
    padded = np.pad(coarse, ((1, 1), (1, 1), (0, 0)), "edge").astype(int)
    expected = np.zeros((*size, 4), int)
    for y, x in np.ndindex(size):
        y0, x0 = y // 2 + 1, x // 2 + 1
        y1, x1 = y0 + (1 if y % 2 else -1), x0 + (1 if x % 2 else -1)
        expected[y, x] = (
            9 * padded[y0, x0] + 3 * padded[y0, x1] + 3 * padded[y1, x0] + padded[y1, x1] + 8
        ) >> 4
    assert np.array_equal(interior(out, 4), expected)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("step", [1, 3])
@pytest.mark.parametrize("depth", [1, 3, 4])
def test_records_of_boxes(size, step, depth):
    pixels = noise(*size, 4)
    records = make_image(-(-size[0] // step), -(-size[1] // step), 0, 4 * depth)
    make_box_records(4, depth)(filled(pixels, 13, 4), step, records)
    padded = np.pad(pixels, ((13, 13), (13, 13), (0, 0)), "edge").astype(int)
    for a, b in np.ndindex(records.height, records.width):
        y, x = a * step + 13, b * step + 13
        for scale in range(depth):
            r = (3**scale - 1) // 2
            box = padded[y - r : y + r + 1, x - r : x + r + 1].reshape(-1, 4)
            mean = (box.sum(0) + len(box) // 2) // len(box)
            record = interior(records, 4 * depth)[a, b]
            assert np.array_equal(record[4 * scale : 4 * scale + 4], mean)


def test_records_of_texels():
    fine, coarse = noise(9, 7, 4), noise(5, 4, 4)
    records = make_image(3, 3, 0, 8)
    make_mip_records(4, 2)(filled(fine, 2, 4), 0, 3, records)
    make_mip_records(4, 2)(filled(coarse, 2, 4), 1, 3, records)
    for a, b in np.ndindex(3, 3):
        record = interior(records, 8)[a, b]
        assert np.array_equal(record[:4], fine[3 * a, 3 * b])
        assert np.array_equal(record[4:], coarse[3 * a // 2, 3 * b // 2])
