"""The kernels of coherence equal the CPU's passes, bit for bit."""

import numpy as np
import pytest
from numba import cuda
from scipy.ndimage import maximum_filter
from signatures import signature

import gpu_cuda.views
from stylit_ref.views import passes

SIZES = (7, 9), (1, 1), (1, 8), (11, 1)


def test_names_and_signatures_mirror_the_passes():
    assert gpu_cuda.views.__all__ == passes.__all__
    for name in passes.__all__:
        ours, theirs = getattr(gpu_cuda.views, name), getattr(passes, name)
        assert signature(ours) == signature(theirs)


def written(name, *arguments, outputs=1):
    """What both write to the last arguments, which must be the same; the last of these."""
    theirs = [
        cuda.to_device(argument) if isinstance(argument, np.ndarray) else argument
        for argument in arguments
    ]
    getattr(passes, name)(*arguments)
    getattr(gpu_cuda.views, name)(*theirs)
    for ours, found in zip(arguments[-outputs:], theirs[-outputs:], strict=True):
        np.testing.assert_array_equal(found.copy_to_host(), ours)
    return arguments[-1]


def motion(rng, size, longest=2.0):
    """A field with halves, and with vectors that are no numbers or lead far away."""
    field = np.round(rng.uniform(-longest, longest, (*size, 2)) * 4).astype(np.float32) / 4
    awkward = rng.choice([np.nan, np.inf, -np.inf, 1e30, -0.0, 3e6], field.shape)
    field = np.where(rng.random((*size, 1)) < 0.2, awkward, field).astype(np.float32)
    return field, rng.random(size) < 0.9


def places_of(field, visible, depth=0):
    size = tuple(side >> depth for side in visible.shape)
    return written("shift_map", field, visible, depth, np.full((*size, 2), -7, np.int32))


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("depth", [0, 1, 2])
def test_shift_map(size, depth):
    size = tuple(side << depth for side in size)
    places_of(*motion(np.random.default_rng(depth), size, 3.0 * 2**depth), depth)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("channels", [1, 3])
def test_shifted_and_folded_pictures(size, channels):
    rng = np.random.default_rng(channels)
    own, *pictures = rng.integers(0, 256, (4, *size, channels), np.uint8)
    guides = np.zeros((3, *size, channels), np.uint8)
    for picture, guide in zip(pictures, guides, strict=True):
        written("shift_picture", picture, places_of(*motion(rng, size)), own, guide)
    mixed, spreads = np.zeros_like(own), np.zeros((*size, 1), np.uint8)
    for weights in ([128, 128, 128], [0, 1, 256], [64 << 8] * 3):
        written("fold", own, guides, np.array(weights), mixed, spreads, outputs=2)


@pytest.mark.parametrize("size", SIZES)
def test_motion_that_cancels(size):
    rng = np.random.default_rng(5)
    field, visible = motion(rng, size, 1.0)
    back = np.round(-field + rng.uniform(-1, 1, field.shape)).astype(np.float32)
    places = places_of(field, visible)
    known = rng.random(size) < 0.8
    written("cancel", field, places, back, known, np.zeros(size, np.bool_))


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("reach", [1, 3])
def test_silhouettes(size, reach):
    rng = np.random.default_rng(reach)
    inverse = rng.choice([0.0, 0.5, 0.51, 1.0, 1.04, 2.0], size)
    rims = written("find_rims", inverse, np.zeros(size, np.bool_))
    is_close = maximum_filter(rims, 2 * reach + 1)
    written("take_nearer", inverse, rims, is_close, reach, np.zeros((*size, 2), np.int32))


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("depths", [[1.0], [0.0, -0.0, 2.0], [np.inf], [1.0, 2.0, np.inf]])
def test_splatting(size, depths):
    """Many pixels land on few, with depths that are equal or infinite."""
    rng = np.random.default_rng(len(depths))
    field, visible = motion(rng, size)
    middle = np.stack(np.mgrid[: size[0], : size[1]][::-1], axis=-1)
    crowd = rng.random(size) < 0.5
    field[crowd] = (np.array(size[::-1]) // 2 - middle)[crowd] + rng.choice([-0.25, 0, 0.25])
    places = places_of(field, visible)
    depth = rng.choice(depths, size).astype(np.float32)
    winners = written("splat", field, places, depth, np.full((*size, 2), -7, np.int32))
    beaten, contested = np.ones((2, *size), np.bool_)
    written("find_beaten", field, places, winners, beaten, contested, outputs=2)
