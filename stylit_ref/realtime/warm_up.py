"""Which kernels a frame needs."""

from dataclasses import replace

import numpy as np

from stylit_ref.machine.compilation import Specialization
from stylit_ref.machine.kernel import rehearsal
from stylit_ref.realtime.packing import Packing, PrincipalPacking, pack
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.session import Session


def kernels_of_frame(
    params: RealtimeParams, packing: Packing, *, warm: bool = False
) -> list[Specialization]:
    """The kernels that a cold frame calls, packing included.

    They are found out by a small frame in which they do nothing.

    Parameters
    ----------
    params : RealtimeParams
    packing : Packing
    warm : bool
        Whether those of a warm frame are wanted too.

    Returns
    -------
    list of Specialization
        In the order of their first calls.
    """
    side = 4 * params.patch_width
    channels = dict(packing.buffers) if isinstance(packing, PrincipalPacking) else {}
    buffers = {
        name: np.zeros((side, side, channels.get(name, 3)), np.uint8) for name in packing.names
    }
    # A second iteration calls what the first one does, and in a warm frame the third the second.
    short = replace(
        params,
        iterations=tuple(min(count, 1) for count in params.iterations),
        warm_iterations=min(params.warm_iterations, 2),
    )
    with rehearsal() as rehearsed:
        guides, labels = pack(packing, buffers)
        session = Session(short, threads=1)
        session.set_exemplar(guides, np.zeros((side, side, 3), np.uint8), labels)
        session.set_target(guides, labels)
        session.frame()
        if warm:
            session.frame(warm=True)
    return list(rehearsed)
