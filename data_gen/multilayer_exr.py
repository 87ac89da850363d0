"""Layers of a view in one half-float EXR: channels ``LDE.R``, ``DEPTH.Z`` and so on."""

import numpy as np
import OpenImageIO as oiio

CHANNELS = {"POSITION": "XYZ", "NORMAL": "XYZ", "DEPTH": "Z", "FRESNEL": "Y", "WIREFRAME": "Y",
            "MOTION": "XY", "VISIBLE": "Y"}  # fmt: skip
"""Names of channels of layers that are no colours (RGB)."""


def channel_names(layer, count):
    """Names of a layer's channels, in order."""
    return [f"{layer}.{channel}" for channel in CHANNELS.get(layer, "RGB")[:count]]


def write_layers(path, layers):
    """Write layers as half floats; the same layers give the same bytes.

    Parameters
    ----------
    path : str or Path
    layers : dict of str to (H, W, n) float32
    """
    pixels = np.concatenate(list(layers.values()), axis=2)
    names = [n for name, layer in layers.items() for n in channel_names(name, layer.shape[2])]
    height, width, count = pixels.shape
    spec = oiio.ImageSpec(width, height, count, "half")
    spec.channelnames = names
    spec.attribute("compression", "zip")
    spec.attribute("DateTime", "")  # or it would be the time of writing
    output = oiio.ImageOutput.create(str(path))
    if not (output.open(str(path), spec) and output.write_image(pixels) and output.close()):
        raise OSError(f"{path}: cannot be written: {output.geterror()}")


def read_layers(path):
    """Read what :func:`write_layers` wrote.

    Returns
    -------
    dict of str to (H, W, n) float32
        Channels found by their names: their order in the file may differ.
    """
    image = oiio.ImageBuf(str(path))
    if image.has_error:
        raise OSError(f"{path}: cannot be read: {image.geterror()}")
    pixels, names = image.get_pixels("float"), list(image.spec().channelnames)
    layers = {}
    for layer in dict.fromkeys(name.rpartition(".")[0] for name in names):
        wanted = [n for n in channel_names(layer, 3) if n in names]
        layers[layer] = pixels[:, :, [names.index(n) for n in wanted]]
    return layers
