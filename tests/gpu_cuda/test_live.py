"""The thesis' own kernels, Ω live by atomics: invariants that hold in any order of threads."""

import numpy as np
import pytest
from device_level import FULL_SIZES, on_device, to_host
from small_level import make_level

from gpu_cuda.variants import live
from stylit_ref import passes
from stylit_ref.formulae.candidates import random_candidate
from stylit_ref.formulae.improve_assignment import improve_assignment
from stylit_ref.randomness.random_stream import RANDOM_SEARCH, random_stream, random_words

CASES = [
    {},
    {"patch_width": 3, "uniformity": 100000},
    {"crowded": True, "smooth": True},
    {"smooth": True, "epsilon": 520},
    *FULL_SIZES,
]

FORMS = {
    "Ω": lambda level: (live.omega_kernels, level.omega),
    "W": lambda level: (live.omega_sums_kernels, level.omega_sums),
}


@pytest.mark.parametrize("name", FORMS)
@pytest.mark.parametrize("case", CASES, ids=str)
def test_the_map_is_a_recount_and_phi_falls(case, name):
    level = make_level(**case)
    device = on_device(level)
    form = FORMS[name](device)
    before = level.energy()
    live.propagate(device, *form, 2)
    live.search_at_random(device, *form, random_stream(1, RANDOM_SEARCH, 1))

    moved = to_host(device.nnf)
    assert (moved != level.nnf).any()
    level.nnf[:] = moved
    level.update_similarity()
    level.init_occurrence_map()
    _, recount = FORMS[name](level)
    np.testing.assert_array_equal(to_host(form[1]), recount)
    if name == "Ω":
        assert recount.sum() == level.patch_width**2 * level.delta.size
    assert sum(level.energy()) < sum(before)


@pytest.mark.parametrize("name", FORMS)
@pytest.mark.parametrize("seed", range(4))
def test_a_thread_alone_does_what_the_formula_does(seed, name):
    """One patch that a mask leaves: ImproveAssignment of 3.2, candidate after candidate."""
    masked = np.ones((14, 12), bool)
    masked[6, 7] = False
    level = make_level(seed=seed, masked=masked, uniformity=20, smooth=True)
    rng = np.random.default_rng(seed)
    level.omega += rng.integers(0, 3, level.omega.shape, dtype=np.int32)
    level.omega_sums[:] = passes.box_sum(level.omega, level.patch_width)
    device = on_device(level)
    form, stream = FORMS[name](device), random_stream(seed, RANDOM_SEARCH, 1)
    live.search_at_random(device, *form, stream)

    centre = best = tuple(map(int, level.nnf[6, 7]))
    for k, search_radius in enumerate((1, 2, 4)):
        draw = random_words(stream, 6 * 12 + 7, k // 2)
        words = draw[:2] if k % 2 == 0 else draw[2:]
        candidate = random_candidate(*words, *centre, search_radius, 2, *level.omega.shape)
        best = improve_assignment(
            (level.textures.source, level.textures.target, level.textures.weights), level.omega,
            level.occurrence_weight, level.patch_width, 6, 7, *candidate, *best,
        )  # fmt: skip
    assert tuple(to_host(device.nnf)[6, 7]) == best
    level.omega_sums[:] = passes.box_sum(level.omega, level.patch_width)
    _, expected = FORMS[name](level)
    np.testing.assert_array_equal(to_host(form[1]), expected)
