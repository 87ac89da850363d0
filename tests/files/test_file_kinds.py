"""The table of file kinds in ``docs/alpha_and_colour.md``."""

import re
from pathlib import Path

import numpy as np
import OpenImageIO as oiio
import pytest
from dds_file import write_dds_of_light
from icc_profile import icc_profile
from PIL import Image
from psd_file import write_psd

from stylit_ref import InputError, read_image, write_image
from stylit_ref.files.colour.alpha import multiplied_by_alpha
from stylit_ref.files.colour.profile import ColourProfile, differences, read_colour_profile
from stylit_ref.files.picture import read_picture

PAGE = Path(__file__).parents[2] / "docs" / "alpha_and_colour.md"
COLUMNS = "grey", "colour", "alpha", "16 bits", "floating point", "colour space", "layers"
ROWS = re.findall(r"^\| .* \(`\.(\w+)`\) \|(.*)\|$", PAGE.read_text(encoding="utf-8"), re.MULTILINE)

ICC = icc_profile()
PROFILES = {
    "ICC": {"icc": ICC},
    "CICP": {"cicp": (9, 16, 0, 1)},
    "gamma": {"gamma": 1.8},
    "primaries": {"primaries": (0.68, 0.32, 0.265, 0.69, 0.15, 0.06, 0.3127, 0.329)},
}


def random_image(channels, alphas=range(256)):
    """64 squares of a colour each, which a palette can hold; colours multiplied by alpha."""
    random = np.random.default_rng(0)
    squares = random.integers(0, 256, (8, 8, channels), np.uint8)
    if channels == 4:
        squares[:, :, 3] = random.choice(np.uint8(alphas), (8, 8))
        squares = multiplied_by_alpha(squares)
    return np.roll(squares.repeat(8, 0).repeat(8, 1), 4, (0, 1))  # not in step with JPEG's blocks


def as_the_kind_has_it(file, image):
    """Light where a kind holds nothing else."""
    return (image / 255).astype(np.float32) if file.suffix in (".exr", ".hdr", ".pfm") else image


def write_elsewhere(file, image):
    """Write an image with another program, if that can write such a file."""
    file.unlink(missing_ok=True)
    if file.suffix in (".pfm", ".ppm"):  # it writes one under the name of the other
        return
    if image.shape[2] == 4:
        divisor = np.maximum(image[:, :, 3:], 1) / np.float64(255)
        colours = np.minimum(np.rint(image[:, :, :3] / divisor), 255)
        image = np.dstack([colours, image[:, :, 3]]).astype(image.dtype)
    if file.suffix == ".psd":
        write_psd(file, image, icc=ICC)
    elif file.suffix == ".dds" and image.dtype == np.float32:
        write_dds_of_light(file, image)
    elif file.suffix in (".gif", ".dds"):
        write_with_pillow(file, image)
    else:
        write_with_openimageio(file, image)


def write_with_pillow(file, image):
    if image.dtype == np.uint8:
        Image.fromarray(image.squeeze()).save(file)
        if file.suffix == ".dds" and image.shape[2] == 1:  # Pillow says the wrong bits
            content = file.read_bytes()
            file.write_bytes(content[:92] + b"\xff\0\0\0" + content[96:])


def write_with_openimageio(file, image):
    depth = str(image.dtype).replace("float32", "float")
    output = oiio.ImageOutput.create(str(file))
    if output.open(str(file), oiio.ImageSpec(64, 64, image.shape[2], depth)):
        output.write_image(image)
    output.close()
    output.geterror()


def again(file, image):
    """How a file shows an image: as it is, ``nearly`` so, or as another kind of image."""
    try:
        read = read_image(file)
    except InputError:
        return "no"
    if read.dtype != image.dtype or read.shape != image.shape:
        return "no"
    largest = 1 if image.dtype == np.float32 else np.iinfo(image.dtype).max
    if np.abs(read.astype(float) - image).mean() > largest / 100:
        return "no"
    return "yes" if np.array_equal(read, image) else "nearly"


def keeps(file, image):
    """What becomes of an image; ``read`` if other programs alone can write it."""
    try:
        write_image(file, image, curve="none")
    except InputError:
        found = "no"
    else:
        found = again(file, image)
    if found == "no":
        write_elsewhere(file, image)
        found = "no" if again(file, image) == "no" else "read"
    return found


def keeps_alpha(file):
    found = [
        keeps(file, as_the_kind_has_it(file, random_image(4, alphas)))
        for alphas in (range(256), (0, 255))
    ]
    return f"{found[1]}, on or off" if found[0] == "no" != found[1] else found[0]


def colour_space(file):
    """How values are taken where a file says nothing else, and what else it can say."""
    image, kept = as_the_kind_has_it(file, random_image(3)), []
    if keeps(file, image) == "read":
        kept = ["ICC"] if read_colour_profile(file).icc == ICC else []
    else:
        for name, said in PROFILES.items():
            profile = ColourProfile(of_light=image.dtype == np.float32, **said)
            write_image(file, image, profile=profile, curve="none")
            if not differences(profile, read_colour_profile(file)):
                kept.append(name)
        write_image(file, image, curve="none")
    picture = read_picture(file)
    is_light = picture.pixels.dtype == np.float32 and picture.is_light
    return ", ".join(["light" if is_light else "sRGB", *kept])


def layers(file):
    """Which of two images are read, the second the larger one of an icon."""
    images = random_image(3), random_image(3)[::-1].copy()
    if file.suffix == ".ico":
        images = images[0][:32, :32].copy(), images[1]
    images = [as_the_kind_has_it(file, image) for image in images]
    if not write_two(file, images):
        return "no"
    try:
        assert again(f"{file}:two", images[1]) == again(file, images[0]) == "yes"
    except AssertionError:
        return {"yes": "the first", "no": "the largest"}[again(file, images[0])]
    return "by name"


def write_two(file, images):
    """Write two images into one file, if it can have them."""
    file.unlink(missing_ok=True)
    if file.suffix == ".psd":
        write_psd(file, images[0], {"two": images[1]})
        return True
    output = oiio.ImageOutput.create(str(file))
    if output is None or not output.supports("multiimage"):
        oiio.geterror()
        return False
    depth = str(images[0].dtype).replace("float32", "float")
    specs = [oiio.ImageSpec(*image.shape[1::-1], 3, depth) for image in images]
    for name, spec in zip(("one", "two"), specs, strict=True):
        spec.attribute("oiio:subimagename", name)
    assert output.open(str(file), tuple(specs))
    assert output.write_image(images[0])
    assert output.open(str(file), specs[1], "AppendSubimage")
    assert output.write_image(images[1])
    return output.close()


def found(file):
    """The cells of a row: 8 bits where a kind has them, else what it has."""
    return {
        "grey": keeps(file, as_the_kind_has_it(file, random_image(1))),
        "colour": keeps(file, as_the_kind_has_it(file, random_image(3))),
        "alpha": keeps_alpha(file),
        "16 bits": keeps(file, random_image(3).astype(np.uint16) * 257),
        "floating point": keeps(file, (random_image(3) / 255).astype(np.float32)),
        "colour space": colour_space(file),
        "layers": layers(file),
    }


@pytest.mark.parametrize(("suffix", "cells"), ROWS, ids=[suffix for suffix, _ in ROWS])
def test_a_kind_keeps_what_the_page_says(tmp_path, suffix, cells):
    said = dict(zip(COLUMNS, (cell.strip() for cell in cells.split("|")), strict=True))
    assert found(tmp_path / f"image.{suffix}") == said


def test_the_page_has_the_kinds_that_people_use():
    kinds = {suffix for suffix, _ in ROWS}
    assert {"png", "tif", "jpg", "webp", "exr", "hdr", "bmp", "tga", "psd", "gif"} <= kinds
