"""What a pixel costs whose guide differs from the one it should have: an extension of the paper.

A guide gives a value to every pixel of the exemplar and of S. A pixel of S that shows the address a
costs ``weight |G_E[a] - G_S[t]|²``, in the units of seam costs. Patches that bring the right values
pay for their cuts with it.
"""

import numpy as np

from stylit_ref.machine.inlined import inlined
from stylit_ref.texture.formulae.seam_cost import ONE, squared_distance

WEIGHT_BITS = 16


def fixed_guide_weight(weight: float) -> int:
    """A weight for :func:`guide_cost`; at 1, a difference of 255 in one channel costs 1."""
    return int(np.floor(weight * ONE * (1 << WEIGHT_BITS) / 255**2 + 0.5))


@inlined
def guide_cost(shown: int, wanted: int, weight: int) -> int:
    """What a pixel with the guide ``shown`` costs where ``wanted`` is; packed colours."""
    return (np.int64(squared_distance(shown, wanted)) * weight) >> WEIGHT_BITS
