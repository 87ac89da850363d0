"""The numbers of image energy on input made by hand."""

import numpy as np
import pytest
from small_scene import small_scene

from eval.metrics.image_energy import image_energy, masks_apart, measure
from eval.outcome import Outcome
from eval.scenes import Scene


def scene(**sizes):
    style, sources, targets = small_scene(**sizes)
    return Scene("small", None, ("a", "b"), style, tuple(sources), tuple(targets), 1)


def test_image_energy_of_a_copy_is_zero():
    copy = scene()
    copy = Scene("copy", None, ("a", "b"), copy.style, copy.source_guides, copy.source_guides, 1)
    energy = image_energy(copy, copy.style)
    assert energy.mean < 1
    assert energy.distinct > 0.999


def test_image_energy_is_the_mean_of_the_best_matches():
    """Against all source patches, one by one."""
    small = scene(source_size=(12, 13), target_size=(11, 10))
    image = np.random.default_rng(3).integers(0, 256, (11, 10, 3), dtype=np.uint8)
    best = []
    for y in range(2, 9):
        for x in range(2, 8):
            p = np.s_[y - 2 : y + 3, x - 2 : x + 3]
            costs = []
            for source_y in range(2, 10):
                for source_x in range(2, 11):
                    q = np.s_[source_y - 2 : source_y + 3, source_x - 2 : source_x + 3]
                    cost = ((image[p].astype(float) - small.style[q]) ** 2).sum() / 3
                    for source, target in zip(
                        small.source_guides, small.target_guides, strict=True
                    ):
                        cost += 2 / 4 * ((target[p].astype(float) - source[q]) ** 2).sum()
                    costs.append(cost)
            best.append(min(costs))
    assert image_energy(small, image).mean == pytest.approx(np.mean(best), rel=0.02)


def masked(source, target):
    """A scene whose two masks are these, (H, W) bool each."""
    style, sources, targets = small_scene(source_size=source.shape, target_size=target.shape)
    pair = tuple(
        np.repeat(255 * mask[..., None].astype(np.uint8), 3, axis=2) for mask in (source, target)
    )
    buffers = {"IDMASK": pair, "LIGHTMASK": (pair[0], pair[0])}
    return Scene(
        "masked", None, ("a", "b"), style, tuple(sources), tuple(targets), 1, buffers=buffers
    )


def test_energy_is_split_where_masks_differ():
    source = np.zeros((16, 18), bool)
    target = source.copy()
    target[5:9, 4:11] = True
    scene = masked(source, target)
    assert np.array_equal(masks_apart(scene), target)
    image = np.random.default_rng(3).integers(0, 256, (16, 18, 3), dtype=np.uint8)
    numbers = measure(scene, Outcome(image, 0.0))
    delta = image_energy(scene, image).delta
    inner = target[2:-2, 2:-2]
    assert numbers["energy_apart"] == delta[inner].mean()
    assert numbers["energy_alike"] == delta[~inner].mean()
    assert numbers["median_energy"] == np.median(delta)


def test_masks_of_other_sizes_are_not_compared():
    assert masks_apart(masked(np.zeros((12, 13), bool), np.zeros((11, 10), bool))) is None
    small = scene()
    assert "energy_apart" not in measure(small, Outcome(small.target_guides[0], 0.0))
