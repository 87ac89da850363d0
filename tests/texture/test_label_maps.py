"""Which exemplar a part of the texture comes from."""

import hashlib

import numpy as np
import pytest
from small_textures import quick, spots

from stylit_ref import InputError, synthesize_texture
from stylit_ref.texture.label_maps import labels_by_shares, with_free_borders
from stylit_ref.texture.session import TextureSession

EXEMPLARS = [spots(1), spots(2, 40), spots(3, 44)]


def deep(labels, reach):
    """Brute force: pixels whose neighbours up to ``reach`` have the same label, on a torus."""
    height, width = labels.shape
    inside = np.ones(labels.shape, np.bool_)
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            if dy**2 + dx**2 <= reach**2:
                y, x = np.ix_((np.arange(height) + dy) % height, (np.arange(width) + dx) % width)
                inside &= labels[y, x] == labels
    return inside


def labels_of(height, width, seed=0):
    return labels_by_shares([1, 1, 1], 3, (height, width), seed)


def test_borders_are_free_within_four_pixels():
    labels = labels_of(30, 41)
    expected = np.where(deep(labels, 4), labels, 0)
    assert np.array_equal(with_free_borders(labels), expected)


@pytest.mark.parametrize("seed", range(2))
def test_pixels_far_from_a_border_come_from_their_exemplar(seed):
    labels = labels_of(64, 80, seed)
    result = synthesize_texture(EXEMPLARS, (64, 80), quick(), seed=seed, labels=labels)
    far = deep(labels, 4)
    assert far.any()
    assert (result.coordinates[..., 0] + 1 == labels)[far].all()
    assert sum(each.accepted for each in result.history) > 0
    assert result.history[-1].cost < 0.1 * result.history[0].cost


def test_the_running_cost_is_the_recount_with_labels():
    session = TextureSession(EXEMPLARS, (64, 80), quick(), labels=labels_of(64, 80))
    accepted = 0
    for _ in range(6):
        accepted += session.step().accepted
        assert session.cost == session.recount()
    assert accepted


@pytest.mark.parametrize("shares", [(0.3, 0.7), (1, 2, 5)])
def test_shares_are_met(shares):
    labels = labels_by_shares(shares, len(shares), (50, 61), 3)
    found = np.bincount(labels.ravel(), minlength=len(shares) + 1)[1:] / labels.size
    assert np.allclose(found, np.array(shares) / sum(shares), atol=1 / labels.size)


@pytest.mark.parametrize("size", [(40, 48), (96, 96)])
def test_a_texture_has_its_shares_within_two_points(size):
    result = synthesize_texture(EXEMPLARS[:2], size, quick(), shares=(0.3, 0.7))
    assert abs((result.coordinates[..., 0] == 0).mean() - 0.3) < 0.02


def test_maps_drawn_for_shares_are_smooth_also_across_the_border():
    labels = labels_by_shares((0.5, 0.5), 2, (96, 96), 1)
    steps = [labels != np.roll(labels, 1, axis) for axis in (0, 1)]
    assert max(step.mean() for step in steps) < 0.06
    assert all(step.any() for step in steps)
    assert steps[0][0].mean() < 0.2
    assert steps[1][:, 0].mean() < 0.2


def test_the_map_of_a_seed_is_pinned():
    drawn = labels_by_shares((0.2, 0.3, 0.5), 3, (40, 56), 7)
    assert hashlib.sha256(drawn.tobytes()).hexdigest()[:16] == "ad4146825e238f99"


@pytest.mark.parametrize("size", [(1, 40), (40, 1), (1, 1)])
def test_thin_textures_have_shares_too(size):
    assert labels_by_shares((1, 1), 2, size, 0).shape == size


@pytest.mark.parametrize(
    ("named", "said"),
    [
        ({"labels": np.ones((64, 79), np.uint8)}, "labels is uint8 of the shape (64, 79)"),
        ({"labels": np.ones((64, 80), np.int32)}, "labels is int32 of the shape (64, 80)"),
        (
            {"labels": np.full((64, 80), 4, np.uint8)},
            "labels has the label 4, but there are 3 exemplars; give one for every label",
        ),
        ({"shares": (1, 2)}, "shares is [1, 2]; it must be a number above 0 for each of the 3"),
        ({"shares": (1, 2, 0)}, "shares is [1, 2, 0]"),
        (
            {"shares": (1, 1, 1), "labels": np.ones((64, 80), np.uint8)},
            "shares cannot be given with labels",
        ),
    ],
)
def test_maps_and_shares_that_do_not_fit_are_refused(named, said):
    with pytest.raises(InputError) as error:
        synthesize_texture(EXEMPLARS, (64, 80), quick(), **named)
    assert str(error.value).startswith(said)
