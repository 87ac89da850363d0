"""The dynamic programming in blocks equals the CPU's, bit for bit."""

import numpy as np
import pytest
from signatures import signature

import gpu_cuda
import gpu_cuda.texture
from gpu_cuda.host.device import SIMULATED
from gpu_cuda.texture.best_cuts import in_blocks
from gpu_cuda.texture.blocks import Blocks
from stylit_ref.texture import passes
from stylit_ref.texture.formulae.polar import BLOCKED

ROWS = 8 if SIMULATED else 300


def tables(rng, patches, rows, columns, max_jump, largest=1000):
    """Random costs of crossings, of both signs, and random running sums of steps."""
    padded = columns + 2 * max_jump
    crossing = np.full((rows, patches, padded), BLOCKED, np.int32)
    inside = np.s_[:, :, max_jump : max_jump + columns]
    crossing[inside] = rng.integers(-largest // 3, largest, crossing[inside].shape)
    sums = rng.integers(0, largest // 4, crossing[inside].shape).cumsum(axis=2)
    steps = np.zeros_like(crossing)
    steps[inside] = sums
    steps[:, :, max_jump + columns :] = sums[:, :, -1:]
    return crossing.reshape(rows, -1), steps.reshape(rows, -1)


def outputs(module, best_cuts, crossing, steps, max_jump, arrivals, patches):
    """T, the paths and their costs, computed by a module of passes."""
    rows, size = crossing.shape
    shapes = (rows + 1, size), (patches, rows), (patches,)
    given = [module.upload(array) for array in (crossing, steps, arrivals)]
    found = [module.upload(np.full(shape, -7, np.int32)) for shape in shapes]
    best_cuts(*given[:2], max_jump, given[2], *found)
    return [module.download(array) for array in found]


class OnHost:
    upload = staticmethod(np.array)
    download = staticmethod(np.asarray)


def assert_equal_cuts(blocks, *arguments):
    host = outputs(OnHost, passes.best_cuts, *arguments)
    device = outputs(gpu_cuda, lambda *given: in_blocks(blocks, *given), *arguments)
    for ours, theirs in zip(device, host, strict=True):
        np.testing.assert_array_equal(ours, theirs)
    return host


def test_names_and_signatures_mirror_the_passes():
    assert gpu_cuda.texture.__all__ == passes.__all__
    for name in passes.__all__:
        ours, theirs = getattr(gpu_cuda.texture, name), getattr(passes, name)
        assert signature(ours) == signature(theirs)


@pytest.mark.parametrize(
    ("max_jump", "columns", "blocks"),
    [
        (1, 1, Blocks(4, 3, 3)),
        (1, 7, Blocks(4, 1, 2)),
        (1, 14, Blocks(8, 3, 3)),
        (4, 1, Blocks(5, 3, 2)),
        (4, 7, Blocks(16, 1, 3)),
        (4, 18, Blocks(7, 3, 3)),
        (4, 19, Blocks(9, 20, 4)),
        (16, 7, Blocks(13, 1, 3)),
        (16, 18, Blocks(20, 3, 3)),
    ],
)
def test_blocks_of_any_size_give_the_bytes_of_the_cpu(max_jump, columns, blocks):
    """Widths that are no multiple of the block's, with the padding on either side."""
    rng = np.random.default_rng(1000 * max_jump + columns)
    given = tables(rng, 3, ROWS, columns, max_jump)
    arrivals = rng.integers(0, 2000, given[0].shape[1], dtype=np.int32)
    _, paths, costs = assert_equal_cuts(blocks, *given, max_jump, arrivals, 3)
    assert costs.min() < BLOCKED // 2
    assert 0 <= paths.min() <= paths.max() < columns


@pytest.mark.parametrize("max_jump", [1, 4])
def test_the_default_blocks(max_jump):
    rng = np.random.default_rng(7)
    crossing, steps = tables(rng, 2, 5, 40, max_jump)
    given = crossing, steps, max_jump, np.zeros_like(crossing[0]), 2
    host = outputs(OnHost, passes.best_cuts, *given)
    device = outputs(gpu_cuda, gpu_cuda.texture.best_cuts, *given)
    for ours, theirs in zip(device, host, strict=True):
        np.testing.assert_array_equal(ours, theirs)


def test_of_equal_paths_that_on_the_left_is_taken():
    crossing, steps = tables(np.random.default_rng(3), 4, ROWS, 9, 2, largest=5)
    assert_equal_cuts(Blocks(5, 2, 2), crossing, steps, 2, np.zeros_like(crossing[0]), 4)


def test_where_all_is_blocked_the_path_stays_in_the_table():
    crossing, steps = tables(np.random.default_rng(4), 2, ROWS, 6, 2)
    crossing[3, : crossing.shape[1] // 2] = BLOCKED
    steps[:] = 0
    given = crossing, steps, 2, np.zeros_like(crossing[0]), 2
    _, paths, costs = assert_equal_cuts(Blocks(4, 2, 2), *given)
    assert costs[0] >= BLOCKED // 2 > costs[1]
    assert 0 <= paths.min() <= paths.max() < 6


def test_the_second_pass_begins_with_what_the_first_paid_to_arrive():
    crossing, steps = tables(np.random.default_rng(5), 3, ROWS, 8, 2)
    blocks, arrivals = Blocks(4, 3, 2), np.zeros_like(crossing[0])
    totals, _, _ = assert_equal_cuts(blocks, crossing, steps, 2, arrivals, 3)
    ends = totals[-1].reshape(3, -1)
    arrivals = np.minimum(ends - ends.min(axis=1, keepdims=True), BLOCKED).ravel()
    assert_equal_cuts(blocks, crossing, steps, 2, arrivals, 3)


def test_the_alignment_is_found_by_the_same_kernels():
    """J is 1, and the steps are running sums of one penalty, or zero."""
    for penalty in (0, 40):
        crossing, _ = tables(np.random.default_rng(6), 3, ROWS, 11, 1)
        sums = np.tile(np.arange(13, dtype=np.int32) * penalty, 3)
        steps = np.ascontiguousarray(np.broadcast_to(sums, crossing.shape))
        arrivals = np.zeros_like(crossing[0])
        _, shifts, _ = assert_equal_cuts(Blocks(5, 4, 2), crossing, steps, 1, arrivals, 3)
        assert (np.abs(np.diff(shifts, axis=1)) <= 1).all()


def test_the_printed_height_is_no_height_and_ours_is():
    """At most half of what a block computes is for its padding."""
    for max_jump in range(1, 65):
        columns, rows, threads = Blocks.default(max_jump)
        assert columns == 32 + max_jump
        computed = sum(columns + 2 * max_jump * (rows - n) for n in range(1, rows + 1))
        assert computed <= 2 * columns * rows
        assert rows >= 1
        assert threads % 32 == 0
