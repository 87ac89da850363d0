"""What a seam costs (section 4, "Seams cost"), in integers.

The paper's M compares two pixels that meet at a seam with the pixels that follow them in the
exemplar::

    M = ((|E[a] - E[b - δ]|² + |E[b] - E[a + δ]|²) /
         (η + |E[a] - E[a + δ]|² + |E[b] - E[b - δ]|²)) ** d

where the pixel at t shows E[a] and the one at t + δ shows E[b]. With a = o_e + p and b = S[t + δ]
it is the cost of a new seam; with a = S[t] it is that of a seam that S has. (Read literally, the
paper's M^S passes S[t_e] for both; its first term is then zero and the cost of a seam depends on
the side from which one looks. The symmetric form depends on S alone, and a seam costs the same as a
new one and as an old one.) The cost is 0 where b = a + δ, so where S continues a piece of the
exemplar.

A cost of 1 is :data:`ONE`. Both sums are integers below 2**24, which float32 holds exactly; the
only roundings are those of one division and of the products of the power, which IEEE 754
prescribes. So every machine computes the same integer.
"""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined

ONE = 256
"""The integer that stands for a cost of 1."""

LARGEST_COST = 1 << 24
"""Costs above are cut off here."""

_ONE = np.float32(ONE)
_LARGEST = np.float32(LARGEST_COST)


@inlined
def squared_distance(colour: int, other: int) -> int:
    """|p - q|² of two packed colours, 8 bits a channel in the three low bytes."""
    red = np.int32((colour & 255) - (other & 255))
    green = np.int32(((colour >> 8) & 255) - ((other >> 8) & 255))
    blue = np.int32(((colour >> 16) & 255) - ((other >> 16) & 255))
    return np.int32(np.int32(red * red) + np.int32(green * green) + np.int32(blue * blue))


@inlined
def seam_cost(
    here: int, after_here: int, there: int, before_there: int, eta: int, exponent: int
) -> int:
    """M between the pixels ``here`` = E[a] and ``there`` = E[b], given E[a + δ] and E[b - δ]."""
    contrast = np.int32(squared_distance(here, after_here) + squared_distance(there, before_there))
    return cost_beside(here, after_here, there, before_there, contrast, eta, exponent)


@inlined
def cost_beside(
    here: int,
    after_here: int,
    there: int,
    before_there: int,
    contrast: int,
    eta: int,
    exponent: int,
) -> int:
    """M, where ``contrast`` = |E[a] - E[a + δ]|² + |E[b] - E[b - δ]|² is known."""
    differences = np.int32(
        squared_distance(here, before_there) + squared_distance(there, after_here)
    )
    quotient = np.float32(differences) / np.float32(np.int32(eta + contrast))
    square = np.float32(quotient * quotient)
    power = (
        square if exponent == 2 else quotient if exponent == 1 else np.float32(square * quotient)
    )
    cost = np.float32(power * _ONE)
    return np.int32(cost if cost < _LARGEST else _LARGEST)


@inlined
def edge_cost(
    colours: NDArray[np.int32], here: int, there: int, step: int, eta: int, exponent: int
) -> int:
    """The cost of the seam between two neighbours in S, which hold the addresses a and b.

    ``step`` is δ as a difference of addresses.
    """
    if there == here + step:
        return np.int32(0)
    return seam_cost(
        colours[here], colours[here + step], colours[there], colours[there - step], eta, exponent
    )
