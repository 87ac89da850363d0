"""Colours and alpha, by another library's files and eyes."""

import struct
from itertools import permutations

import numpy as np
import OpenImageIO as oiio
import pytest
from PIL import Image

from stylit_ref import InputError, read_image, write_image
from stylit_ref.files.colour.alpha import divided_by_alpha, multiplied_by_alpha

STRAIGHT = np.array([200, 100, 50, 128], np.uint8)
MULTIPLIED = np.array([100, 50, 25, 128], np.uint8)


@pytest.mark.parametrize("suffix", ["png", "tif", "tga", "bmp", "ico", "webp", "dds", "sgi", "jp2"])
def test_colours_are_multiplied_by_alpha_whoever_wrote_the_file(tmp_path, suffix):
    options = {"webp": {"lossless": True}, "ico": {"sizes": [(6, 4)]}}.get(suffix, {})
    file = tmp_path / f"half.{suffix}"
    Image.fromarray(np.broadcast_to(STRAIGHT, (4, 6, 4)).copy()).save(file, **options)
    np.testing.assert_array_equal(read_image(file), np.broadcast_to(MULTIPLIED, (4, 6, 4)))


@pytest.mark.parametrize("suffix", ["png", "tif", "tga", "ico", "webp", "sgi"])
def test_others_see_the_colours_without_alpha(tmp_path, suffix):
    file = tmp_path / f"half.{suffix}"
    write_image(file, np.broadcast_to(MULTIPLIED, (4, 6, 4)))
    seen = np.asarray(Image.open(file).convert("RGBA"))[0, 0].astype(int)
    assert seen[3] == 128
    assert np.abs(seen - STRAIGHT).max() <= 2  # 8 bits of a half hold no more


@pytest.mark.parametrize("suffix", ["png", "tif", "tga", "bmp", "ico", "webp", "sgi", "jp2", "jxl"])
def test_what_was_written_comes_back(tmp_path, suffix):
    random = np.random.default_rng(0)
    image = multiplied_by_alpha(random.integers(0, 256, (64, 64, 4), np.uint8))
    write_image(tmp_path / f"soft.{suffix}", image)
    np.testing.assert_array_equal(read_image(tmp_path / f"soft.{suffix}"), image)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_division_undoes_multiplication_as_far_as_integers_go(dtype):
    largest = np.iinfo(dtype).max
    values = np.linspace(0, largest, 40).astype(dtype)
    colours, alpha = np.meshgrid(values, values)
    multiplied = multiplied_by_alpha(np.dstack([colours, alpha]))
    exact = np.floor(colours.astype(float) * alpha / largest + 0.5)
    np.testing.assert_array_equal(multiplied[:, :, 0], exact)
    again = multiplied_by_alpha(divided_by_alpha(multiplied))
    np.testing.assert_array_equal(again, multiplied)


def bitmap(masks):
    """A BMP file of 2x2 pixels of 32 bits, the bytes of each 50, 100, 200, 128."""
    header = struct.pack("<IiiHHIIiiII4I", 56, 2, 2, 1, 32, 3, 16, 2835, 2835, 0, 0, *masks)
    pixels = bytes([50, 100, 200, 128] * 4)
    return struct.pack("<2sIHHI", b"BM", 14 + 56 + 16, 0, 0, 14 + 56) + header + pixels


def test_a_bitmap_without_alpha_has_none(tmp_path):
    (tmp_path / "x.bmp").write_bytes(bitmap((0xFF0000, 0xFF00, 0xFF, 0)))
    np.testing.assert_array_equal(
        read_image(tmp_path / "x.bmp"), np.full((2, 2, 3), [200, 100, 50])
    )


def test_a_bitmap_with_alpha_has_it(tmp_path):
    (tmp_path / "a.bmp").write_bytes(bitmap((0xFF0000, 0xFF00, 0xFF, 0xFF000000)))
    np.testing.assert_array_equal(read_image(tmp_path / "a.bmp"), np.full((2, 2, 4), MULTIPLIED))


BYTES = {50: 0xFF, 100: 0xFF00, 200: 0xFF0000, 128: 0xFF000000}


@pytest.mark.parametrize("order", list(permutations(BYTES)))
def test_a_bitmap_says_the_order_of_its_channels(tmp_path, order):
    (tmp_path / "r.bmp").write_bytes(bitmap([BYTES[value] for value in order]))
    expected = multiplied_by_alpha(np.full((2, 2, 4), order, np.uint8))
    np.testing.assert_array_equal(read_image(tmp_path / "r.bmp"), expected)
    (tmp_path / "x.bmp").write_bytes(bitmap([*(BYTES[value] for value in order[:3]), 0]))
    np.testing.assert_array_equal(read_image(tmp_path / "x.bmp"), np.full((2, 2, 3), order[:3]))


def test_a_bitmap_whose_channels_are_no_bytes_is_refused(tmp_path):
    (tmp_path / "r.bmp").write_bytes(bitmap((0x3FF00000, 0xFFC00, 0x3FF, 0)))
    with pytest.raises(InputError, match=r"r\.bmp: has channels of other than 8 bits; save it as"):
        read_image(tmp_path / "r.bmp")


@pytest.mark.parametrize("suffix", ["bmp", "tga", "png"])
def test_a_file_is_opened_for_its_header_and_for_its_pixels(tmp_path, monkeypatch, suffix):
    """Some formats decode the whole image each time."""
    write_image(tmp_path / f"a.{suffix}", np.full((8, 8, 4), MULTIPLIED, np.uint8))
    opened, opens = [], oiio.ImageInput.open
    monkeypatch.setattr(oiio.ImageInput, "open", lambda *of: opened.append(of) or opens(*of))
    read_image(tmp_path / f"a.{suffix}")
    assert len(opened) == 2
