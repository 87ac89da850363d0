"""Read the pixels of a layer, and nothing else of its file."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.colour.alpha import OURS_TO_MULTIPLY, multiplied_by_alpha
from stylit_ref.files.disk.image_file import check_size, open_image, read_pixels, reason_of
from stylit_ref.files.layers.layer import Layer
from stylit_ref.files.layers.oddities import note_oddities

_DEPTHS = {"uint8": "uint8", "uint16": "uint16"} | dict.fromkeys(
    ("half", "float", "double"), "float"
)


def read_layer(
    path: str | Path,
    file: Path,
    layer: Layer,
    *,
    straight: bool = False,
    is_guide: bool = False,
) -> NDArray[np.uint8 | np.uint16 | np.uint32 | np.float32]:
    """Read the pixels of a layer, upright and in the display window.

    Parameters
    ----------
    path : str or Path
        The file and layer as the user wrote them.
    file : Path
    layer : Layer
    straight : bool
        As of :func:`~stylit_ref.files.disk.image_file.open_image`.
    is_guide : bool
        Whether data may be infinite, as the depth of a pixel where nothing is, and a channel of
        32-bit integers is read as labels.

    Returns
    -------
    (H, W, n) uint8, uint16 or float32, or labels uint32
        Pixels outside the data window are 0.

    Raises
    ------
    InputError
        If it cannot be read, is too large, or holds NaN or infinity.
    """
    is_straight = straight or layer.file_format in OURS_TO_MULTIPLY
    source = open_image(file, straight=is_straight)
    source.seek_subimage(layer.part, 0)
    spec = source.spec()
    if layer.is_deep:  # OpenImageIO would return pixels that it did not fill
        raise InputError(
            f"{path}: holds deep pixels; flatten it first: oiiotool {file} --flatten -o flat.exr"
        )
    check_size(file, spec, len(layer.numbers))
    is_data_of_guide = is_guide and not layer.is_light
    depth = _depth(path, layer, is_data_of_guide)
    pixels = read_pixels(source, layer.part, layer.numbers, depth)
    if pixels is None:
        raise InputError(f"{file}: cannot be read: {reason_of(source.geterror)}")
    if layer.file_format == "targa":  # the one that can also hold them multiplied
        is_straight = spec.get_int_attribute("oiio:UnassociatedAlpha") == 1
    source.close()
    note_oddities(file, spec, layer)
    if spec.roi != spec.roi_full:
        pixels = _in_display_window(pixels, spec)
    pixels = np.ascontiguousarray(_upright(pixels, spec.get_int_attribute("Orientation")))
    if depth == "float":
        _check_values(path, pixels, is_data_of_guide)
    elif is_straight and not straight and layer.alpha_channel is not None:
        pixels = multiplied_by_alpha(pixels)
    return pixels


def _depth(path, layer, may_be_labels):
    """The type in which the values are read."""
    stored = set(layer.types)
    if may_be_labels and len(layer.numbers) == 1 and stored == {"uint"}:
        return "uint"
    if layer.roles[0] == "INK0":
        raise InputError(f"{path}: holds inks for printing; save it with R, G and B channels")
    if stored == {"uint"} and layer.may_be_labels:
        raise InputError(f"{path}: holds whole numbers of 32 bits, which can be labels of a guide")
    if not stored <= _DEPTHS.keys():
        raise InputError(
            f"{path}: holds {', '.join(sorted(stored))} values; save it with 8-bit or 16-bit "
            "integers, or as floating point"
        )
    return _DEPTHS[stored.pop()] if len(stored) == 1 else "float"


def _check_values(path, pixels, may_be_far):
    broken = ~np.isfinite(pixels)
    if may_be_far:
        broken &= pixels != np.inf
    if broken.any():
        y, x, _ = np.argwhere(broken)[0]
        raise InputError(
            f"{path}: {np.count_nonzero(broken.any(axis=2))} pixels are NaN or infinite, "
            f"the first at (y, x) = ({y}, {x}); all values must be finite"
        )


def _in_display_window(pixels, spec):
    """The pixels of the display window; those outside the data window are 0."""
    shown = np.zeros((spec.full_height, spec.full_width, pixels.shape[2]), pixels.dtype)
    y, x = spec.y - spec.full_y, spec.x - spec.full_x
    window, pixels = shown[max(y, 0) :, max(x, 0) :], pixels[max(-y, 0) :, max(-x, 0) :]
    height, width = map(min, window.shape[:2], pixels.shape[:2])
    window[:height, :width] = pixels[:height, :width]
    return shown


def _upright(pixels, orientation):
    """Turn pixels upright that are stored in one of the eight orientations of TIFF and Exif."""
    if orientation in (5, 6, 7, 8):
        pixels = pixels.swapaxes(0, 1)
    down = -1 if orientation in (3, 4, 7, 8) else 1
    right = -1 if orientation in (2, 3, 6, 7) else 1
    return pixels[::down, ::right]
