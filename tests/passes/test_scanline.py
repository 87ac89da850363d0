from itertools import pairwise

import brute_force
import numpy as np
import pytest
from small_level import make_level

from stylit_ref import passes
from stylit_ref.randomness.random_stream import RANDOM_SEARCH, random_stream


def total_phi(level):
    level.update_similarity()
    level.init_occurrence_map()
    return sum(level.energy())


def iterate(level, iteration):
    passes.scanline(
        level.textures.source, level.textures.target, level.textures.weights, level.omega,
        level.occurrence_weight, level.patch_width, level.nnf,
        random_stream(0, RANDOM_SEARCH, 1, 1, iteration), iteration % 2 == 0,
    )  # fmt: skip


@pytest.mark.parametrize("masked", [None, np.eye(14, 12, dtype=bool)], ids=["whole", "masked"])
def test_live_omega_is_always_the_count(masked):
    level = make_level(masked=masked)
    for iteration in (1, 2):
        iterate(level, iteration)
        omega = brute_force.omega(level.nnf, level.omega.shape, level.patch_width)
        np.testing.assert_array_equal(level.omega, omega)


def test_energy_falls_without_penalization():
    level = make_level(uniformity=0)
    energies = [total_phi(level)]
    for iteration in range(1, 5):
        iterate(level, iteration)
        energies.append(total_phi(level))
    assert all(later <= earlier for earlier, later in pairwise(energies))
    assert energies[-1] < energies[0]


def test_it_finds_exact_patches():
    """A target cut out of the source is found again almost everywhere."""
    level = make_level(seed=5, source_size=(24, 24), target_size=(20, 20), uniformity=0)
    level.textures.target[:] = level.textures.source
    level.update_similarity()
    for iteration in range(1, 9):
        iterate(level, iteration)
    expected = np.stack(np.mgrid[2:22, 2:22], axis=-1)
    assert (level.nnf == expected).all(axis=2).mean() > 0.95
