"""Write images with OpenImageIO: PNG, TIFF, JPEG, EXR, ..."""

from pathlib import Path

import numpy as np
import OpenImageIO as oiio
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.files.colour.alpha import OURS_TO_DIVIDE, divided_by_alpha
from stylit_ref.files.colour.bit_depth import Curve, to_linear, to_uint8
from stylit_ref.files.colour.profile import (
    ColourProfile,
    add_to_png,
    add_to_spec,
    for_values,
    note_what_is_lost,
    read_colour_profile,
)
from stylit_ref.files.disk.image_file import read_pixels, reason_of
from stylit_ref.files.disk.paths import check_writable, nearest_folder, real_path
from stylit_ref.files.disk.whole_file import temporary_name, whole_file

FLOAT_FORMATS = (".exr", ".hdr", ".pfm")
"""Suffixes of formats that store scene-linear floating point."""

_SETTINGS = {
    "jpeg": {"jpeg:subsampling": "4:4:4", "Compression": "jpeg:98"},
    "webp": {"Compression": "lossless"},
    "png": {"png:compressionLevel": 4},
}
"""By format, what OpenImageIO is told. At its defaults thin strokes lose their colour in JPEG and
WebP, and PNG takes half as long again for paintings that become smaller by a hundredth."""


def write_image(
    path: str | Path,
    image: NDArray[np.uint8 | np.uint16 | np.float32],
    *,
    curve: Curve | None = None,
    profile: ColourProfile | None = None,
) -> None:
    """Write an image; a failure leaves no partial file.

    Integers become scene-linear light in a floating-point format. Floating point becomes 8-bit
    display values in an integer format. Otherwise the bit depth is kept if the format has it
    (JPEG has 8 bits only).

    Parameters
    ----------
    path : str or Path
        The suffix names the format.
    image : (H, W) or (H, W, n) uint8, uint16 or float32
        With 2 or 4 channels the last is alpha, and the others are premultiplied by it.
    curve : {"srgb", "none"}, optional
        What floating point goes through on its way to an integer format, as for
        :func:`stylit_ref.to_uint8`.
    profile : ColourProfile, optional
        What the file shall say of its colours; a note says what it cannot. Values stay as they are.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    path = Path(path)
    image = np.ascontiguousarray(as_array(image, f"{path}: the image"))
    image = image[:, :, None] if image.ndim == 2 else image
    if image.ndim != 3 or 0 in image.shape:
        raise InputError(
            f"{path}: the image has shape {image.shape}; it must be (H, W) or (H, W, channels)"
        )
    channels = image.shape[2]
    if image.dtype not in (np.uint8, np.uint16, np.float32):
        raise InputError(
            f"{path}: the image has dtype {image.dtype}; it must be uint8, uint16 or float32"
        )
    check_image_writable(path, channels)
    image, spec = _as_stored(image, path, curve)
    is_png = path.suffix.lower() == ".png"
    told = for_values(profile, str(spec.format) in ("half", "float")) if profile else None
    if told and not is_png:
        add_to_spec(told, spec)
    # Compression may save nothing: allow for uncompressed pixels.
    depth = 4 if str(spec.format) == "float" else image.itemsize
    with whole_file(path, image.size * depth * 9 // 8 + 2**16) as partial:
        output = oiio.ImageOutput.create(str(partial))
        written = output.open(str(partial), spec) and output.write_image(image)
        if not (output.close() and written):
            reason = reason_of(output.geterror, oiio.geterror)
            raise InputError(f"{path}: cannot be written: {reason}")
        if told and is_png:
            add_to_png(told, partial)
        # Some writers report no error when the disk is full or the format lacks this image size.
        if not _reads_back(partial, image.shape):
            raise InputError(f"{path}: cannot be written: the finished file cannot be read")
        if profile:
            note_what_is_lost(profile, path, read_colour_profile(partial))


def check_image_writable(path: str | Path, channels: int, depth: str = "uint8") -> str:
    """Refuse a path that :func:`write_image` could not write, before the work begins.

    Parameters
    ----------
    path : str or Path
    channels : int
    depth : {"uint8", "uint16", "float"}
        The type of the values that are to be written.

    Returns
    -------
    str
        The type of the values that the file would hold.

    Raises
    ------
    InputError
    """
    path = Path(path)
    # Without a suffix OpenImageIO takes a whole name, such as png, for one.
    output = oiio.ImageOutput.create(str(path)) if path.suffix else None
    if output is None or output.format_name() in ("null", "term"):  # these write no file
        oiio.geterror()
        raise InputError(
            f"{path}: no image format has the suffix '{path.suffix}'; use .png, .tif or .exr"
        )
    if output.format_name() == "gif":
        raise InputError(f"{path}: GIF files hold only 256 colours; use .png, .tif or .exr")
    if channels in (2, 4) and not output.supports("alpha"):
        raise InputError(
            f"{path}: {output.format_name()} files cannot store the image's transparency; "
            "use .png, .tif or .exr"
        )
    check_writable(path)
    place = real_path(path)
    with temporary_name(nearest_folder(place.parent) / place.name) as probe:
        # JPEG 2000 has no smaller images, and OpenImageIO reads no emptier ones of JPEG XL.
        pixels = np.arange(64 * 64 * channels, dtype=np.uint16).reshape(64, 64, channels)
        if not output.open(str(probe), oiio.ImageSpec(64, 64, channels, depth)):
            raise InputError(f"{path}: cannot be written: {reason_of(output.geterror)}")
        output.write_image(pixels)
        output.close()
        written = oiio.ImageInput.open(str(probe))
        if written is None:  # on a full disk, which some writers do not notice
            raise InputError(f"{path}: cannot be written: {reason_of(oiio.geterror)}")
        return str(written.spec().format)


def _as_stored(image, path, curve):
    """The image as OpenImageIO has to be given it, and its description."""
    height, width, channels = image.shape
    alpha_channel = channels - 1 if channels in (2, 4) else None
    stored = str(image.dtype).replace("float32", "float")
    holds_light = path.suffix.lower() in FLOAT_FORMATS
    if holds_light and image.dtype != np.float32:
        stored = "half" if image.dtype == np.uint8 else "float"
        image = to_linear(image, alpha_channel)
    elif not holds_light and image.dtype == np.float32:
        stored = "uint8"
        image = to_uint8(image, alpha_channel, curve=curve)
    spec = oiio.ImageSpec(width, height, channels, stored)
    file_format = oiio.ImageOutput.create(str(path)).format_name()
    for name, value in _SETTINGS.get(file_format, {}).items():
        spec.attribute(name, value)
    if alpha_channel is not None:
        spec.alpha_channel = alpha_channel
        spec.channelnames = ("Y", "A") if channels == 2 else ("R", "G", "B", "A")
        if file_format in OURS_TO_DIVIDE:
            spec.attribute("oiio:UnassociatedAlpha", 1)
            image = divided_by_alpha(to_uint8(image) if file_format == "webp" else image)
    return image, spec


def _reads_back(file, shape):
    """Whether an image of that size can be read from the file."""
    source = oiio.ImageInput.open(str(file))
    if source is None:
        oiio.geterror()
        return False
    spec = source.spec()
    pixels = read_pixels(source, 0, range(spec.nchannels), str(spec.format))
    return pixels is not None and pixels.shape[:2] == shape[:2]
