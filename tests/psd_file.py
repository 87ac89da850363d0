"""Photoshop files, as Adobe's specification of the format has them."""

import struct

import numpy as np


def write_psd(path, image, layers=None, icc=None):
    """Write (H, W, n) with n = 1, 3 or 4, layers of the same size by name, and a profile.

    Values are uint8, uint16 or float32. With 4 channels, of uint8, the last is alpha. Then a layer
    has the colours, and the image that shows all layers has them on white.
    """
    if image.shape[2] == 4:
        layers = layers or {"Layer 0": image}
        alpha = image[:, :, 3:] / 255
        on_white = np.rint(image[:, :, :3] * alpha + 255 * (1 - alpha)).astype(np.uint8)
        image = np.dstack([on_white, image[:, :, 3]])
    height, width, channels = image.shape
    mode = 3 if channels > 1 else 1
    profile = b"" if icc is None else b"8BIM" + struct.pack(">HHI", 1039, 0, len(icc)) + icc
    profile += bytes(len(profile) % 2)
    path.write_bytes(
        struct.pack(">4sH6xHIIHH", b"8BPS", 1, channels, height, width, 8 * image.itemsize, mode)
        + _counted(b"")
        + _counted(profile)
        + _counted(_layers(layers, channels == 4) + _counted(b"") if layers else b"")
        + struct.pack(">H", 0)
        + _planes(image)
    )


def _layers(layers, has_alpha):
    records, pixels = [], []
    for name, image in layers.items():
        height, width, channels = image.shape
        size = height * width + 2
        numbers = (0, 1, 2, -1)[:channels]
        label = bytes([len(name)]) + name.encode()
        label += bytes(-len(label) % 4)
        records.append(
            struct.pack(">4IH", 0, 0, height, width, channels)
            + b"".join(struct.pack(">hI", number, size) for number in numbers)
            + b"8BIMnorm"
            + bytes([255, 0, 0, 0])
            + _counted(_counted(b"") + _counted(b"") + label)
        )
        pixels += [struct.pack(">H", 0) + _planes(image[:, :, [c]]) for c in range(channels)]
    count = -len(layers) if has_alpha else len(layers)  # the sign says what the last channel is
    whole = struct.pack(">h", count) + b"".join(records + pixels)
    return _counted(whole + bytes(len(whole) % 2))


def _planes(image):
    return np.moveaxis(image, 2, 0).astype(image.dtype.newbyteorder(">")).tobytes()


def _counted(content):
    return struct.pack(">I", len(content)) + content
