"""Records of the scale space: a thread for each."""

import numpy as np
from numba import cuda

from gpu_cuda.host.argument_types import INT
from gpu_cuda.host.device import launch
from gpu_cuda.realtime.image import IMAGE, address


@cuda.jit
def box_records_kernel(image, step, records, lanes, depth):
    b, a = cuda.grid(2)
    if a >= records.height or b >= records.width:
        return
    to = (a * records.stride + b) * depth * lanes
    reach = 0
    for _ in range(depth):
        area = (2 * reach + 1) * (2 * reach + 1)
        for c in range(lanes):
            total = np.int64(area // 2)
            for y in range(a * step - reach, a * step + reach + 1):
                start = address(image, y, b * step - reach, lanes) + c
                for k in range(2 * reach + 1):
                    total += np.int64(image.values[start + k * lanes])
            records.values[to + c] = total // area
        to += lanes
        reach = 3 * reach + 1  # boxes of 1, 3, 9 and 27 pixels a side


@cuda.jit
def mip_records_kernel(image, scale, step, records, lanes, depth):
    b, a = cuda.grid(2)
    if a >= records.height or b >= records.width:
        return
    start = address(image, (a * step) >> scale, (b * step) >> scale, lanes)
    to = ((a * records.stride + b) * depth + scale) * lanes
    for c in range(lanes):
        records.values[to + c] = image.values[start + c]


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "realtime: box records", box_records_kernel, (IMAGE, INT, IMAGE, INT, INT)
    yield "realtime: mip records", mip_records_kernel, (IMAGE, INT, INT, IMAGE, INT, INT)


def make_box_records(lanes, depth):
    """As :func:`stylit_ref.realtime.passes.make_box_records`."""

    def box_records(image, step, records):
        size = records.height, records.width
        launch(box_records_kernel, size, image, step, records, lanes, depth)

    return box_records


def make_mip_records(lanes, depth):
    """As :func:`stylit_ref.realtime.passes.make_mip_records`."""

    def mip_record(image, scale, step, records):
        size = records.height, records.width
        launch(mip_records_kernel, size, image, scale, step, records, lanes, depth)

    return mip_record
