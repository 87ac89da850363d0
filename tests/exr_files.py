"""EXR files as renderers write them: layers, parts, data windows."""

from types import MappingProxyType

import numpy as np
import OpenImageIO as oiio


def write_exr(
    path, channels, size=(6, 8), data_window=None, depth="half", attributes=MappingProxyType({})
):
    """An EXR of constant channels: a dict of name to value or array.

    An attribute is a value, or a tuple of type and value.
    """
    names = tuple(channels)
    spec = oiio.ImageSpec(size[1], size[0], len(names), depth)
    spec.channelnames = names
    if data_window:
        spec.x, spec.y, spec.full_width, spec.full_height = data_window
        spec.full_x = spec.full_y = 0
    for name, value in attributes.items():
        spec.attribute(name, *(value if isinstance(value, tuple) else (value,)))
    pixels = np.zeros((*size, len(names)), np.float32)
    for c, value in enumerate(channels.values()):
        pixels[:, :, c] = value
    output = oiio.ImageOutput.create(str(path))
    assert output.open(str(path), spec), output.geterror()
    assert output.write_image(pixels)
    output.close()
    return path


def write_parts(path, parts):
    """A multi-part EXR: a dict of part name to the value of R, G and B."""
    return write_named_parts(
        path, [({"name": name}, dict.fromkeys("RGB", value)) for name, value in parts.items()]
    )


def write_named_parts(path, parts):
    """A multi-part EXR: pairs of attributes and of a dict of channel name to value."""
    specs = []
    for attributes, channels in parts:
        spec = oiio.ImageSpec(8, 6, len(channels), "half")
        spec.channelnames = tuple(channels)
        for name, value in attributes.items():
            spec.attribute(name, value)
        specs.append(spec)
    output = oiio.ImageOutput.create(str(path))
    assert output.open(str(path), tuple(specs)), output.geterror()
    for number, (_, channels) in enumerate(parts):
        if number:
            output.open(str(path), specs[number], "AppendSubimage")
        values = np.float32(list(channels.values()))
        output.write_image(np.broadcast_to(values, (6, 8, len(channels))).copy())
    output.close()
    return path


def write_deep(path):
    """A deep EXR: one opaque sample a pixel, at depth 1."""
    spec = oiio.ImageSpec(8, 6, 5, "float")
    spec.channelnames = ("R", "G", "B", "A", "Z")
    spec.deep = True
    samples = oiio.DeepData()
    samples.init(48, 5, ["float"] * 5, list(spec.channelnames))
    for pixel in range(48):
        samples.set_samples(pixel, 1)
        for channel, value in enumerate((0.25, 0.5, 0.75, 1, 1)):
            samples.set_deep_value(pixel, channel, 0, value)
    output = oiio.ImageOutput.create(str(path))
    assert output.open(str(path), spec), output.geterror()
    assert output.write_deep_image(samples), output.geterror()
    output.close()
    return path
