"""The kernels of stylization in real time equal the CPU's passes, bit for bit."""

import numpy as np
import pytest
from numba import cuda
from signatures import signature
from small_realtime import make_case, make_session

import gpu_cuda.realtime
from stylit_ref.machine.vector_patch import STYLE_LANES, row_lanes
from stylit_ref.randomness.random_stream import REALTIME_NNF, REALTIME_SEARCH, random_stream
from stylit_ref.realtime import passes
from stylit_ref.realtime.formulae.grid import grid_size
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.passes.image import Image, make_image, whole
from stylit_ref.realtime.passes.moving import ALL
from stylit_ref.realtime.passes.search import FREE, Grid

MAKERS = {
    "make_blend": (5, 3, 4),
    "make_box_records": (8, 2),
    "make_dense_nnf": (5, 3, 8),
    "make_extend": (8,),
    "make_fill": (5, 8),
    "make_halve": (8,),
    "make_insert_style": (8,),
    "make_mip_records": (8, 2),
    "make_renew": (5, 5, 8),
    "make_search": (5, 5, 8),
    "make_vote": (5,),
}
BORDER = 4


def test_names_and_signatures_mirror_the_passes():
    assert gpu_cuda.realtime.__all__ == passes.__all__
    assert set(MAKERS) == {name for name in passes.__all__ if name.startswith("make_")}
    for name in passes.__all__:
        ours, theirs = getattr(gpu_cuda.realtime, name), getattr(passes, name)
        assert signature(ours) == signature(theirs)
        if name in MAKERS:
            assert signature(ours(*MAKERS[name])) == signature(theirs(*MAKERS[name]))


def image_of(rng, size, lanes, border=BORDER):
    image = make_image(*size, border, lanes)
    whole(image, lanes)[:] = rng.integers(0, 256, whole(image, lanes).shape)
    passes.make_extend(lanes)(image)
    return image


def copied(argument):
    """Arrays on the device; images with such."""
    if isinstance(argument, np.ndarray):
        return cuda.to_device(argument)
    if hasattr(argument, "_fields"):
        return type(argument)(*map(copied, argument))
    return argument


def assert_same(written, do, twin, *arguments):
    """Both write the same to the argument of this number, beginning with the same."""
    theirs = [copied(argument) for argument in arguments]
    do(*arguments)
    twin(*theirs)
    ours, found = arguments[written], theirs[written]
    if isinstance(ours, Image):
        size = (ours.height + 2 * ours.border) * ours.stride
        lanes = ours.values.size // size
        ours, found = ours.values[: size * lanes], found.values[: size * lanes]
    np.testing.assert_array_equal(found.copy_to_host(), ours)


@pytest.mark.parametrize("size", [(7, 6), (1, 1), (1, 9)])
@pytest.mark.parametrize("lanes", [4, 12])
def test_pixels_and_levels(size, lanes):
    rng = np.random.default_rng(sum(size) + lanes)
    image = image_of(rng, size, lanes)
    half = tuple(-(-side // 2) for side in size)
    coarse = make_image(*half, BORDER, lanes)
    assert_same(1, passes.make_halve(lanes), gpu_cuda.realtime.make_halve(lanes), image, coarse)
    pixels = rng.integers(0, 256, size[0] * size[1] * (lanes - 1), np.uint8)
    do, twin = (each.make_fill(lanes - 1, lanes) for each in (passes, gpu_cuda.realtime))
    assert_same(1, do, twin, pixels, make_image(*size, BORDER, lanes))
    image.values[:] = rng.integers(0, 256, image.values.size)
    assert_same(0, passes.make_extend(lanes), gpu_cuda.realtime.make_extend(lanes), image)


def test_style_beside_guides():
    rng = np.random.default_rng(3)
    style, both = image_of(rng, (6, 5), STYLE_LANES), image_of(rng, (6, 5), 12)
    do, twin = (each.make_insert_style(12) for each in (passes, gpu_cuda.realtime))
    assert_same(1, do, twin, style, both, 2, 9)


def test_labels():
    rng = np.random.default_rng(4)
    labels = rng.integers(0, 5, (9, 11), np.uint8)
    there = np.zeros(256, np.bool_)
    assert_same(1, passes.mark_labels, gpu_cuda.realtime.mark_labels, labels, there)
    entries = np.zeros((2, 2), np.int16)
    do, twin = passes.decimate_labels, gpu_cuda.realtime.decimate_labels
    assert_same(3, do, twin, labels, 1, 3, entries)
    there[3:] = False
    do, twin = passes.free_lost_labels, gpu_cuda.realtime.free_lost_labels
    assert_same(0, do, twin, rng.integers(0, 5, (4, 5)).astype(np.int16), there)


@pytest.mark.parametrize("step", [1, 3])
def test_records(step):
    rng = np.random.default_rng(step)
    image = image_of(rng, (8, 7), 8)
    grid = grid_size(8, step), grid_size(7, step)
    do, twin = (each.make_box_records(8, 3) for each in (passes, gpu_cuda.realtime))
    assert_same(2, do, twin, image, step, make_image(*grid, 0, 24))
    coarse = image_of(rng, (2, 2), 8)
    do, twin = (each.make_mip_records(8, 3) for each in (passes, gpu_cuda.realtime))
    assert_same(3, do, twin, coarse, 2, step, make_image(*grid, 0, 24))


def random_entries(rng, grid, size, margin):
    nnf = np.empty(grid, np.int32)
    seed = int(rng.integers(1 << 40))
    passes.random_nnf(nnf, *size, margin, random_stream(seed, REALTIME_NNF, 2))
    return nnf


@pytest.mark.parametrize(("width", "step"), [(3, 2), (5, 3), (5, 4), (7, 7), (13, 7)])
@pytest.mark.parametrize("channels", [3, 4])
def test_blend(width, step, channels):
    rng = np.random.default_rng(width)
    style, size = image_of(rng, (9, 8), STYLE_LANES, border=16), (11, 10)
    grid = tuple(grid_size(side, step) for side in size)
    nnf = random_entries(rng, grid, (9, 8), width // 2)
    do, twin = (each.make_blend(width, step, channels) for each in (passes, gpu_cuda.realtime))
    out = make_image(*size, 0 if channels == 3 else BORDER, channels)
    out = out._replace(values=out.values[: -(out.values.size % channels) or None])
    assert_same(2, do, twin, nnf, style, out, ALL)
    moving = rng.integers(0, 2, grid, np.uint8)
    after = np.where(moving, random_entries(rng, grid, (9, 8), width // 2), nnf)
    assert_same(2, do, twin, after, style, out, moving)


@pytest.mark.parametrize("size", [(9, 8), (1, 3)])
def test_from_level_to_level(size):
    rng = np.random.default_rng(7)
    nnf = np.empty((4, 5), np.int32)
    stream = random_stream(9, REALTIME_NNF, 1)
    assert_same(0, passes.random_nnf, gpu_cuda.realtime.random_nnf, nnf, *size, 2, stream)
    fine = np.empty((7, 10), np.int32)
    double = tuple(2 * side for side in size)
    do, twin = passes.upsample_nnf, gpu_cuda.realtime.upsample_nnf
    assert_same(1, do, twin, nnf, fine, *double, 2, 3)
    coarse, out = image_of(rng, size, 4), make_image(2 * size[0] - 1, 2 * size[1], BORDER, 4)
    assert_same(1, passes.upsample_picture, gpu_cuda.realtime.upsample_picture, coarse, out)


@pytest.mark.parametrize("shape", [(5, 5), (1, 3)])
@pytest.mark.parametrize("lanes", [4, 12])
@pytest.mark.parametrize(("parity", "radius"), [(0, 9), (1, 0)])
def test_half_iteration(shape, lanes, parity, radius):
    rng = np.random.default_rng(lanes)
    is_patch = shape[0] > 1
    unit, border = (1, BORDER) if is_patch else (shape[1], 0)
    source, target, step = (9, 11), (10, 8), 3
    grid = tuple(grid_size(side, step) for side in target)
    images = [image_of(rng, source, lanes * unit, border)]
    images += [
        image_of(rng, target if is_patch else grid, count * unit, border)
        for count in (lanes, STYLE_LANES)
    ]
    if lanes == STYLE_LANES:
        images[1] = images[2]
    row = np.zeros(row_lanes(shape[1], lanes), np.int16)
    weights = rng.integers(0, 5, lanes)
    row[: shape[1] * lanes] = np.tile(weights, shape[1])
    labels = rng.integers(FREE, 2, grid).astype(np.int16)
    entries = Grid(step, step if is_patch else 1, 2, labels, rng.integers(0, 2, source, np.uint8))
    stream = random_stream(5, REALTIME_SEARCH, 1, 2, parity)
    nnf = random_entries(rng, grid, source, 2)
    before = nnf.copy()
    do, twin = (each.make_search(*shape, lanes) for each in (passes, gpu_cuda.realtime))
    stop = np.zeros(1, np.uint8)
    assert_same(0, do, twin, nnf, *images, row, entries, stream, parity, radius, stop)
    assert (nnf != before).any()
    moving, searched = np.zeros(grid, np.uint8), nnf
    moving[tuple(np.argwhere(nnf != before)[0])] = 1
    entries, nnf = entries._replace(moving=moving), before.copy()
    assert_same(0, do, twin, nnf, *images, row, entries, stream, parity, radius, stop)
    np.testing.assert_array_equal(nnf, np.where(moving, searched, before))


def test_a_blend_leaves_what_does_not_move():
    style, out = image_of(np.random.default_rng(1), (20, 20), STYLE_LANES), (12, 12)
    out = make_image(*out, BORDER, STYLE_LANES)
    out.values[:] = 7
    moving = np.zeros((4, 4), np.uint8)
    moving[1, 1] = 1
    entries = random_entries(np.random.default_rng(2), (4, 4), (20, 20), 2)
    gpu_cuda.realtime.make_blend(5, 3, STYLE_LANES)(entries, style, out, moving)
    written = np.any(whole(out, STYLE_LANES)[BORDER:-BORDER, BORDER:-BORDER] != 7, axis=2)
    assert written[1:6, 1:6].all()
    assert written.sum() == 25


def test_entries_that_move():
    rng = np.random.default_rng(2)
    before = rng.integers(0, 9, (6, 7)).astype(np.int32)
    after, moving = before.copy(), np.full((6, 7), 3, np.uint8)
    after[0, 6] += 1
    after[3, 2] += 1
    do, twin = passes.mark_moving, gpu_cuda.realtime.mark_moving
    assert_same(2, do, twin, before, after, moving)
    assert moving.sum() == 4 + 9


@pytest.mark.parametrize(("shape", "unit"), [((5, 5), 12), ((1, 3), 36)])
def test_renewal(shape, unit):
    rng, level = np.random.default_rng(8), 1
    sizes, grids = ((15, 17), (8, 9)), ((5, 7), (3, 4))  # of the source and of entries, by level
    is_patch, lanes = shape[0] > 1, 12
    step, target = (3, (9, 11)) if is_patch else (3, grids[1])
    images = [
        image_of(rng, sizes[1], unit), image_of(rng, target, unit),
        image_of(rng, target, STYLE_LANES if is_patch else 3 * STYLE_LANES),
    ]  # fmt: skip
    row = np.zeros(row_lanes(shape[1], lanes), np.int16)
    row[: shape[1] * lanes] = 1
    fine, coarse = (
        Grid(step, step if is_patch else 1, 2, rng.integers(FREE, 2, grid).astype(np.int16),
             rng.integers(0, 2, size, np.uint8))
        for grid, size in zip(grids, sizes, strict=True)
    )  # fmt: skip
    nnf, fresh = (
        random_entries(rng, grid, size, 2) for grid, size in zip(grids, sizes, strict=True)
    )
    before = nnf.copy()
    do, twin = (each.make_renew(*shape, lanes) for each in (passes, gpu_cuda.realtime))
    assert_same(0, do, twin, nnf, fresh, level, *images, row, coarse, *sizes[0], fine)
    assert 0 < (nnf != before).mean() < 1


@pytest.mark.parametrize("labelled", [False, True])
@pytest.mark.parametrize("lanes", [4, 12])
@pytest.mark.parametrize("width", [3, 5])
def test_dense_finish(width, lanes, labelled):
    rng = np.random.default_rng(width)
    source, target, step = (9, 11), (10, 8), width // 2 + 1
    images = [image_of(rng, source, lanes), image_of(rng, target, lanes)]
    images.append(images[1] if lanes == STYLE_LANES else image_of(rng, target, STYLE_LANES))
    row = np.zeros(row_lanes(width, lanes), np.int16)
    row[: width * lanes] = np.tile(rng.integers(0, 5, lanes), width)
    labels = [
        rng.integers(0, 2, size if labelled else (0, 0), np.uint8) for size in (target, source)
    ]
    entries = random_entries(rng, [grid_size(side, step) for side in target], source, width // 2)
    dense = np.zeros(target, np.int32)
    do, twin = (each.make_dense_nnf(width, step, lanes) for each in (passes, gpu_cuda.realtime))
    go = np.zeros(1, np.uint8)
    assert_same(7, do, twin, entries, *images, row, *labels, dense, go)
    do, twin = (each.make_vote(width) for each in (passes, gpu_cuda.realtime))
    style, out = image_of(rng, source, STYLE_LANES), np.zeros((*target, 3), np.uint8)
    assert_same(2, do, twin, dense, style, out, go)


def test_a_stopped_search_changes_nothing():
    rng = np.random.default_rng(1)
    nnf, images = np.zeros((3, 3), np.int32), [image_of(rng, (9, 9), 4)] * 3
    grid = Grid(3, 3, 2, np.zeros((0, 0), np.int16), np.zeros((0, 0), np.uint8))
    stream = random_stream(5, REALTIME_SEARCH)
    gpu_cuda.realtime.make_search(5, 5, 4)(
        nnf, *images, np.ones(32, np.int16), grid, stream, 0, 4, np.ones(1, np.uint8)
    )
    assert not nnf.any()


def test_a_session_gives_the_same_picture():
    case = make_case((9, 10), (11, 8), channels=3)
    params = RealtimeParams(levels=2, iterations=(1,), warm_iterations=2)
    host = make_session(case, params)
    device = make_session(case, params, passes=gpu_cuda.realtime)
    np.testing.assert_array_equal(device.frame(), host.frame())
    np.testing.assert_array_equal(device.frame(warm=True), host.frame(warm=True))
