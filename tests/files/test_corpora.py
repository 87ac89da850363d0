"""Every file under a folder of public images: refused in one sentence, or read as Pillow reads it.

``STYLIT_CORPORA`` names the folder: for instance openexr-images, OpenImageIO-images and what
image-rs is tested with. Damaged files are among them.
"""

import os
import signal
import warnings
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageOps

from stylit_ref import InputError, read_image

FOLDER = os.environ.get("STYLIT_CORPORA")
FILES = sorted(file for file in Path(FOLDER or "").rglob("*") if FOLDER and file.is_file())

DIFFER = {
    "bmp_v5_with_icc.ico": "OpenImageIO overlooks the order of the channels that the header gives",
    "V5_A8_R8_G8_B8_Rgb.bmp": "OpenImageIO takes a byte for alpha that Pillow leaves out",
    "V5_A8_R8_G8_B8_Rgb_BadMask.bmp": "the same",
    "rletopdown.bmp": "OpenImageIO reads compressed rows from below, which a header may not allow",
    "pal8badindex.bmp": "a colour that the palette has not; Pillow shows another one",
    "oiio.ico": "the first of several sizes; Pillow takes the largest",
    "multiple_entries_with_different_bit_depth.ico": "the same",
    "oob.gif": "a frame beyond the screen; Pillow enlarges the picture",
    "issue_1455_oversized.gif": "the same",
    "dds_bc3nm.dds": "a normal of two channels, whose third OpenImageIO computes",
    "dds_bc5.dds": "two channels; Pillow adds a third one",
    "strike.tif": "multiplied by alpha in the file; dividing and multiplying loses up to 5",
    "psd_123.psd": "Photoshop mixes the colours with white by alpha; Pillow leaves them so",
    "psd_indexed_trans.psd": "the same",
    "psd_bitmap.psd": "black and white are exchanged in one of the two libraries",
    "gif_animation.gif": "what the first frame leaves open; Pillow shows the background there",
    "gif_test_disposal_method.gif": "the same",
    "border_touching_layers.gif": "the same",
    "issue_1455_undersized.gif": "the same",
    "tbbn0g04.png": "a grey that is transparent, of 4 bits; Pillow looks for it among 8 bits",
    "b5-attrib.tga": "one bit of attributes, which is no alpha as OpenImageIO has it",
    "clusterfuzz-testcase-minimized-fuzzer_script_tiff-5026894169374720.tif": "damaged",
}
"""By name, why a file is read in another way than Pillow reads it."""

LARGEST_DIFFERENCE = 3
"""Decoders of JPEG and of compressed textures round each in its own way."""


def seen_by_pillow(file):
    """The first frame as (H, W, n) float, multiplied by alpha; None without 8 bits."""
    try:
        with warnings.catch_warnings(), Image.open(file) as opened:
            warnings.simplefilter("ignore")  # of damaged files
            image = ImageOps.exif_transpose(opened)
            has_key = "transparency" in opened.info
            if image.mode in ("P", "1") or has_key:
                image = image.convert("RGBA" if has_key else "RGB")
            pixels = np.atleast_3d(np.asarray(image)).astype(float)
    except Exception:  # Pillow knows fewer kinds of files, and raises what it likes
        return None
    if image.mode not in ("L", "LA", "RGB", "RGBA"):
        return None
    if pixels.shape[2] in (1, 3):
        return pixels
    alpha = pixels[:, :, -1:]
    if (alpha == 255).all() or (alpha == 0).all():
        return pixels[:, :, :-1]
    return np.concatenate([pixels[:, :, :-1] * alpha / 255, alpha], axis=2)


def in_colour(pixels):
    """Grey with or without alpha, spread to three channels."""
    return np.concatenate([pixels[:, :, :1]] * 3 + [pixels[:, :, 1:]], axis=2)


@pytest.fixture(autouse=True)
def _no_file_hangs():
    def ended(*_):
        raise TimeoutError

    before = signal.signal(signal.SIGALRM, ended)
    signal.alarm(60)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


def outcome(file):
    """The image and no sentence, or no image and the sentence of the refusal."""
    try:
        return read_image(file), None
    except InputError as refused:
        return None, str(refused)


@pytest.mark.skipif(not FOLDER, reason="STYLIT_CORPORA names no folder of public images")
@pytest.mark.slow
@pytest.mark.parametrize("file", FILES, ids=lambda file: str(file.relative_to(FOLDER)))
def test_a_public_file_is_refused_or_read_as_pillow_reads_it(file):
    image, sentence = outcome(file)
    if sentence is not None:
        assert sentence.startswith(str(file))
        assert "\n" not in sentence
        return
    assert image.size
    assert image.dtype in (np.uint8, np.uint16, np.float32)
    seen = seen_by_pillow(file) if image.dtype == np.uint8 else None
    if seen is None or file.name in DIFFER:
        return
    if image.shape[2] < seen.shape[2]:
        image = in_colour(image)
    elif seen.shape[2] < image.shape[2]:
        seen = in_colour(seen)
    assert image.shape == seen.shape
    assert np.abs(image - seen).max() <= LARGEST_DIFFERENCE
