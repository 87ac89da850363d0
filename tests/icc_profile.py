"""ICC profiles for tests."""

import struct

XYZ = {
    "r": (0.43607, 0.22249, 0.01392),
    "g": (0.38515, 0.71687, 0.09708),
    "b": (0.14307, 0.06061, 0.71410),
}
"""Red, green and blue of sRGB under D50."""


def _numbers(*values):
    return b"".join(struct.pack(">i", round(value * 65536)) for value in values)


def icc_profile(space=b"RGB ", primaries="grb", name=b"Red is green"):
    """A profile of gamma 2.2 whose red, green and blue are these primaries of sRGB."""
    white = 0.9642, 1.0, 0.8249
    gamma = b"curv" + bytes(4) + struct.pack(">IHH", 1, round(2.2 * 256), 0)
    tags = {
        b"desc": b"desc" + bytes(4) + struct.pack(">I", len(name) + 1) + name + bytes(79),
        b"wtpt": b"XYZ " + bytes(4) + _numbers(*white),
        b"cprt": b"text" + bytes(4) + b"none\0",
    }
    if space == b"GRAY":
        tags[b"kTRC"] = gamma
    for channel, primary in zip("rgb", primaries, strict=True) if space == b"RGB " else ():
        tags[channel.encode() + b"XYZ"] = b"XYZ " + bytes(4) + _numbers(*XYZ[primary])
        tags[channel.encode() + b"TRC"] = gamma
    table, contents = struct.pack(">I", len(tags)), b""
    for tag, content in tags.items():
        place = 128 + 4 + 12 * len(tags) + len(contents)
        table += tag + struct.pack(">II", place, len(content))
        contents += content + bytes(-len(content) % 4)
    size = struct.pack(">I", 128 + len(table) + len(contents))
    head = size + bytes(4) + b"\2\x10\0\0" + b"mntr" + space + b"XYZ " + bytes(12) + b"acsp"
    head += bytes(28) + _numbers(*white)
    return head.ljust(128, b"\0") + table + contents
