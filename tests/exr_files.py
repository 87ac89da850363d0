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
