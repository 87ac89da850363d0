"""Coherence with neighbouring frames, folded into the style term (equation 3.1).

To the patch error, equation 3.1 adds Σ λ_c |A'(p) - G_c(q)|², with G_c the picture of a neighbour,
shifted to this frame. Together with the style term that is, for every colour value,

    |A' - B'|² + Σ λ_c |A' - G_c|²  =  (1 + Σ λ_c) (|A' - M|² + S)

    M  =  (B' + Σ λ_c G_c) / (1 + Σ λ_c)
    S  =  (B'² + Σ λ_c G_c²) / (1 + Σ λ_c) - M²

So the search needs no new channels: it sees M in the place of B'. S does not depend on p: it is the
spread of B' and the G_c around their mean. It matters only where target patches are chosen, as
StyLit's retrieval does; there a pixel has that of all its channels together.

λ_c are multiples of 1/256 and sums are integers, so that M is exact but for its rounding to 8 bits.
"""

import math

from numba import njit

ONE = 256
"""The weight of B' itself: λ_c are held in units of 1/256."""


def fixed_weight(weight: float) -> int:
    """λ_c in units of 1/256, rounded half up."""
    return math.floor(weight * ONE + 0.5)


@njit
def folded(total: int, weights: int) -> int:
    """M, rounded half up: ``total`` is ONE B' + Σ λ_c G_c and ``weights`` ONE + Σ λ_c."""
    return (2 * total + weights) // (2 * weights)


@njit
def spread(deviation: int, weights: int) -> int:
    """√S, with S summed over the channels of a pixel, rounded half up.

    Parameters
    ----------
    deviation : int
        Σ over the channels of ``weights (ONE B'² + Σ λ_c G_c²) - total²``.
    weights : int
        ONE + Σ λ_c.

    Returns
    -------
    int
        At most 255 with up to four channels, since values between 0 and 255 deviate from their mean
        by 127.5 or less. One division and one square root in IEEE arithmetic, which all processors
        round alike.
    """
    return int(math.sqrt(deviation / (weights * weights)) + 0.5)
