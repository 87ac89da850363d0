"""Each number of the reports on input made by hand."""

import numpy as np
import pytest
from skimage.filters import gaussian
from small_level import make_level
from small_scene import small_scene

from eval.image_analogies import ImageAnalogies, image_analogies
from eval.image_energy import image_energy
from eval.patch_distribution import patch_distance
from eval.scenes import Scene
from eval.sharpness import detail, richness, sharpness
from eval.similarity import flip, psnr, ssim
from eval.spilling import spilling
from eval.split_delta import split_delta
from eval.unbounded_search import UNBOUNDED
from eval.usage import coverage, distinct_patches, peak_usage, usage_entropy
from stylit_ref import passes, replay
from stylit_ref.randomness.random_stream import RANDOM_SEARCH, random_stream


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


def test_detail_sees_high_frequencies_only():
    ramp = np.tile(np.arange(0, 128, 2, dtype=np.uint8), (64, 1))
    board = (np.indices((64, 64)).sum(axis=0) % 2 * 100).astype(np.uint8)
    assert detail(ramp)[8:-8, 8:-8].max() < 1e-6
    assert detail(board)[8:-8, 8:-8].min() > 2000


def test_sharpness_is_one_for_a_copy_and_falls_with_blur():
    style = scene().style
    nnf = np.stack(np.mgrid[:40, :46], axis=-1)
    assert sharpness(style, style, nnf) == pytest.approx(1)
    blurred = gaussian(style, 0.8, channel_axis=2, preserve_range=True).astype(np.uint8)
    assert sharpness(blurred, style, nnf) < 0.5


def test_richness_falls_where_smooth_parts_are_preferred():
    style = scene().style.copy()
    style[:, 23:] = 128
    nnf = np.full((40, 46, 2), (20, 38), np.int32)
    smooth = replay(nnf, style)
    assert richness(style, style) == pytest.approx(1)
    assert richness(smooth, style) < 0.01


def test_usage():
    omega = np.array([[0, 0], [4, 12]], np.int32)
    assert coverage(omega) == 0.5
    assert peak_usage(omega, target_patches=16, patch_width=1) == 3
    nnf = np.array([[[1, 2], [1, 2]], [[3, 2], [2, 1]]], np.int32)
    assert distinct_patches(nnf) == 0.75


def test_psnr_and_ssim():
    image = scene().style
    shifted = np.where(image > 127, image - 10, image + 10).astype(np.uint8)
    assert psnr(image, image) == np.inf
    assert psnr(shifted, image) == pytest.approx(20 * np.log10(255 / 10))
    assert ssim(image, image) == pytest.approx(1)
    assert (
        ssim(gaussian(image, 3, channel_axis=2, preserve_range=True).astype(np.uint8), image) < 0.7
    )


def test_spilling_is_where_source_and_target_are_different_things():
    source_ids = np.zeros((4, 6, 3), np.uint8)
    source_ids[:, 3:, 1] = 255
    target_ids = np.zeros((2, 3, 3), np.uint8)
    target_ids[1, :, 1] = 255
    nnf = np.array([[[0, 0], [1, 2], [2, 3]], [[3, 3], [0, 5], [3, 2]]], np.int32)
    expected = [[False, False, True], [False, False, True]]
    np.testing.assert_array_equal(spilling(nnf, (source_ids, target_ids)), expected)


@pytest.mark.parametrize(
    "case",
    [
        {},
        {"smooth": True, "epsilon": 520, "uniformity": 200},
        {"patch_width": 7, "epsilon": 1e12, "uniformity": 0, "flat_style": True},
    ],
    ids=str,
)
def test_the_search_without_the_bound_finds_the_same(case):
    level = make_level(target_size=(30, 33), **case)
    found = []
    for module in (passes, UNBOUNDED):
        new_nnf, new_delta = level.nnf.copy(), level.delta.copy()
        module.random_search(
            level.textures, level.omega_sums, level.occurrence_weight, level.patch_width,
            level.nnf, level.delta, new_nnf, new_delta, random_stream(2, RANDOM_SEARCH, 1),
        )  # fmt: skip
        found.append((new_nnf, new_delta))
    for bounded, unbounded in zip(*found, strict=True):
        np.testing.assert_array_equal(bounded, unbounded)
    assert (found[0][0] != level.nnf).any()


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


def test_split_delta_is_that_of_the_guides_and_that_of_the_style():
    small = scene(source_size=(14, 15), target_size=(11, 10))
    rng = np.random.default_rng(5)
    image = rng.integers(0, 256, (11, 10, 3), dtype=np.uint8)
    nnf = rng.integers(2, 12, (11, 10, 2)).astype(np.int32)
    expected = np.zeros(2)
    pairs = [*zip(small.source_guides, small.target_guides, strict=True), (small.style, image)]
    for kind, source, target in zip((0, 0, 1), *zip(*pairs, strict=True), strict=True):
        padded = np.pad(target.astype(float), ((2, 2), (2, 2), (0, 0)), mode="edge")
        for y, x in np.ndindex(11, 10):
            q_y, q_x = nnf[y, x]
            patch = source[q_y - 2 : q_y + 3, q_x - 2 : q_x + 3]
            squares = ((padded[y : y + 5, x : x + 5] - patch) ** 2).sum()
            # μ = 2 over the 4 guide channels, 1 over the 3 of the style
            expected[kind] += squares * (2 / 4, 1 / 3)[kind] / 110
    np.testing.assert_allclose(split_delta(small, image, nnf), expected, rtol=1e-4)


def test_usage_entropy_is_one_where_every_pixel_is_used_alike():
    assert usage_entropy(np.full((4, 5), 25)) == pytest.approx(1)
    one = np.zeros((4, 5), int)
    one[2, 3] = 500
    assert usage_entropy(one) == 0
    half = np.zeros((4, 4), int)
    half[:2] = 7
    assert usage_entropy(half) == pytest.approx(np.log(8) / np.log(16))


def test_flip_is_none_for_the_same_image_and_one_for_the_most_different():
    """Green and blue, by which its colour difference is scaled."""
    image = np.zeros((40, 50, 3), np.uint8)
    green, blue = image + np.uint8([0, 255, 0]), image + np.uint8([0, 0, 255])
    assert flip(image, image) == 0
    assert flip(green, blue) == pytest.approx(1, abs=1e-3)
    assert 0 < flip(image + np.uint8(8), image) < flip(image + np.uint8(90), image) < 1
    assert flip(image[:, :, :1] + np.uint8(90), image[:, :, :1]) == flip(
        image + np.uint8(90), image
    )


@pytest.mark.slow
def test_image_analogies_of_the_source_are_the_style():
    """Each pixel's neighbourhood is found again where it is."""
    rng = np.random.default_rng(2)
    guide, style = (rng.integers(0, 256, (24, 26, 3), dtype=np.uint8) for _ in range(2))
    arrays, facts = image_analogies(style, [guide], [guide], ImageAnalogies(levels=2))
    np.testing.assert_array_equal(arrays["image"], style)
    np.testing.assert_array_equal(arrays["nnf"], np.moveaxis(np.indices((24, 26)), 0, 2))
    assert arrays["omega"].tolist() == np.ones((24, 26)).tolist()
    assert facts["seconds"] > 0


@pytest.mark.slow
def test_coherence_continues_what_was_taken_before():
    """Smooth guides leave the choice open; the larger κ, the larger the pieces."""
    style, sources, targets = small_scene()
    pieces = []
    for coherence in (0.0, 1.0, 20.0):
        params = ImageAnalogies(coherence=coherence, levels=3)
        nnf = image_analogies(style, sources, targets, params)[0]["nnf"]
        pieces.append((np.diff(nnf, axis=1) == (0, 1)).all(axis=2).mean())
    assert pieces == sorted(pieces)
    assert pieces[2] > pieces[0] + 0.2
