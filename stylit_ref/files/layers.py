"""Layers of a multilayer EXR.

``file:LAYER`` names a layer: a prefix of channel names (``LDE.R``), or a named part of the file.
"""

from pathlib import Path

from stylit_ref.errors import InputError
from stylit_ref.files.image_file import check_size, open_image
from stylit_ref.files.output_file import real_path

_CHANNEL_ORDER = "RGBXYZUVA"


def split_layer(path: str | Path) -> tuple[Path, str | None]:
    """Split ``file:LAYER`` into file and layer, unless a file has that whole name.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    file : Path
    layer : str or None

    Raises
    ------
    InputError
        If there is no such file.
    """
    real_path(path)
    whole, (file, colon, layer) = Path(path), str(path).rpartition(":")
    if not whole.is_file() and colon and (Path(file).is_file() or Path(file).suffix):
        whole = Path(file)
    else:
        layer = None
    if not whole.is_file():
        reason = "is a folder; name an image file" if whole.is_dir() else "no such file"
        raise InputError(f"{whole}: {reason}")
    return whole, layer


def find_layer(file: Path, layer: str | None) -> tuple[int, list[int]]:
    """Find the channels of a layer, colours in their usual order.

    If ``layer`` is None, these are the unnamed channels, or only the colours among them if there
    are any.

    Parameters
    ----------
    file : Path
    layer : str or None

    Returns
    -------
    part : int
    channels : list of int
        Numbers of the part's channels.

    Raises
    ------
    InputError
        If the file has no such layer, cannot be read, or declares too large an image.
    """
    layers = _channels_by_layer(file)
    named = sorted(name for name in layers if name)
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
        known = ", ".join(named) or "none"
        if layer is None:
            raise InputError(f"{file}: all its layers have names; add one as {file}:LAYER: {known}")
        raise InputError(f"{file}: has no layer '{layer}'; its layers are: {known}")
    part = channels[0][0]
    channels = sorted((_CHANNEL_ORDER.find(c), n) for p, n, c in channels if p == part)
    return part, [number for _, number in channels]


def split_channel(name: str) -> tuple[str, str]:
    """Split ``LAYER.R`` into layer and channel; a channel without a layer has layer ``""``."""
    layer, _, channel = name.rpartition(".")
    return layer, channel.upper()


def _channels_by_layer(file):
    """Map each layer (``""`` if it has no name) to ``(part, number, channel)`` of its channels."""
    image = open_image(file)
    layers = {}
    part = 0
    while image.seek_subimage(part, 0):
        spec = image.spec()
        check_size(file, spec)
        part_name = spec.getattribute("name") or ""
        for number, name in enumerate(spec.channelnames):
            prefix, channel = split_channel(name)
            keys = {prefix or part_name}
            if part == 0 and not prefix:
                keys.add("")
            for key in keys:
                layers.setdefault(key, []).append((part, number, channel))
        part += 1
    image.close()
    return layers
