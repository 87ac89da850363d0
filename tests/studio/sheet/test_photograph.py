"""Photographs as they come: turned, grey, of four inks, transparent, damaged."""

import struct
import zlib
from io import BytesIO

import numpy as np
import pytest
from PIL import Image

from stylit_ref import InputError
from stylit_ref.studio.sheet.photograph import read_photograph

COLOURS = np.repeat(
    np.array([[(200, 30, 40), (30, 160, 50)], [(40, 60, 190), (240, 240, 235)]], np.uint8), 16, 0
).repeat(16, axis=1)


def stored(image, kind="PNG", **how):
    file = BytesIO()
    image.save(file, kind, **how)
    return file.getvalue()


@pytest.mark.parametrize(
    ("orientation", "turned"),
    [
        (1, lambda image: image), (2, np.fliplr), (3, lambda image: np.rot90(image, 2)),
        (6, lambda image: np.rot90(image, 1)), (8, lambda image: np.rot90(image, -1)),
    ],
)  # fmt: skip
def test_the_orientation_is_heeded(orientation, turned):
    """The camera was turned the other way, and its EXIF says so."""
    exif = Image.Exif()
    exif[0x0112] = orientation
    image = Image.fromarray(np.ascontiguousarray(turned(COLOURS)))
    assert np.array_equal(read_photograph(stored(image, exif=exif)), COLOURS)


@pytest.mark.parametrize("mode", ["L", "LA", "P", "RGBA", "1"])
def test_every_kind_of_pixel_becomes_rgb(mode):
    image = Image.fromarray(COLOURS).convert(mode)
    assert np.array_equal(read_photograph(stored(image)), np.asarray(image.convert("RGB")))


def test_four_inks_become_rgb():
    image = Image.fromarray(COLOURS).convert("CMYK")
    read = read_photograph(stored(image, "JPEG", quality=98)).astype(int)
    assert np.abs(read - COLOURS)[4:12, 4:12].max() < 8


def test_paper_shows_through_what_is_transparent():
    image = Image.new("RGBA", (8, 8), (255, 0, 0, 0))
    assert (read_photograph(stored(image)) == 255).all()


def test_sixteen_bits_become_eight():
    deep = Image.fromarray(np.array([[0, 257 * 7, 65535]], np.uint16))
    assert read_photograph(stored(deep)).tolist() == [[[0] * 3, [7] * 3, [255] * 3]]


def test_a_file_is_read_by_its_name(tmp_path):
    (tmp_path / "a.png").write_bytes(stored(Image.fromarray(COLOURS)))
    assert np.array_equal(read_photograph(tmp_path / "a.png"), COLOURS)


def a_png_that_declares(width, height):
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(
            ">I", zlib.crc32(kind + content)
        )  # fmt: skip

    header = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + header + chunk(b"IDAT", zlib.compress(b"")) + chunk(b"IEND", b"")


@pytest.mark.filterwarnings("ignore::PIL.Image.DecompressionBombWarning")
@pytest.mark.parametrize(
    ("content", "what"),
    [
        (b"", "no image of a kind that can be read; save it as .jpg"),
        (b"GIF89a and no more", "the photograph"),
        (stored(Image.fromarray(COLOURS), "JPEG")[:400], "cannot be read"),
        (stored(Image.fromarray(COLOURS))[:60], "cannot be read"),
        (a_png_that_declares(20_000, 6_000), "has 20000x6000 pixels; make it smaller"),
        (a_png_that_declares(60_000, 60_000), "too many pixels; make it smaller"),
        (stored(Image.fromarray(np.ones((4, 4), np.float32)), "TIFF"), "more than 8 bits"),
    ],
    ids=["empty", "GIF", "JPEG", "PNG", "large", "huge", "float"],
)
def test_what_cannot_be_read_is_refused_in_a_sentence(content, what):
    with pytest.raises(InputError, match=what) as refused:
        read_photograph(content)
    assert "\n" not in str(refused.value)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(InputError, match=r"no\.jpg: cannot be read"):
        read_photograph(tmp_path / "no.jpg")
