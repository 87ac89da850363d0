"""How far a pixel's scales reach (4.2.3): the thesis says 27 x 27 pixels for D = 3."""

import numpy as np

from stylit_ref.realtime import passes
from stylit_ref.realtime.exemplar import Exemplar
from stylit_ref.realtime.layout import Layout
from stylit_ref.realtime.params import RealtimeParams

_SIDE = 64

READINGS = {"means of boxes around the pixel": "box", "texels of coarser levels": "mip"}
"""What a scale can be: as 4.2.3 argues, and as 5.2.2 makes it."""


def reach(means, depth):
    """Width of the window that the scales of a pixel are means of.

    A column of the picture turns from black to white: does the record of a pixel in the middle
    change?

    Parameters
    ----------
    means : {"mip", "box"}
    depth : int
        D.

    Returns
    -------
    int
        Pixels.
    """
    params = RealtimeParams.preset(
        "optimized", means=means, depth=depth, levels=1, mu=(0,), iterations=(1,), radii=(1,)
    )
    layout = Layout(params, 1, passes)
    middle = (_SIDE // 2) * (_SIDE + 1)
    reached = 0
    for column in range(_SIDE):
        guides = np.zeros((_SIDE, _SIDE, 1), np.uint8)
        guides[:, column] = 255
        exemplar = Exemplar(_SIDE, _SIDE, layout)
        exemplar.set_guides(guides)
        exemplar.set_style(np.zeros((_SIDE, _SIDE, 3), np.uint8))
        exemplar.join()
        unit = layout.unit(0)
        reached += exemplar.records[0].values[middle * unit : (middle + 1) * unit].any()
    return int(reached)
