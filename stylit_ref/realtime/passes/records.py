"""Records of the scale space (equation 20): a pixel at several scales, side by side.

What a scale is, equation 19 leaves open. ``box`` takes means of centred boxes of 1, 3, 9 and 27
pixels a side, ``mip`` the texels of coarser and coarser levels that contain the pixel.
"""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import prange

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.realtime.formulae.average import box_radius
from stylit_ref.realtime.passes.image import Image


@inlined
def _put_means(columns, radii, centre, lanes, out):
    """The mean of each scale's box around a pixel, from sums of its columns."""
    for scale in range(len(radii)):
        reach = radii[scale]
        area = np.uint32((2 * reach + 1) ** 2)
        for c in range(lanes):
            total = area // np.uint32(2)
            for k in range(centre - reach, centre + reach + 1):
                total += np.uint32(columns[scale, np.uint64(k * lanes + c)])
            out[scale * lanes + c] = np.uint8(total // area)


@inlined
def _put_texels(row, out, step, scale, width, lanes, size):
    for b in range(width):
        x = (b * step) >> scale
        for c in range(lanes):
            out[b * size + c] = row[x * lanes + c]


@cache
def make_box_records(lanes: int, depth: int) -> Callable[..., None]:
    """Build ``box_records(image, step, records)``.

    A record of ``depth`` times ``lanes`` bytes for every ``step``-th pixel; the image's border must
    be as wide as the largest box reaches.
    """
    radii = tuple(box_radius(scale) for scale in range(depth))

    @kernel(lanes, depth, nogil=True)
    def box_records(image: Image, step: int, records: Image) -> None:
        length = image.stride * lanes
        for index in prange(records.height):
            a = np.int64(index)
            centre = (a * step + image.border) * length
            columns = np.zeros((depth, length), np.uint16)
            for scale in range(depth):
                reach = radii[scale]
                line = columns[scale]
                for k in range(-reach, reach + 1):
                    above = image.values[centre + k * length : centre + (k + 1) * length]
                    for i in range(length):
                        line[i] += np.uint16(above[i])
            for b in range(records.width):
                x = b * step + image.border
                start = (a * records.stride + b) * depth * lanes
                end = start + depth * lanes
                _put_means(columns, radii, x, lanes, records.values[start:end])

    return box_records


@cache
def make_mip_records(lanes: int, depth: int) -> Callable[..., None]:
    """Build ``mip_record(image, scale, step, records)``, which writes one scale of all records.

    ``image`` is the level that lies ``scale`` above that of the records.
    """

    @kernel(lanes, depth, nogil=True)
    def mip_record(image: Image, scale: int, step: int, records: Image) -> None:
        for index in prange(records.height):
            a = np.int64(index)
            y = ((a * step) >> scale) + image.border
            start = (y * image.stride + image.border) * lanes
            row = image.values[start : start + image.width * lanes]
            start = (a * records.stride * depth + scale) * lanes
            _put_texels(
                row, records.values[start:], step, scale, records.width, lanes, depth * lanes
            )

    return mip_record
