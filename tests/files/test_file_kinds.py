"""The table of file kinds in ``docs/alpha_and_colour.md``."""

import re
from pathlib import Path

import numpy as np
import pytest
from icc_profile import icc_profile

from stylit_ref import InputError, read_image, write_image
from stylit_ref.files.colour.alpha import multiplied_by_alpha
from stylit_ref.files.colour.profile import ColourProfile, read_colour_profile

PAGE = Path(__file__).parents[2] / "docs" / "alpha_and_colour.md"
COLUMNS = "grey", "colour", "alpha", "16 bits", "floating point", "ICC profile"
ROWS = re.findall(r"^\| .* \(`\.(\w+)`\) \|(.*)\|$", PAGE.read_text(encoding="utf-8"), re.MULTILINE)


def random_image(channels):
    image = np.random.default_rng(0).integers(0, 256, (64, 64, channels), np.uint8)
    return multiplied_by_alpha(image) if channels == 4 else image


def keeps(file, image):
    """``yes``; or that it differs, has fewer bits or is not written."""
    try:
        write_image(file, image, curve="none")
    except InputError:
        return "no"
    again = read_image(file)
    if again.dtype != image.dtype or again.shape != image.shape:
        return "no"
    return "yes" if np.array_equal(again, image) else "nearly"


def keeps_profile(file):
    profile = ColourProfile(of_light=False, icc=icc_profile(), icc_name="Red is green")
    write_image(file, random_image(3), profile=profile, curve="none")
    return "yes" if read_colour_profile(file).icc == profile.icc else "no"


def found(file):
    """The cells of a row: 8 bits where a kind has them, else what it has."""
    eight = {channels: random_image(channels) for channels in (1, 3, 4)}
    floats = file.suffix in (".exr", ".hdr", ".pfm")
    images = {
        n: (image / 255).astype(np.float32) if floats else image for n, image in eight.items()
    }
    return {
        "grey": keeps(file, images[1]),
        "colour": keeps(file, images[3]),
        "alpha": keeps(file, images[4]),
        "16 bits": keeps(file, eight[3].astype(np.uint16) * 257),
        "floating point": keeps(file, (eight[3] / 255).astype(np.float32)),
        "ICC profile": keeps_profile(file),
    }


@pytest.mark.parametrize(("suffix", "cells"), ROWS, ids=[suffix for suffix, _ in ROWS])
def test_a_kind_keeps_what_the_page_says(tmp_path, suffix, cells):
    said = dict(zip(COLUMNS, (cell.strip() for cell in cells.split("|")), strict=True))
    assert found(tmp_path / f"image.{suffix}") == said


def test_the_page_has_the_kinds_that_people_use():
    kinds = {suffix for suffix, _ in ROWS}
    assert {"png", "tif", "jpg", "webp", "exr", "hdr", "bmp", "tga"} <= kinds
