"""Whole PatchMatch iterations: the order of the passes, a twin, and what must hold."""

import brute_force
import numpy as np
import pytest
from small_level import make_level

from stylit_ref import passes
from stylit_ref.formulae.candidates import propagation_candidate, random_candidate
from stylit_ref.machine.replaced import replaced
from stylit_ref.randomness.random_stream import (
    COMMIT_ORDER,
    RANDOM_SEARCH,
    random_stream,
    random_words,
)
from stylit_ref.stylization.schedules import propose_commit, scanline


def test_propose_commit_is_the_thesis_kernels_each_followed_by_a_commit():
    level = make_level()
    calls = []

    def spy(name):
        def call(*arguments):
            calls.append((name, arguments[-2 if name == "commit" else -1]))
            return getattr(passes, name)(*arguments)

        return call

    names = "propagation", "random_search", "commit"
    level.passes = replaced(passes, **{name: spy(name) for name in names})
    propose_commit(level, 9, 2, 3, 4)
    commit = ("commit", random_stream(9, COMMIT_ORDER, 2, 3, 4))
    assert calls == [
        ("propagation", 4), commit, ("propagation", 2), commit, ("propagation", 1), commit,
        ("random_search", random_stream(9, RANDOM_SEARCH, 2, 3, 4)), commit,
    ]  # fmt: skip


@pytest.mark.parametrize("uniformity", [0, 5000, 100000])
def test_after_propose_commit_w_and_delta_are_a_recount(uniformity):
    level = make_level(uniformity=uniformity, smooth=True, crowded=True)
    for iteration in (1, 2):
        propose_commit(level, 0, 1, 1, iteration)
    delta, omega_sums = level.delta.copy(), level.omega_sums.copy()
    level.update_similarity()
    level.init_occurrence_map()
    np.testing.assert_array_equal(delta, level.delta)
    if uniformity:
        np.testing.assert_array_equal(omega_sums, level.omega_sums)


def test_energy_never_rises_without_penalization():
    level = make_level(uniformity=0, target_size=(30, 28))
    energies = [level.energy()[0]]
    for iteration in range(1, 6):
        propose_commit(level, 0, 1, 1, iteration)
        energies.append(level.energy()[0])
    assert energies == sorted(energies, reverse=True)
    assert energies[-1] < energies[0]


@pytest.mark.parametrize("iteration", [1, 2])
@pytest.mark.parametrize(
    "case",
    [{}, {"uniformity": 100000}, {"smooth": True, "crowded": True, "uniformity": 300}],
    ids=str,
)
def test_scanline_is_section_2_4(case, iteration):
    """Against a loop in plain Python that recounts Ω for every decision."""
    level = make_level(source_size=(9, 10), target_size=(7, 8), **case)
    expected = level.nnf.copy()
    omega = brute_force.omega(expected, level.omega.shape, level.patch_width)
    rows, columns = range(7), range(8)
    back = -1 if iteration % 2 else 1
    if iteration % 2 == 0:
        rows, columns = rows[::-1], columns[::-1]
    stream = random_stream(0, RANDOM_SEARCH, 1, 1, iteration)

    def improve(y, x, candidate):
        nonlocal omega
        current = tuple(expected[y, x])
        phis = [brute_force.phi(level, omega, y, x, *centre) for centre in (candidate, current)]
        if phis[0] < phis[1]:
            expected[y, x] = candidate
            omega = brute_force.omega(expected, level.omega.shape, level.patch_width)

    for y in rows:
        for x in columns:
            for dy, dx in ((0, back), (back, 0)):
                near_y, near_x = y + dy, x + dx
                if 0 <= near_y < 7 and 0 <= near_x < 8:
                    neighbour = expected[near_y, near_x]
                    improve(y, x, propagation_candidate(*neighbour, dy, dx, 2, *omega.shape))
            centre = tuple(expected[y, x])
            for draw, search_radius in enumerate((8, 4, 2, 1)):
                words = random_words(stream, y * 8 + x, draw)[:2]
                improve(y, x, random_candidate(*words, *centre, search_radius, 2, *omega.shape))
    before = level.nnf.copy()
    scanline(level, 0, 1, 1, iteration)
    assert (expected != before).any()
    np.testing.assert_array_equal(level.nnf, expected)


@pytest.mark.parametrize("schedule", [propose_commit, scanline])
def test_equal_patches_do_not_move(schedule):
    level = make_level(constant=True, uniformity=0)
    before = level.nnf.copy()
    schedule(level, 0, 1, 1, 1)
    np.testing.assert_array_equal(level.nnf, before)
