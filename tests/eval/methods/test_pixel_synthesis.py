"""The pixel-based rival."""

import numpy as np
import pytest
from small_textures import spots

from eval.methods.pixel_synthesis import PixelSynthesis
from eval.metrics.pieces import piece_sizes
from eval.textures import Texture


def synthesized(exemplar, jitter, seed=0):
    return PixelSynthesis("pixels", jitter).run(Texture("t", exemplar, (72, 80)), seed)


@pytest.fixture(scope="module")
def outcome():
    return synthesized(spots(2), 1.0)


@pytest.mark.slow
def test_every_pixel_is_one_of_the_exemplar(outcome):
    y, x = np.moveaxis(outcome.coordinates[..., 1:] // 4, 2, 0)
    np.testing.assert_array_equal(outcome.image, spots(2)[y, x])
    assert outcome.image.shape == (72, 80, 3)


def test_the_seed_decides(outcome):
    np.testing.assert_array_equal(outcome.image, synthesized(spots(2), 1.0).image)
    assert (outcome.image != synthesized(spots(2), 1.0, 1).image).any()


def test_low_jitter_repeats_the_exemplar():
    low, high = (piece_sizes(synthesized(spots(2), jitter).coordinates) for jitter in (0.0, 1.0))
    assert low.max() > 1.5 * high.max()


def test_correction_leaves_fewer_breaks_than_jitter_makes(outcome):
    steps = np.diff(outcome.coordinates, axis=1)
    assert (steps == [0, 0, 4]).all(axis=2).mean() > 0.3
