"""Which kernels a frame needs, found out without compiling any."""

import numpy as np

from stylit_ref.realtime.packing import PrincipalPacking, StagePacking
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.warm_up import kernels_of_frame


def names(kernels):
    return [kernel.dispatcher.py_func.__name__ for kernel in kernels]


def test_buffers_of_one_channel_are_rehearsed_as_such():
    grey = np.random.default_rng(0).integers(0, 256, (9, 8, 1), np.uint8)
    packing = PrincipalPacking.of_source({"DEPTH": grey, "IDMASK": grey.repeat(3, axis=2)})
    assert "search" in names(kernels_of_frame(RealtimeParams(), packing))


def test_a_warm_frame_renews_matches():
    params = RealtimeParams(warm_iterations=3)
    cold, warm = (kernels_of_frame(params, StagePacking(), warm=is_warm)
                  for is_warm in (False, True))  # fmt: skip
    assert names(warm) == [*names(cold), "renew", "mark_moving"]


def test_a_warm_frame_of_one_iteration_marks_nothing():
    kernels = kernels_of_frame(RealtimeParams.preset("quick"), StagePacking(), warm=True)
    assert names(kernels)[-1] == "renew"
