"""Image files in and out through OpenImageIO: PNG, TIFF, JPEG, (multilayer) EXR, ...

Files are read at their own depth or converted to 8 bits (:mod:`stylit_ref.files.bit_depth`).
An alpha channel that is opaque everywhere carries nothing and is dropped; otherwise
colours are premultiplied by it, as OpenImageIO has it, so that averages of transparent
pixels come out right.
"""

import warnings
from pathlib import Path

import numpy as np
import OpenImageIO as oiio

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.files.bit_depth import to_linear, to_uint8
from stylit_ref.files.output_file import check_writable, real_path, temporary_name, whole_file

FLOAT_FORMATS = (".exr", ".hdr", ".pfm")
"""Files that hold scene-linear floating point."""

LARGEST_IMAGE = 1 << 29
"""Values (pixels times channels) that a file may declare: 16384x8192 with 4 channels.

As floating point they take 2 GiB, and reading takes two to three times the memory of the image.
More are refused before memory is taken: a file of a few bytes can declare any size.
"""

_CHANNEL_ORDER = "RGBXYZUVA"
_DEPTHS = {"uint8": "uint8", "uint16": "uint16"} | dict.fromkeys(
    ("half", "float", "double"), "float"
)


def read_image(path):
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
        :data:`LARGEST_IMAGE` values, or holds NaN or infinity.
    """
    return _drop_opaque(*_read(path))[0]


def read_uint8(path):
    """Read an image as 8-bit display values.

    Parameters and errors are those of :func:`read_image`.

    Returns
    -------
    (H, W, n) uint8
    """
    return _displayed(path)[0]


def read_guides(source_path, target_path):
    """Read a guide of the source and of the target so that their channels agree.

    Alpha is dropped if it is opaque in both images and otherwise kept, or added, in
    both; a grey image beside one in colour is spread to three channels.

    Parameters and errors are those of :func:`read_image`.

    Returns
    -------
    source, target : (H, W, n) uint8
        The numbers of channels still differ where neither is grey.
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


def write_image(path, image):
    """Write an image, whole or not at all.

    Integers go to a floating-point format as scene-linear light and floating point to
    an integer format as 8-bit display values; otherwise the depth is kept as far as
    the format goes (JPEG has 8 bits).

    Parameters
    ----------
    path : str or Path
        The suffix names the format.
    image : (H, W) or (H, W, n) uint8, uint16 or float32
        2 and 4 channels end in alpha, premultiplied.

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
    height, width, channels = image.shape
    if image.dtype not in (np.uint8, np.uint16, np.float32):
        raise InputError(
            f"{path}: the image has dtype {image.dtype}; it must be uint8, uint16 or float32"
        )
    check_image_writable(path, channels)
    alpha_channel = channels - 1 if channels in (2, 4) else None
    stored = str(image.dtype).replace("float32", "float")
    if path.suffix.lower() in FLOAT_FORMATS and image.dtype != np.float32:
        stored = "half" if image.dtype == np.uint8 else "float"
        image = to_linear(image)
    elif path.suffix.lower() not in FLOAT_FORMATS and image.dtype == np.float32:
        stored = "uint8"
        image = to_uint8(image, alpha_channel)

    spec = oiio.ImageSpec(width, height, channels, stored)
    if alpha_channel is not None:
        spec.alpha_channel = alpha_channel
        spec.channelnames = ("Y", "A") if channels == 2 else ("R", "G", "B", "A")
    # Compression may not pay: allow for pixels as they are, 4 bytes in a floating-point file.
    depth = 4 if stored == "float" else image.itemsize
    with whole_file(path, image.size * depth * 9 // 8 + 2**16) as partial:
        output = oiio.ImageOutput.create(str(partial))
        written = output.open(str(partial), spec) and output.write_image(image)
        if not (output.close() and written):
            reason = _reason(output.geterror() or oiio.geterror())
            raise InputError(f"{path}: cannot be written: {reason}")
        # Some writers fail without a word, on a full disk or for a size that they do not know.
        if not _reads_back(partial, image.shape):
            raise InputError(f"{path}: cannot be written: what was written cannot be read")


def check_image_writable(path, channels):
    """Refuse early an output that :func:`write_image` could not write.

    Parameters
    ----------
    path : str or Path
    channels : int

    Raises
    ------
    InputError
    """
    path = Path(path)
    output = oiio.ImageOutput.create(str(path))
    if output is None or output.format_name() in ("null", "term"):  # they write no file
        oiio.geterror()
        raise InputError(
            f"{path}: no image format is known by the suffix '{path.suffix}'; "
            "use .png, .tif or .exr"
        )
    if output.format_name() == "gif":
        raise InputError(f"{path}: GIF files hold only 256 colours; use .png, .tif or .exr")
    if channels in (2, 4) and not output.supports("alpha"):
        raise InputError(
            f"{path}: {output.format_name()} files have no transparency and the image has "
            "an alpha channel; use .png, .tif or .exr"
        )
    check_writable(path)
    with temporary_name(real_path(path)) as probe:
        if not output.open(str(probe), oiio.ImageSpec(1, 1, channels, "uint8")):
            raise InputError(f"{path}: cannot be written: {_reason(output.geterror())}")
        output.write_image(np.zeros((1, 1, channels), np.uint8))
        output.close()


def _read(path):
    """Pixels of a file or layer and the number of their alpha channel, or None."""
    try:
        return _read_pixels(path)
    except UnicodeDecodeError:  # of a channel's name, or of a message that quotes it
        raise InputError(f"{path}: cannot be read: its header holds what is no text") from None


def _read_pixels(path):
    file, layer = _split_layer(path)
    part, channels = _find_layer(file, layer)
    source = _open(file)
    source.seek_subimage(part, 0)
    spec = source.spec()
    stored = {str(spec.channelformat(channel)) for channel in channels}
    if not stored <= _DEPTHS.keys():
        raise InputError(
            f"{path}: holds {', '.join(sorted(stored))} values; "
            "8 or 16 bit integers or floating point are needed"
        )
    depth = _DEPTHS[str(spec.format)] if len(stored) == 1 else "float"
    image = _pixels(source, part, depth)
    if image is None:
        raise InputError(f"{file}: cannot be read: {_reason(source.geterror())}")
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
    names = [_channel_name(spec.channelnames[c])[1] for c in channels]
    alpha_channel = names.index("A") if "A" in names and len(names) > 1 else None
    return image, alpha_channel


def _in_display_window(pixels, spec):
    """Pixels of the data window that the display window has, 0 around them."""
    shown = np.zeros((spec.full_height, spec.full_width, spec.nchannels), pixels.dtype)
    y, x = spec.y - spec.full_y, spec.x - spec.full_x
    window, pixels = shown[max(y, 0) :, max(x, 0) :], pixels[max(-y, 0) :, max(-x, 0) :]
    height, width = map(min, window.shape[:2], pixels.shape[:2])
    window[:height, :width] = pixels[:height, :width]
    return shown


def _upright(pixels, orientation):
    """A view of pixels stored in one of the eight orientations of TIFF and Exif."""
    if orientation in (5, 6, 7, 8):
        pixels = pixels.swapaxes(0, 1)
    down = -1 if orientation in (3, 4, 7, 8) else 1
    right = -1 if orientation in (2, 3, 6, 7) else 1
    return pixels[::down, ::right]


def _pixels(source, part, depth):
    """All pixels of a part of an open file, or None.

    Of a truncated JPEG the rest is made up, and the error alone tells.
    """
    pixels = source.read_image(part, 0, 0, source.spec().nchannels, depth)
    return None if source.has_error else pixels


def _reads_back(file, shape):
    source = oiio.ImageInput.open(str(file))
    if source is None:
        oiio.geterror()
        return False
    pixels = _pixels(source, 0, str(source.spec().format))
    return pixels is not None and pixels.shape[:2] == shape[:2]


def _drop_opaque(image, alpha_channel):
    """Image and alpha channel without an alpha that is opaque everywhere."""
    if alpha_channel is not None:
        alpha = image[:, :, alpha_channel]
        opaque = 1 if alpha.dtype == np.float32 else np.iinfo(alpha.dtype).max
        if (alpha >= opaque).all():
            return np.ascontiguousarray(np.delete(image, alpha_channel, axis=2)), None
    return image, alpha_channel


def _displayed(path):
    """8-bit display values of a file or layer, and the number of their alpha channel, or None.

    Says so if that clips more than highlights.
    """
    image, alpha_channel = _drop_opaque(*_read(path))
    if image.dtype == np.float32:
        clipped = np.mean((image < -0.01) | (image > 1))
        if clipped > 0.05:
            warnings.warn(
                f"{path}: {clipped:.0%} of the values lie outside [0, 1] and are clipped",
                stacklevel=3,
            )
    rows = [to_uint8(row, alpha_channel) for row in image]  # each takes several times its memory
    return np.stack(rows), alpha_channel


def _split_layer(path):
    """``file:LAYER`` into file and layer; a file of that whole name comes first."""
    real_path(path)
    whole, (file, colon, layer) = Path(path), str(path).rpartition(":")
    if not whole.is_file() and colon and (Path(file).is_file() or Path(file).suffix):
        whole = Path(file)
    else:
        layer = None
    if not whole.is_file():
        reason = "is a folder, not an image" if whole.is_dir() else "no such file"
        raise InputError(f"{whole}: {reason}")
    return whole, layer


def _open(file):
    image = oiio.ImageInput.open(str(file))
    if image is None:
        raise InputError(f"{file}: cannot be read: {_reason(oiio.geterror())}")
    return image


def _reason(said):
    """The first line: more are advice, or the same again."""
    return said.split("\n")[0].rstrip(".")


def _check_size(file, spec):
    """Refuse by what the file declares; its display window may exceed its pixels."""
    for width, height in ((spec.width, spec.height), (spec.full_width, spec.full_height)):
        if width * height * spec.nchannels > LARGEST_IMAGE:
            raise InputError(
                f"{file}: declares {width}x{height} pixels with {spec.nchannels} channels; "
                f"at most {LARGEST_IMAGE} values are read"
            )


def _channel_name(name):
    """``LAYER.R`` into layer and channel; a channel without a layer has layer ``""``."""
    layer, _, channel = name.rpartition(".")
    return layer, channel.upper()


def _find_layer(file, layer):
    """Part of the file and channel numbers of a layer, colours in their usual order.

    A layer is a prefix of channel names (``LDE.R``), or a named part of the file.
    Without a layer the unnamed channels are meant: the colours, if there are any.
    """
    image = _open(file)
    layers = {}
    part = 0
    while image.seek_subimage(part, 0):
        spec = image.spec()
        _check_size(file, spec)
        part_name = spec.getattribute("name") or ""
        for number, name in enumerate(spec.channelnames):
            prefix, channel = _channel_name(name)
            keys = {prefix or part_name}
            if part == 0 and not prefix:
                keys.add("")
            for key in keys:
                layers.setdefault(key, []).append((part, number, channel))
        part += 1
    image.close()

    named = sorted(key for key in layers if key)
    channels = layers.get(layer or "", [])
    if layer is None:
        if not channels and len(named) == 1:
            channels = layers[named[0]]
        present = {channel for _, _, channel in channels}
        luminance = {"Y"} if "X" not in present else set()
        colours = present & {"R", "G", "B"} or present & luminance
        if colours:
            channels = [entry for entry in channels if entry[2] in colours | {"A"}]
        elif len(named) > 1:
            channels = []
    if not channels:
        asked = "it has no unnamed layer" if layer is None else f"it has no layer '{layer}'"
        known = ", ".join(named) or "none"
        raise InputError(f"{file}: {asked}; its named layers are: {known}")
    part = channels[0][0]
    channels = sorted((_CHANNEL_ORDER.find(c), n) for p, n, c in channels if p == part)
    return part, [number for _, number in channels]
