"""The metrics of textures: what is bad gets a bad number, and what only looks so does not."""

import numpy as np
import pytest

from data_gen.textures import make_texture
from eval.metrics import METRICS
from eval.metrics.border import border
from eval.metrics.nearest_patch import nearest_patch
from eval.metrics.pieces import piece_sizes
from eval.metrics.repetition import repetition
from eval.metrics.seam_cost import seam_cost
from eval.metrics.sliced_wasserstein import sliced_wasserstein
from eval.outcome import Outcome
from eval.textures import Texture

pytestmark = pytest.mark.slow

SIDE = 192
SMALL = 128

NUMBERS = {
    "seam_cost": lambda exemplar, outcome: seam_cost(exemplar, outcome.coordinates),
    "sw": lambda exemplar, outcome: sliced_wasserstein(outcome.image, exemplar),
    "novelty": lambda exemplar, outcome: nearest_patch(outcome.image, exemplar),
    "omission": lambda exemplar, outcome: nearest_patch(exemplar, outcome.image),
    "piece": lambda exemplar, outcome: piece_sizes(outcome.coordinates).max(),
    "repetition": lambda exemplar, outcome: repetition(outcome.coordinates),
    "border": lambda exemplar, outcome: border(outcome.image),
}


@pytest.fixture(scope="module")
def exemplar():
    return make_texture("flowers", SMALL)


def outcome(exemplar, y, x):
    coordinates = np.stack([np.zeros_like(y), 4 * y, 4 * x], axis=-1).astype(np.int32)
    return Outcome(exemplar[y, x], 0.0, coordinates=coordinates)


def plain():
    """The exemplar and its mirror images: it tiles, and nothing is missing or too frequent."""
    line = np.arange(SMALL)
    line = np.concatenate([line, line[::-1]])
    return np.meshgrid(line, line, indexing="ij")


def empty():
    """One pixel everywhere."""
    return (np.full((SIDE, SIDE), 40),) * 2


def copied():
    """One block of grass and a flower, side by side."""
    line = 20 + np.arange(SIDE) % 32
    return np.meshgrid(line, line, indexing="ij")


def shuffled():
    """The exemplar's pixels in random order."""
    rng = np.random.default_rng(1)
    return np.divmod(rng.permutation(SMALL**2).reshape(SMALL, SMALL), SMALL)


def seams():
    """Blocks of 64 pixels from anywhere."""
    rng = np.random.default_rng(2)
    corners = rng.integers(0, SMALL - 64, (2, SIDE // 64, SIDE // 64))
    y, x = np.mgrid[:SIDE, :SIDE]
    corner_y, corner_x = corners[:, y // 64, x // 64]
    return y % 64 + corner_y, x % 64 + corner_x


BAD = {
    (empty, "sw"): 10,
    (empty, "novelty"): 8,
    (empty, "omission"): 5,
    (empty, "repetition"): 0.9,
    (copied, "sw"): 3,
    (copied, "omission"): 4,
    (copied, "repetition"): 0.9,
    (copied, "border"): 1.6,
    (shuffled, "sw"): 5,
    (shuffled, "novelty"): 10,
    (shuffled, "omission"): 10,
    (shuffled, "seam_cost"): 100,
    (seams, "seam_cost"): 5,
    (seams, "border"): 1.6,
}
"""What each number is at least where it must say bad."""


@pytest.mark.parametrize(("make", "name"), BAD, ids=lambda each: getattr(each, "__name__", each))
def test_a_bad_texture_has_a_bad_number(make, name, exemplar):
    measure = NUMBERS[name]
    bad = measure(exemplar, outcome(exemplar, *make()))
    assert bad >= BAD[make, name]
    if name != "seam_cost":  # mirrored pieces do not continue each other
        assert measure(exemplar, outcome(exemplar, *plain())) < BAD[make, name] / 1.5


@pytest.mark.parametrize(
    ("make", "size"),
    [(empty, 1), (shuffled, 2), (copied, 32**2), (seams, 64**2), (plain, SMALL**2)],
)
def test_pieces_tell_confetti_from_large_blocks_and_from_a_whole_copy(make, size, exemplar):
    assert NUMBERS["piece"](exemplar, outcome(exemplar, *make())) == size


def test_an_empty_texture_has_no_seams_so_that_these_alone_mislead(exemplar):
    flat = exemplar.copy()
    flat[30:50, 30:50] = (60, 110, 50)
    grey = outcome(flat, *empty())
    assert seam_cost(flat, grey.coordinates) == 0
    assert border(grey.image) == 1


def test_the_exemplar_itself_costs_nothing(exemplar):
    whole = outcome(exemplar, *np.mgrid[:SMALL, :SMALL])
    assert seam_cost(exemplar, whole.coordinates) == 0
    assert nearest_patch(whole.image, exemplar) == 0
    assert sliced_wasserstein(whole.image, exemplar) < 1.5
    assert piece_sizes(whole.coordinates).tolist() == [SMALL**2]
    assert repetition(whole.coordinates) == 0


def test_a_seam_costs_what_the_paper_says():
    exemplar = np.zeros((1, 6, 3), np.uint8)
    exemplar[0, :, 0] = (10, 20, 40, 90, 200, 250)
    here_then_there = np.zeros((1, 2, 3), np.int32)
    here_then_there[0, :, 2] = (4 * 1, 4 * 4)  # 20, followed by 200
    difference = (20 - 90) ** 2 + (200 - 40) ** 2
    gradients = (20 - 40) ** 2 + (200 - 90) ** 2
    expected = (difference / (1000 + gradients)) ** 2 / 2
    assert seam_cost(exemplar, here_then_there) == pytest.approx(expected, abs=1 / 256)


def test_pieces_are_connected_and_copied_without_a_change():
    coordinates = outcome(np.zeros((40, 40, 1), np.uint8), *np.mgrid[:20, :30]).coordinates
    assert piece_sizes(coordinates).tolist() == [600]
    coordinates[:, 12:, 2] += 4
    assert sorted(piece_sizes(coordinates)) == [240, 360]
    coordinates[:, 12:, 1] += 1  # a quarter of a pixel lower
    assert sorted(piece_sizes(coordinates)) == [240, 360]
    coordinates[3:9, 5] += 80
    assert sorted(piece_sizes(coordinates)) == [6, 234, 360]


def test_repetition_counts_the_pixels_that_one_shift_repeats():
    y, x = np.mgrid[:30, :40]
    x[:10, 15:25] = x[:10, :10]
    y[:10, 15:25] = y[:10, :10]
    assert repetition(outcome(np.zeros((40, 40, 1), np.uint8), y, x).coordinates) == 100 / 1200


def test_the_sliced_distance_is_that_of_the_means_for_flat_pictures():
    dark, light = (np.full((20, 20, 1), value, np.uint8) for value in (50, 90))
    rng = np.random.default_rng(3)
    sums = np.abs(rng.normal(size=(20000, 49))) * np.sign(rng.normal(size=(20000, 49)))
    directions = sums / np.linalg.norm(sums, axis=1, keepdims=True)
    expected = 40 * np.abs(directions.sum(axis=1)).mean()
    assert sliced_wasserstein(dark, light) == pytest.approx(expected, rel=0.2)


def test_metrics_give_what_they_declare_and_nothing_without_coordinates(exemplar):
    texture = Texture("flowers", exemplar, (SMALL, SMALL))
    whole = outcome(exemplar, *np.mgrid[:SMALL, :SMALL])
    alone = Outcome(whole.image, 0.0)
    names = (
        "border", "nearest_patch", "pieces", "repetition", "seam_cost", "sliced_wasserstein",
    )  # fmt: skip
    for name in names:
        metric = METRICS[name]
        assert metric.measure(texture, whole).keys() == metric.NUMBERS.keys()
    found = [metric for name in names for metric in METRICS[name].measure(texture, alone)]
    assert found == ["border", "novelty", "omission", "sw"]
