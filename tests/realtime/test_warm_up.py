"""Which kernels a frame needs."""

import numpy as np

from stylit_ref.realtime.packing import PrincipalPacking
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.warm_up import kernels_of_frame


def test_kernels_are_found_whatever_channels_a_buffer_has():
    rng = np.random.default_rng(0)
    sizes = {"IDMASK": 3, "DEPTH": 1, "FULL": 3}
    buffers = {name: rng.integers(0, 9, (8, 9, n), np.uint8) for name, n in sizes.items()}
    assert kernels_of_frame(RealtimeParams(), PrincipalPacking.of_source(buffers))
