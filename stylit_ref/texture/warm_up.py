"""Which kernels a texture needs."""

from dataclasses import replace

import numpy as np

from stylit_ref.machine.kernel import Specialization, rehearsal
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession


def kernels_of_texture(params: TextureParams) -> list[Specialization]:
    """The kernels that a synthesis calls, found out by a small one in which they do nothing.

    Large patches have tables of another type than small ones, so both ends of R are tried.

    Parameters
    ----------
    params : TextureParams

    Returns
    -------
    list of Specialization
        In the order of their first calls.
    """
    with rehearsal() as rehearsed:
        for radius in {params.radius, params.radius_at(params.iterations)}:
            side = 2 * radius + 2
            black = np.zeros((side, side), np.uint8)
            TextureSession([black], (side, side), replace(params, radius=radius)).step()
    return list(rehearsed)
