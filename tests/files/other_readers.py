"""Images as other libraries read them: (H, W, n) floats, 1 is white, multiplied by alpha."""

import warnings

import numpy as np
import OpenEXR
import tifffile
from PIL import Image, ImageOps


def seen_by_tifffile(file):
    """The first page; None where tifffile needs another library, or colours have to be computed."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of damaged files
        with tifffile.TiffFile(file) as opened:
            page = opened.pages[0]
            kind, pixels = page.photometric.name, page.asarray()
            if "Orientation" in page.tags and page.tags["Orientation"].value != 1:
                return None
            if kind not in ("MINISBLACK", "MINISWHITE", "RGB", "PALETTE"):
                return None
            if pixels.ndim == 3 and page.planarconfig.name == "SEPARATE":
                pixels = np.moveaxis(pixels, 0, 2)
            if kind == "PALETTE":
                colours = page.colormap.T.astype(int) * 255 // 65535  # as libtiff rounds
                pixels = colours.astype(np.uint8)[pixels]
            pixels = _from_0_to_1(np.atleast_3d(pixels))
            if pixels is None or page.bitspersample not in (1, 8, 16, 32, 64):
                return None
            pixels = 1 - pixels if kind == "MINISWHITE" else pixels
            has_straight_alpha = [int(kind) for kind in page.extrasamples] == [2]
            return _multiplied(pixels) if has_straight_alpha else _without_idle_alpha(pixels)


def seen_by_openexr(file):
    """The first part in its display window; None where it is deep, or has neither RGB nor Y."""
    with OpenEXR.File(str(file), separate_channels=True) as opened:
        part = opened.parts[0]
        names = set(part.channels)
        order = next((order for order in ("RGBA", "RGB", "YA", "Y") if set(order) <= names), None)
        if order is None or "deep" in str(part.type()):
            return None
        first, last = part.header["displayWindow"]
        begin, end = part.header["dataWindow"]
        pixels = np.stack([part.channels[name].pixels for name in order], axis=2).astype(np.float32)
        shown = np.zeros((*(last - first + 1)[::-1], len(order)), np.float32)
        inside = np.maximum(begin, first), np.minimum(end, last) + 1
        if (inside[0] < inside[1]).all():
            (x, y), (right, below) = inside
            shown[y - first[1] : below - first[1], x - first[0] : right - first[0]] = pixels[
                y - begin[1] : below - begin[1], x - begin[0] : right - begin[0]
            ]
        return _without_idle_alpha(shown)


def seen_by_pillow(file):
    """The first frame; None where Pillow converts colours in its own way."""
    with warnings.catch_warnings(), Image.open(file) as opened:
        warnings.simplefilter("ignore")
        image = ImageOps.exif_transpose(opened)
        has_key = "transparency" in opened.info
        if image.mode in ("P", "1") or has_key:
            image = image.convert("RGBA" if has_key else "RGB")
        if image.mode not in ("L", "LA", "RGB", "RGBA", "I;16", "I;16B"):
            return None
        return _multiplied(_from_0_to_1(np.atleast_3d(np.asarray(image))))


def _from_0_to_1(pixels):
    if pixels.dtype == bool or np.issubdtype(pixels.dtype, np.floating):
        return pixels.astype(float)
    if pixels.dtype in (np.uint8, np.uint16):
        return pixels / np.iinfo(pixels.dtype).max
    return None


def _multiplied(pixels):
    if pixels.shape[2] in (1, 3):
        return pixels
    colours, alpha = pixels[:, :, :-1], pixels[:, :, -1:]
    idle = (alpha == 0).all()
    return _without_idle_alpha(np.dstack([colours if idle else colours * alpha, alpha]))


def _without_idle_alpha(pixels):
    alpha = pixels[:, :, -1]
    if pixels.shape[2] in (2, 4) and ((alpha >= 1).all() or (alpha <= 0).all()):
        return pixels[:, :, :-1]
    return pixels
