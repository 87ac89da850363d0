"""EXR files as renderers write them: layers, parts, data windows."""

import numpy as np
import OpenImageIO as oiio


def write_exr(path, channels, size=(6, 8), data_window=None):
    """A half-float EXR of constant channels: a dict of name to value or array."""
    names = tuple(channels)
    spec = oiio.ImageSpec(size[1], size[0], len(names), "half")
    spec.channelnames = names
    if data_window:
        spec.x, spec.y, spec.full_width, spec.full_height = data_window
        spec.full_x = spec.full_y = 0
    pixels = np.zeros((*size, len(names)), np.float32)
    for c, value in enumerate(channels.values()):
        pixels[:, :, c] = value
    output = oiio.ImageOutput.create(str(path))
    assert output.open(str(path), spec), output.geterror()
    assert output.write_image(pixels)
    output.close()
    return path


def write_parts(path, parts):
    """A multi-part EXR: a dict of part name to RGB value."""
    specs = []
    for name in parts:
        spec = oiio.ImageSpec(8, 6, 3, "half")
        spec.attribute("name", name)
        specs.append(spec)
    output = oiio.ImageOutput.create(str(path))
    assert output.open(str(path), tuple(specs)), output.geterror()
    for number, value in enumerate(parts.values()):
        if number:
            output.open(str(path), specs[number], "AppendSubimage")
        output.write_image(np.full((6, 8, 3), value, np.float32))
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
