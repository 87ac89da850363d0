"""3. Exemplars."""

import math

import numpy as np

from .spec_02_colours import pack


def border_of(radius):
    """Give the width of the border around every image."""
    return radius - radius // 2 + 4


def lay_out(images, radius):
    """Give the plane of all images, (rows, stride, channels)."""
    border = border_of(radius)
    stride = max(image.shape[1] for image in images) + 2 * border
    rows = []
    for image in images:
        height, width = image.shape[:2]
        for y in range(-border, height + border):
            row = image[min(max(y, 0), height - 1)]
            rows.append([row[min(max(x - border, 0), width - 1)] for x in range(stride)])
    return np.array(rows).astype(int)


def colours_of(images, radius, fractions):
    """Give the packed colours of all planes."""
    plane = lay_out(images, radius)
    if not fractions:
        return np.array([pack(pixel) for row in plane for pixel in row])
    height, width = plane.shape[:2]
    colours = []
    for v in range(4):
        for u in range(4):
            for y in range(height):
                for x in range(width):
                    right, below = min(x + 1, width - 1), min(y + 1, height - 1)
                    a = plane[y, x] * (4 - u) + plane[y, right] * u
                    b = plane[below, x] * (4 - u) + plane[below, right] * u
                    colours.append(pack((a * (4 - v) + b * v + 8) >> 4))
    return np.array(colours)


def valid_of(images, known, radius):
    """Tell which pixels of the plane are an image's, and known."""
    border = border_of(radius)
    stride = max(image.shape[1] for image in images) + 2 * border
    bands = []
    for k, image in enumerate(images):
        height, width = image.shape[:2]
        band = np.zeros((height + 2 * border, stride), bool)
        band[border : border + height, border : border + width] = known[k] if known else True
        bands.append(band)
    return np.concatenate(bands)


def clearance_of(valid):
    """Give the distance to the nearest pixel that is not valid."""
    bad = np.argwhere(~valid)
    clearance = np.zeros(valid.shape, int)
    for y, x in np.argwhere(valid):
        clearance[y, x] = math.isqrt(int(((bad - (y, x)) ** 2).sum(axis=1).min()))
    return clearance


def centres_of(valid, radius):
    """List the addresses where a centre may lie."""
    return np.flatnonzero(2 * clearance_of(valid) > radius).tolist()


def numbered(arrays, name):
    """List the arrays NAME_1, NAME_2 ..."""
    return [arrays[f"{name}_{k}"] for k in range(1, len(arrays) + 1) if f"{name}_{k}" in arrays]


def stage_exemplars(p, a):
    """Do stage exemplars."""
    images = numbered(a, "image")
    valid = valid_of(images, numbered(a, "known"), p["radius"])
    return {
        "colours": colours_of(images, p["radius"], p["fractions"]),
        "clearance": clearance_of(valid),
        "centres": centres_of(valid, p["radius"]),
    }


STAGES = {"exemplars": stage_exemplars}
