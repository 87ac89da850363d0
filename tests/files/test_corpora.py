"""Every file under a folder of public images: refused in one sentence, or read as others read it.

``STYLIT_CORPORA`` names the folder: for instance openexr-images, OpenImageIO-images and what
image-rs is tested with. Damaged files are among them. Whatever is odd about a file is noted. The
counts are printed at the end.
"""

import logging
import os
import signal
from collections import Counter
from pathlib import Path

import numpy as np
import OpenImageIO as oiio
import pytest
from files.other_readers import seen_by_openexr, seen_by_pillow, seen_by_tifffile
from PIL import Image

from stylit_ref import InputError
from stylit_ref.files.layers.contents import contents_of
from stylit_ref.files.picture import read_picture
from stylit_ref.files.read_image import displayed

FOLDER = os.environ.get("STYLIT_CORPORA")
FILES = sorted(file for file in Path(FOLDER or "").rglob("*") if FOLDER and file.is_file())

DIFFER = {
    "bmp_v5_with_icc.ico": "OpenImageIO overlooks the order of the channels that the header gives",
    "V5_A8_R8_G8_B8_Rgb.bmp": "OpenImageIO takes a byte for alpha that Pillow leaves out",
    "V5_A8_R8_G8_B8_Rgb_BadMask.bmp": "the same",
    "rletopdown.bmp": "OpenImageIO reads compressed rows from below, which a header may not allow",
    "pal8badindex.bmp": "a colour that the palette has not; Pillow shows another one",
    "oob.gif": "a frame beyond the screen; Pillow enlarges the picture",
    "issue_1455_oversized.gif": "the same",
    "dds_bc3nm.dds": "a normal of two channels, whose third OpenImageIO computes",
    "dds_bc5.dds": "two channels; Pillow adds a third one",
    "strike.tif": "multiplied by alpha in the file; dividing and multiplying loses up to 5",
    "psd_123.psd": "Photoshop mixes the colours with white by alpha; Pillow leaves them so",
    "psd_indexed_trans.psd": "the same",
    "psd_bitmap.psd": "1 is black in bitmaps of Photoshop; Pillow shows it white",
    "gif_animation.gif": "what the first frame leaves open; Pillow shows the background there",
    "gif_test_disposal_method.gif": "the same",
    "border_touching_layers.gif": "the same",
    "issue_1455_undersized.gif": "the same",
    "tbbn0g04.png": "a grey that is transparent, of 4 bits; Pillow looks for it among 8 bits",
    "b5-attrib.tga": "one bit of attributes, which is no alpha as OpenImageIO has it",
    "multiple_entries_with_different_bit_depth.ico": "of two of one size the one of more colours",
    "sky.jpg": "light beyond white, which its gain map adds; Pillow shows the picture without it",
    "dds_bc6hu_hdr.dds": "light beyond white, which Pillow cuts off",
    "clusterfuzz-testcase-minimized-fuzzer_script_tiff-5026894169374720.tif": "damaged",
}
"""By name, why a file is read in another way than others read it."""

READERS = {seen_by_tifffile: 1e-6, seen_by_openexr: 0, seen_by_pillow: 3.5 / 255}
"""Other readers, and the largest difference from each.

Pillow has 8 bits alone, and decoders of JPEG and of compressed textures round each in its own way.
"""

SRGB = 0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290


def seen_elsewhere(file):
    """The image as the first of the others has it that can read the file, and what may differ."""
    for reader, tolerance in READERS.items():
        try:
            seen = reader(file)
        except Exception:  # each knows few kinds of files, and raises what it likes
            continue
        if seen is not None:
            return seen, tolerance
    return None, None


def in_colour(pixels):
    """Grey spread to three channels, and an alpha added where there is none."""
    height, width, channels = pixels.shape
    colours = pixels if channels in (1, 3) else pixels[:, :, :-1]
    alpha = np.ones((height, width, 1)) if channels in (1, 3) else pixels[:, :, -1:]
    colours = np.concatenate([colours] * 3, axis=2) if colours.shape[2] == 1 else colours
    return np.concatenate([colours, alpha], axis=2)


def difference(image, seen):
    """The largest, relative to what is white; or the shapes that differ."""
    if image.dtype != np.float32:
        image = image / np.iinfo(image.dtype).max
    image, seen = in_colour(image), in_colour(seen)
    if image.shape != seen.shape:
        return image.shape, seen.shape
    return float(np.max(np.abs(image - seen) / np.maximum(1, np.abs(seen))))


def oddities(file, picture):
    """What is to be noted, as the header and other libraries tell."""
    image = oiio.ImageInput.open(str(file))
    spec = image.spec()
    shared = oiio.intersection(spec.roi, spec.roi_full)
    primaries = spec.getattribute("chromaticities")
    pixels, alpha = picture.pixels, "".join(spec.channelnames).find("A")
    found = {
        "lies outside its display window": shared.width <= 0 or shared.height <= 0,
        "what lies outside its display window": shared != spec.roi,
        "other primaries": primaries and not np.allclose(primaries, SRGB, atol=2e-3),
        "turned upright": spec.get_int_attribute("Orientation", 1) > 1,
        "holds several images": has_frames(file),
        "are clipped": pixels.dtype == np.float32
        and ((picture.colours > 1.01) | (picture.colours < -0.01)).any(),
        "transparent everywhere": "A" in contents_of(file).layers[0].roles
        and not image.read_image(0, 0, alpha, alpha + 1, "float").any(),
    }
    if found["lies outside its display window"]:
        found["what lies outside its display window"] = False
    return {name for name, is_so in found.items() if is_so}


def has_frames(file):
    """By Pillow; the smaller copies of a texture and the layers of Photoshop are no frames."""
    try:
        with Image.open(file) as opened:
            if opened.format == "ICO":
                return len(opened.ico.entry) > 1
            return getattr(opened, "n_frames", 1) > 1 and file.suffix not in (".tx", ".psd")
    except Exception:
        return False


def outcome(file):
    """The picture and no sentence, or no picture and the sentence of the refusal."""
    try:
        return read_picture(file), None
    except InputError as refused:
        return None, str(refused)


@pytest.fixture(autouse=True)
def _no_file_hangs():
    def ended(*_):
        raise TimeoutError

    before = signal.signal(signal.SIGALRM, ended)
    signal.alarm(60)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


@pytest.fixture(scope="module")
def counts(request):
    """How many files were read, refused, noted, compared and differ; printed at the end."""
    counted = Counter()
    yield counted
    with request.config.pluginmanager.getplugin("capturemanager").global_and_fixture_disabled():
        print("\n" + ", ".join(f"{name} {number}" for name, number in sorted(counted.items())))


@pytest.mark.skipif(not FOLDER, reason="STYLIT_CORPORA names no folder of public images")
@pytest.mark.slow
@pytest.mark.parametrize("file", FILES, ids=lambda file: str(file.relative_to(FOLDER)))
def test_a_public_file_is_refused_or_read_as_others_read_it(file, caplog, counts):
    caplog.set_level(logging.INFO, logger="stylit_ref")
    picture, sentence = outcome(file)
    if sentence is not None:
        counts["refused"] += 1
        assert sentence.startswith(str(file))
        assert "\n" not in sentence
        return
    counts["read"] += 1
    image = picture.pixels
    assert image.size
    assert image.dtype in (np.uint8, np.uint16, np.float32)
    displayed(file, picture)
    notes = caplog.messages
    counts["noted"] += bool(notes)
    odd = oddities(file, picture)
    assert len(notes) == len(odd)
    assert all(any(each in note for note in notes) for each in odd)
    seen, tolerance = seen_elsewhere(file)
    if seen is None:
        return
    counts["compared"] += 1
    found = difference(image, seen)
    differs = not isinstance(found, float) or found > tolerance
    counts["differing"] += differs
    assert differs == (file.name in DIFFER), found
