"""The thesis' own kernels, Ω live by atomics: what must hold whichever thread comes first."""

import numpy as np
import pytest
from device_level import on_device, to_host
from small_level import make_level

import gpu_cuda
from stylit_ref.formulae.random_stream import RANDOM_SEARCH, random_stream

CASES = [{}, {"patch_width": 3, "uniformity": 100000}, {"crowded": True, "smooth": True}]


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
    assert level.omega.sum() == level.patch_width**2 * level.delta.size
    assert sum(level.energy()) < sum(before)
