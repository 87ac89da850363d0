"""DDS files of light, compressed as BC6H."""

import struct

import numpy as np


def write_dds_of_light(path, image):
    """Write (H, W, 3) float32 whose blocks of 4x4 pixels have one value each, to three per cent."""
    height, width = image.shape[:2]
    pixel_format = struct.pack("<II4s5I", 32, 4, b"DX10", *[0] * 5)
    header = struct.pack("<7I44x", 124, 0x81007, height, width, height * width, 0, 1)
    header += pixel_format + struct.pack("<5I", 0x1000, *[0] * 4)
    header += struct.pack("<5I", 95, 3, 0, 1, 0)  # BC6H without sign, of two dimensions
    blocks = image[::4, ::4].astype(np.float16).view(np.uint16).astype(int)
    levels = (blocks * 64 // 31 + 32) >> 6  # ten bits
    path.write_bytes(b"DDS " + header + b"".join(map(_block, levels.reshape(-1, 3).tolist())))


def _block(levels):
    """A block of one value: both of its ends are the same, and so no index matters."""
    bits = 0b00011  # ends of ten bits each
    for place, level in enumerate([*levels, *levels]):
        bits |= level << (5 + 10 * place)
    return bits.to_bytes(16, "little")
