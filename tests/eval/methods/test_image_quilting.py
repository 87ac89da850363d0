"""Image quilting against what can be said by hand, and against brute force."""

import itertools

import numpy as np
import pytest

from data_gen.textures import make_texture
from eval.methods.image_quilting import ImageQuilting, _Search, cheapest_cut, quilt
from stylit_ref import InputError


@pytest.mark.parametrize("seed", range(4))
def test_the_cut_is_the_cheapest_of_all(seed):
    costs = np.random.default_rng(seed).integers(0, 100, (5, 4))
    paths = [
        path
        for path in itertools.product(range(4), repeat=5)
        if all(abs(a - b) <= 1 for a, b in itertools.pairwise(path))
    ]
    least = min(sum(costs[y, x] for y, x in enumerate(path)) for path in paths)
    found = cheapest_cut(costs)
    assert costs[np.arange(5), found].sum() == least
    assert np.abs(np.diff(found)).max() <= 1


def test_errors_are_sums_of_squared_differences():
    rng = np.random.default_rng(1)
    image = rng.integers(0, 256, (14, 11, 3), dtype=np.uint8)
    block, covered = image[2:7, 3:8].copy(), rng.random((5, 5)) < 0.6
    errors = _Search(image, 5).errors(block, covered)
    for y, x in np.ndindex(10, 7):
        difference = image[y : y + 5, x : x + 5].astype(int) - block
        assert errors[y, x] == (difference[covered] ** 2).sum()


def test_a_quilt_has_the_size_asked_for_and_the_same_bytes_again():
    exemplar = make_texture("pebbles", 96)
    quilts = [quilt(exemplar, (100, 130), ImageQuilting(), seed) for seed in (3, 3, 4)]
    assert quilts[0].shape == (100, 130, 3)
    np.testing.assert_array_equal(quilts[0], quilts[1])
    assert (quilts[0] != quilts[2]).any()


def test_a_periodic_exemplar_is_continued_without_a_seam():
    y, x = np.mgrid[:60, :60]
    exemplar = np.uint8(40 * (y % 5) + 10 * (x % 4))[:, :, None]
    coordinates = quilt(exemplar, (80, 90), ImageQuilting(block=20, overlap=6, tolerance=0), 1)
    image = exemplar[coordinates[..., 1] // 4, coordinates[..., 2] // 4]
    np.testing.assert_array_equal(image[5:], image[:-5])
    np.testing.assert_array_equal(image[:, 4:], image[:, :-4])


def test_an_exemplar_smaller_than_a_block_is_one_sentence():
    with pytest.raises(InputError, match="at least 48 x 48 pixels"):
        quilt(np.zeros((30, 60, 3), np.uint8), (64, 64), ImageQuilting(), 0)
