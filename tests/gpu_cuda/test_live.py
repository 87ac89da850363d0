"""The thesis' own kernels, Ω live by atomics: what must hold whichever thread comes first."""

import numpy as np
import pytest
from device_level import FULL_SIZES, on_device, to_host
from small_level import make_level

import gpu_cuda
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


@pytest.mark.parametrize("with_sums", [False, True], ids=["Ω", "W"])
@pytest.mark.parametrize("case", CASES, ids=str)
def test_the_map_is_a_recount_and_phi_falls(case, with_sums):
    level = make_level(**case)
    device = on_device(level)
    occurrences = device.omega_sums if with_sums else device.omega
    metric = (
        device.textures, occurrences, with_sums, level.occurrence_weight, level.patch_width
    )  # fmt: skip
    before = level.energy()
    gpu_cuda.live_propagation(*metric, device.nnf, device.proposed_nnf, 2)
    stream = random_stream(1, RANDOM_SEARCH, 1)
    gpu_cuda.live_random_search(*metric, device.proposed_nnf, stream)

    moved = to_host(device.proposed_nnf)
    assert (moved != level.nnf).any()
    level.nnf[:] = moved
    level.update_similarity()
    level.init_occurrence_map()
    recount = level.omega_sums if with_sums else level.omega
    np.testing.assert_array_equal(to_host(occurrences), recount)
    if not with_sums:
        assert to_host(occurrences).sum() == level.patch_width**2 * level.delta.size
    assert sum(level.energy()) < sum(before)


@pytest.mark.parametrize("with_sums", [False, True], ids=["Ω", "W"])
@pytest.mark.parametrize("seed", range(4))
def test_a_thread_alone_does_what_the_formula_does(seed, with_sums):
    """One patch that a mask leaves: ImproveAssignment of 3.2, candidate after candidate."""
    masked = np.ones((14, 12), bool)
    masked[6, 7] = False
    level = make_level(seed=seed, masked=masked, uniformity=20, smooth=True)
    rng = np.random.default_rng(seed)
    level.omega += rng.integers(0, 3, level.omega.shape, dtype=np.int32)
    level.omega_sums[:] = passes.box_sum(level.omega, level.patch_width)
    device = on_device(level)
    occurrences = device.omega_sums if with_sums else device.omega
    stream = random_stream(seed, RANDOM_SEARCH, 1)
    gpu_cuda.live_random_search(
        device.textures, occurrences, with_sums, level.occurrence_weight, level.patch_width,
        device.nnf, stream,
    )  # fmt: skip

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
    expected = passes.box_sum(level.omega, level.patch_width) if with_sums else level.omega
    np.testing.assert_array_equal(to_host(occurrences), expected)
