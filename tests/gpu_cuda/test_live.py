"""The thesis' own kernels, Ω live by atomics: what must hold whichever thread comes first."""

import numpy as np
import pytest
from device_level import on_device, to_host
from small_level import make_level

from gpu_cuda.device import launch
from gpu_cuda.live import make_kernels
from stylit_ref.formulae.random_stream import RANDOM_SEARCH, random_stream

CASES = [{}, {"patch_width": 3, "uniformity": 100000}, {"crowded": True, "smooth": True}]


@pytest.mark.parametrize("with_sums", [False, True], ids=["Ω", "W"])
@pytest.mark.parametrize("case", CASES, ids=str)
def test_the_map_is_a_recount_and_phi_falls(case, with_sums):
    level = make_level(**case)
    device = on_device(level)
    occurrences = device.omega_sums if with_sums else device.omega
    propagation, random_search = make_kernels(level.patch_width, with_sums)
    metric = (
        device.textures.source, device.textures.target, device.textures.weights,
        occurrences, level.occurrence_weight,
    )  # fmt: skip
    size = level.nnf.shape[:2]
    before = level.energy()
    launch(propagation, size, *metric, device.nnf, device.proposed_nnf, 2)
    launch(random_search, size, *metric, device.proposed_nnf, random_stream(1, RANDOM_SEARCH, 1))

    moved = to_host(device.proposed_nnf)
    assert (moved != level.nnf).any()
    level.nnf[:] = moved
    level.update_similarity()
    level.init_occurrence_map()
    recount = level.omega_sums if with_sums else level.omega
    np.testing.assert_array_equal(to_host(occurrences), recount)
    assert level.omega.sum() == level.patch_width**2 * level.delta.size
    assert sum(level.energy()) < sum(before)
