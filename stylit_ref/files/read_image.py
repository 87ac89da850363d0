"""Read images with OpenImageIO: PNG, TIFF, JPEG, (multilayer) EXR, ...

Files are read at their own depth or converted to 8 bits (:mod:`stylit_ref.files.bit_depth`).
An alpha channel that is opaque everywhere is dropped, and so is one that is 0 everywhere, which
renderers and game tools leave empty. Otherwise OpenImageIO premultiplies the colours by it, so that
averages of transparent pixels come out right.
"""

import logging
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.bit_depth import to_uint8
from stylit_ref.files.image_file import open_image, read_pixels, reason_of
from stylit_ref.files.layers import find_layer, split_channel, split_layer
from stylit_ref.notes import note

_DEPTHS = {"uint8": "uint8", "uint16": "uint16"} | dict.fromkeys(
    ("half", "float", "double"), "float"
)


def read_image(path: str | Path) -> NDArray[np.uint8 | np.uint16 | np.float32]:
    """Read an image at its own depth.

    Parameters
    ----------
    path : str or Path
        A file, or ``file:LAYER`` for a layer of a multilayer EXR: channels named
        ``LAYER.R`` and so on, or a part of that name.

    Returns
    -------
    (H, W, n) uint8, uint16 or float32
        The display window; pixels outside the data window are 0.

    Raises
    ------
    InputError
        If the file or layer is missing, cannot be read, declares more than
        :data:`~stylit_ref.files.image_file.LARGEST_IMAGE` values, or holds NaN or infinity.
    """
    return _read(path)[0]


def read_uint8(path: str | Path) -> NDArray[np.uint8]:
    """Read an image as 8-bit display values.

    Parameters and errors are those of :func:`read_image`.

    Returns
    -------
    (H, W, n) uint8
    """
    return _displayed(path)[0]


def read_guides(
    source_path: str | Path, target_path: str | Path
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Read a guide of the source and of the target so that their channels agree.

    Alpha is dropped if it is opaque in both images and otherwise kept, or added, in
    both; a grey image beside one in colour is spread to three channels.

    Parameters and errors are those of :func:`read_image`.

    Returns
    -------
    source, target : (H, W, n) uint8
        Their numbers of channels still differ if neither image is grey and the files differ.
    """
    read = list(map(_displayed, (source_path, target_path)))
    transparent = any(alpha is not None for _, alpha in read)
    colours = max(guide.shape[2] - (alpha is not None) for guide, alpha in read)
    guides = []
    for guide, alpha in read:
        if guide.shape[2] - (alpha is not None) == 1:
            guide = np.concatenate([guide[:, :, :1]] * colours + [guide[:, :, 1:]], axis=2)
        if transparent and alpha is None:
            opaque = np.full((*guide.shape[:2], 1), 255, np.uint8)
            guide = np.concatenate([guide, opaque], axis=2)
        guides.append(guide)
    return tuple(guides)


def read_mask(path: str | Path) -> NDArray[np.bool_]:
    """Read an image as a mask: what is white in it.

    Its values are data and go through no curve; the mean of its colours counts. Alpha is no colour:
    what is transparent shows as black.

    Parameters and errors are those of :func:`read_image`.

    Returns
    -------
    (H, W) bool
        Where the image is at least half as bright as it can be.
    """
    image, alpha_channel = _read(path)
    half = 0.5 if image.dtype == np.float32 else (np.iinfo(image.dtype).max + 1) // 2
    return _without_alpha(image, alpha_channel).mean(axis=2) >= half


def _read(path):
    """Pixels of a file or layer, and the index of their alpha channel or None."""
    try:
        image, alpha_channel = _read_pixels(path)
        if alpha_channel is None:
            return image, None
        alpha = image[:, :, alpha_channel]
        if (alpha <= 0).all():
            note(f"{path}: is transparent everywhere; its alpha is left out", level=logging.WARNING)
            image, _ = _read_pixels(path, straight=True)
        elif (alpha < (1 if alpha.dtype == np.float32 else np.iinfo(alpha.dtype).max)).any():
            return image, alpha_channel
        return _without_alpha(image, alpha_channel), None
    except UnicodeDecodeError:  # in a channel's name, or in a message that quotes it
        raise InputError(f"{path}: cannot be read: a name in its header is not UTF-8") from None


def _read_pixels(path, straight=False):
    """As :func:`_read`, with alpha whatever it is."""
    file, layer = split_layer(path)
    part, channels = find_layer(file, layer)
    source = open_image(file, straight=straight)
    source.seek_subimage(part, 0)
    spec = source.spec()
    if spec.deep:  # OpenImageIO would return pixels that it did not fill
        raise InputError(
            f"{path}: holds deep pixels; flatten it first: oiiotool {file} --flatten -o flat.exr"
        )
    stored = {str(spec.channelformat(channel)) for channel in channels}
    if not stored <= _DEPTHS.keys():
        raise InputError(
            f"{path}: holds {', '.join(sorted(stored))} values; save it with 8-bit or 16-bit "
            "integers, or as floating point"
        )
    depth = _DEPTHS[str(spec.format)] if len(stored) == 1 else "float"
    image = read_pixels(source, part, depth)
    if image is None:
        raise InputError(f"{file}: cannot be read: {reason_of(source.geterror())}")
    if spec.roi != spec.roi_full:
        image = _in_display_window(image, spec)
    image = np.take(image, channels, axis=2)
    image = np.ascontiguousarray(_upright(image, spec.get_int_attribute("Orientation")))
    if depth == "float" and not np.isfinite(image).all():
        broken = ~np.isfinite(image)
        y, x, _ = np.argwhere(broken)[0]
        raise InputError(
            f"{path}: {np.count_nonzero(broken.any(axis=2))} pixels are NaN or infinite, "
            f"the first at (y, x) = ({y}, {x}); all values must be finite"
        )
    names = [split_channel(spec.channelnames[c])[1] for c in channels]
    alpha_channel = names.index("A") if "A" in names and len(names) > 1 else None
    return image, alpha_channel


def _in_display_window(pixels, spec):
    """The pixels of the display window; those outside the data window are 0."""
    shown = np.zeros((spec.full_height, spec.full_width, spec.nchannels), pixels.dtype)
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


def _without_alpha(image, alpha_channel):
    if alpha_channel is None:
        return image
    return np.ascontiguousarray(np.delete(image, alpha_channel, axis=2))


def _displayed(path):
    """8-bit display values of a file or layer, and the index of their alpha channel or None.

    Warns if the conversion clips more than a few highlights.
    """
    image, alpha_channel = _read(path)
    if image.dtype == np.float32:
        colours = _without_alpha(image, alpha_channel)
        clipped = np.mean((colours < -0.01) | (colours > 1))
        if clipped > 0.05:
            note(
                f"{path}: {clipped:.0%} of the values lie outside [0, 1] and are clipped",
                level=logging.WARNING,
            )
    # Row by row, since a conversion takes much memory.
    rows = [to_uint8(row, alpha_channel, curve="srgb") for row in image]
    return np.stack(rows), alpha_channel
