"""Which kernels a texture needs."""

from dataclasses import replace

import numpy as np

from stylit_ref.machine.compilation import Specialization
from stylit_ref.machine.kernel import rehearsal
from stylit_ref.texture.dragging import drag, drop
from stylit_ref.texture.painting import paint
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession

_LARGE = 128
"""A radius whose tables are of another type than those of the default radius."""


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
            _session(params, radius).step()
    return list(rehearsed)


def kernels_of_editing(params: TextureParams) -> list[Specialization]:
    """The kernels that painting and dragging call, as :func:`kernels_of_texture`."""
    with rehearsal() as rehearsed:
        session = _session(params, params.radius)
        paint(session, np.ones(session.size, np.bool_), 1, iterations=1)
        middle = session.size[0] // 2, session.size[1] // 2
        drop(session, drag(session, (1, *middle), middle))
    return list(rehearsed)


def kernels_of_all_textures() -> list[Specialization]:
    """The kernels that textures call of any radius, with a guide and without, and their editing."""
    with rehearsal() as rehearsed:
        _session(TextureParams(), TextureParams().radius, has_guide=True)
    kernels = dict.fromkeys(rehearsed)
    for radius in (TextureParams().radius, _LARGE):
        params = TextureParams(radius=radius)
        kernels |= dict.fromkeys([*kernels_of_texture(params), *kernels_of_editing(params)])
    return list(kernels)


def _session(params, radius, has_guide=False):
    side = 2 * radius + 2
    black = np.zeros((side, side), np.uint8)
    guides = {"source_guides": [black], "target_guide": black} if has_guide else {}
    return TextureSession([black], (side, side), replace(params, radius=radius), **guides)
