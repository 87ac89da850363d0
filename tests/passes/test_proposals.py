"""Propagation and random search decide as the plain formula would.

The passes use the exact savings of ``metric/fast_metric.py``; the oracle evaluates φ in full.
"""

import brute_force
import numpy as np
import pytest
from small_level import make_level

from stylit_ref import passes
from stylit_ref.formulae.candidates import propagation_candidate, random_candidate
from stylit_ref.formulae.improve_assignment import phi
from stylit_ref.randomness.random_stream import RANDOM_SEARCH, random_stream, random_words

CASES = [
    {},
    {"uniformity": 0},
    {"uniformity": 100000, "seed": 1},
    {"smooth": True, "uniformity": 50},
    {"patch_width": 3, "guide_channels": (1,), "style_channels": 1},
    {"patch_width": 7, "guide_channels": (1, 4), "guide_weights": (2.0, 0.5), "style_channels": 4},
    {"patch_width": 13, "source_size": (14, 15), "target_size": (13, 9)},
    {"guide_channels": (3,) * 8, "source_size": (5, 5), "target_size": (6, 1)},
    {"masked": np.eye(14, 12, dtype=bool)},
    {"smooth": True, "crowded": True, "uniformity": 200},
    {"constant": True, "crowded": True},
    {"smooth": True, "uniformity": 200, "epsilon": 520},
    {"smooth": True, "epsilon": 1e12, "guide_channels": (1, 4), "guide_weights": (0.0, 3.5)},
    {"smooth": True, "epsilon": 700, "patch_width": 7, "uniformity": 20},
    {"epsilon": 1e9, "patch_width": 17, "source_size": (19, 20), "target_size": (9, 9)},
]
TIES = {"constant": True, "uniformity": 0}


STREAM = random_stream(7, RANDOM_SEARCH, 1, 2, 3)


def proposals(level):
    return level.nnf.copy(), level.delta.copy()


def metric(level):
    return level.textures, level.omega_sums, level.occurrence_weight, level.patch_width


def check(level, new_nnf, new_delta, candidates_of):
    """Every proposal is the oracle's, with its δ."""
    omega = brute_force.omega(level.nnf, level.omega.shape, level.patch_width)
    improved = 0
    for y in range(level.nnf.shape[0]):
        for x in range(level.nnf.shape[1]):
            if level.nnf[y, x, 0] < 0:
                assert (new_nnf[y, x] < 0).all()
                continue
            expected = brute_force.best_of(level, omega, y, x, candidates_of(y, x))
            assert tuple(new_nnf[y, x]) == expected
            assert new_delta[y, x] == brute_force.level_delta(level, y, x, *expected)
            improved += expected != tuple(level.nnf[y, x])
    return improved


def propagated(level, distance):
    """Candidates of a target pixel: the neighbours' assignments, shifted back."""

    def candidates_of(y, x):
        for dy, dx in ((0, distance), (distance, 0), (0, -distance), (-distance, 0)):
            near = y + dy, x + dx
            inside = 0 <= near[0] < level.nnf.shape[0] and 0 <= near[1] < level.nnf.shape[1]
            if inside and level.nnf[near][0] >= 0:
                yield propagation_candidate(
                    *level.nnf[near], dy, dx, level.patch_width // 2, *level.omega.shape
                )

    return candidates_of


def searched(level, stream):
    """Candidates of a target pixel: random, at radius 1, 2, 4, ..."""
    height, width = level.nnf.shape[:2]

    def candidates_of(y, x):
        search_radius, k = 1, 0
        while search_radius <= max(height, width) // 2:
            words = random_words(stream, y * width + x, k // 2)
            pair = words[2 * (k % 2) : 2 * (k % 2) + 2]
            yield random_candidate(
                *pair, *level.nnf[y, x], search_radius, level.patch_width // 2, *level.omega.shape
            )
            search_radius, k = 2 * search_radius, k + 1

    return candidates_of


@pytest.mark.parametrize("distance", [1, 4])
@pytest.mark.parametrize("case", CASES, ids=str)
def test_propagation(case, distance):
    level = make_level(**case)
    new_nnf, new_delta = proposals(level)
    passes.propagation(*metric(level), level.nnf, level.delta, new_nnf, new_delta, distance)
    improved = check(level, new_nnf, new_delta, propagated(level, distance))
    assert improved > 0 or level.omega.shape == (5, 5)


@pytest.mark.parametrize("case", CASES, ids=str)
def test_random_search(case):
    level = make_level(**case)
    new_nnf, new_delta = proposals(level)
    passes.random_search(*metric(level), level.nnf, level.delta, new_nnf, new_delta, STREAM)
    improved = check(level, new_nnf, new_delta, searched(level, STREAM))
    assert improved > 0 or level.omega.shape == (5, 5)


@pytest.mark.parametrize("apart", [0, 7])
def test_equal_candidates_do_not_move(apart):
    """Where φ is 0, which λρ alone decides, and where it is not."""
    level = make_level(**TIES)
    level.textures.target[level.textures.target > 0] += apart
    level.update_similarity()
    new_nnf, new_delta = proposals(level)
    passes.propagation(*metric(level), level.nnf, level.delta, new_nnf, new_delta, 1)
    np.testing.assert_array_equal(new_nnf, level.nnf)
    passes.random_search(*metric(level), level.nnf, level.delta, new_nnf, new_delta, STREAM)
    np.testing.assert_array_equal(new_nnf, level.nnf)


@pytest.mark.slow
@pytest.mark.parametrize("candidates", [propagated, searched])
def test_the_cases_exercise_every_saving(candidates):
    """How often each early exit would be taken, by the plain formula, over the cases."""
    exits = {"penalization": 0, "bound": 0, "evaluated": 0}
    for case in CASES:
        level = make_level(**case)
        candidates_of = candidates(level, 1 if candidates is propagated else STREAM)
        omega = brute_force.omega(level.nnf, level.omega.shape, level.patch_width)
        for y, x in np.argwhere(level.nnf[:, :, 0] >= 0):
            phi_current = brute_force.phi(level, omega, y, x, *level.nnf[y, x])
            for candidate in candidates_of(y, x):
                penalty = level.occurrence_weight * brute_force.omega_sum(
                    omega, level.patch_width, *candidate
                )
                bound = brute_force.delta_bound(level, y, x, *candidate)
                if penalty >= phi_current:
                    exits["penalization"] += 1
                elif penalty + bound >= phi_current:
                    exits["bound"] += 1
                else:
                    exits["evaluated"] += 1
    assert min(exits.values()) > 50, exits


def test_phi_is_the_definition():
    level = make_level()
    omega = brute_force.omega(level.nnf, level.omega.shape, level.patch_width)
    for y, x in ((0, 0), (5, 7), (13, 11)):
        place = y, x, *level.nnf[y, x]
        assert phi(
            level.textures.source, level.textures.target, level.textures.weights,
            level.omega, level.occurrence_weight, level.patch_width, *place,
        ) == brute_force.phi(level, omega, *place)  # fmt: skip
