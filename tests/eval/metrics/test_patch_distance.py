"""The numbers of patch distance on input made by hand."""

import numpy as np
import pytest
from skimage.filters import gaussian
from small_scene import small_scene

from eval.metrics.patch_distance import patch_distance


def test_patch_distance_knows_what_patches_there_are_not_where():
    style, _, _ = small_scene(source_size=(60, 60))
    assert patch_distance(style, style) == 0
    rolled = np.ascontiguousarray(np.roll(style, (20, 31), axis=(0, 1)))
    blurred = gaussian(style, 2, channel_axis=2, preserve_range=True).astype(np.uint8)
    assert patch_distance(rolled, style) < 0.2 * patch_distance(blurred, style)


def test_patch_distance_of_two_constants_is_how_far_they_are_apart():
    """A direction u of 75 sees a step of 9 times the sum of its parts: 9 in the mean square."""
    black, grey = np.zeros((8, 9, 3), np.uint8), np.full((8, 9, 3), 9, np.uint8)
    rng = np.random.RandomState(0)
    directions = rng.normal(0, 1, (75, 64))
    directions /= np.linalg.norm(directions, axis=0)
    expected = 9 * np.sqrt((directions.sum(axis=0) ** 2).mean())
    assert patch_distance(black, grey) == pytest.approx(expected)
