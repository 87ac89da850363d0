"""A picture of what an iteration is about to do (Figure 1)."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.texture.formulae.seam_cost import ONE
from stylit_ref.texture.session import TextureSession

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 96, 255)

_FAINTEST = ONE // 16
"""Seams that cost less are not drawn."""


def overlay(session: TextureSession) -> NDArray[np.uint8]:
    """Draw over the texture the seams that it has, and the patches of the next iteration.

    Existing seams are red, borders of patches that the next :meth:`TextureSession.step` is going to
    accept are green, and of those that it is going to reject blue. The session stays as it is.

    Parameters
    ----------
    session : TextureSession

    Returns
    -------
    (H, W, 3) uint8
    """
    image = session.image
    picture = np.array(np.broadcast_to(image, (*image.shape[:2], 3)))
    picture[np.maximum(*session.seams) >= _FAINTEST] = RED
    judged = session.offer(_copy(session.texture), session.params.predicate)
    # Patches that are rejected early are never written down, unless none is rejected.
    offered = session.offer(_copy(session.texture), "none")
    side = offered.polar.half_width.size
    reach = np.arange(side) - side // 2
    height, width = session.size
    for cell, patch, accepted, is_written in zip(
        offered.cells, offered.patches, judged.accepted, offered.accepted, strict=True
    ):
        if not is_written:  # there is no patch, or all its cuts are blocked
            continue
        inside = np.zeros((side + 2, side + 2), np.bool_)
        inside[1:-1, 1:-1] = patch.reshape(side, side) >= 0
        middle = inside[1:-1, 1:-1]
        within = inside[:-2, 1:-1] & inside[2:, 1:-1] & inside[1:-1, :-2] & inside[1:-1, 2:]
        y, x = np.nonzero(middle & ~within)
        places = (cell[0] + reach[y]) % height, (cell[1] + reach[x]) % width
        picture[places] = GREEN if accepted else BLUE
    return picture


def _copy(texture):
    return texture._replace(
        addresses=texture.addresses.copy(),
        seams_x=texture.seams_x.copy(),
        seams_y=texture.seams_y.copy(),
    )
