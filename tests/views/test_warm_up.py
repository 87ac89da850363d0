"""Kernels that coherent frames call are known before they run."""

import numpy as np
import pytest
from compiled import Compiled
from numba.core import event
from small_scene import small_scene

from stylit_ref import ArrayShot, Coherence, Motion, Params, stylize_views
from stylit_ref.machine.compilation import compile_missing
from stylit_ref.views.frames import sequence_pairs
from stylit_ref.views.warm_up import kernels_of_frames


@pytest.mark.parametrize("order", ["parallel", "sequential"])
@pytest.mark.parametrize("method", ["ref", "stylit"])
def test_frames_compile_nothing_that_was_not_warmed_up(method, order):
    params = Params(method=method, levels=3, votes=2, patchmatch_iterations=1)
    coherence = Coherence(order=order)
    compile_missing(kernels_of_frames(params, coherence, 3, (3, 1)))
    style, sources, targets = small_scene()
    size = targets[0].shape[:2]
    still = Motion(np.zeros((*size, 2), np.float32), np.ones(size, bool))
    shot = ArrayShot([targets, targets], dict.fromkeys(sequence_pairs(2), still))
    with event.install_listener("numba:compile", Compiled()) as compiled:
        list(stylize_views(style, sources, shot, params, coherence))
    assert compiled.names == []
