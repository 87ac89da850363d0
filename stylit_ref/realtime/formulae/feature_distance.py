"""The energy of a match (equations 15 and 22), as weights of the bytes of a pixel.

E = (1 - μ) Σ w_c (guides)² + μ Σ (style)², with μ = n / 16. It is only compared, so it is held as
an integer: every weight is multiplied by the same number, and divided by what they have in common.
Two forms: ``sums`` as printed, where a term counts by its number of channels, and ``means``, where
each term is divided by the weight of its channels.
"""

from collections.abc import Sequence
from math import gcd

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.machine.vector_patch import STYLE_LANES

MU_ONE = 16
"""μ = 1."""

TERMS = "sums", "means"

LARGEST_WEIGHT = 128  # a difference times it fits int16
_LARGEST_SUM = 2**31 - 1


def term_weights(mu: int, guide_weights: Sequence[int], terms: str) -> tuple[list[int], int]:
    """The integer weight of every channel of the guides, and that of each colour of the style.

    Parameters
    ----------
    mu : int
        μ in sixteenths.
    guide_weights : sequence of int
    terms : {"sums", "means"}
    """
    guides = [(MU_ONE - mu) * weight for weight in guide_weights]
    style = mu
    if terms == "means":
        guides = [3 * weight for weight in guides]
        style *= max(sum(guide_weights), 1)
    shared = gcd(*guides, style) or 1
    return [weight // shared for weight in guides], style // shared


def lane_weights(
    mu: int, guide_weights: Sequence[int], terms: str, lanes: int
) -> NDArray[np.int16]:
    """The weight of each byte of a pixel: guides, zeros, the style's three colours, zero.

    Parameters
    ----------
    mu, guide_weights, terms
        As above.
    lanes : int
        Bytes of a pixel; 4 for one of the style alone.

    Returns
    -------
    (lanes,) int16

    Raises
    ------
    InputError
        If a weight is too large for the arithmetic.
    """
    guides, style = term_weights(mu, guide_weights, terms)
    if max(*guides, style) > LARGEST_WEIGHT:
        raise InputError(
            f"give a weight of {max(*guides, style)} where mu is {mu} / {MU_ONE}; it must be at "
            f"most {LARGEST_WEIGHT}; use smaller ones, ones with a common divisor, or another mu",
            parameter="weights",
        )
    weights = np.zeros(lanes, np.int16)
    if lanes > STYLE_LANES:
        weights[: len(guides)] = guides
        weights[-STYLE_LANES:-1] = style
    else:
        weights[:3] = 1
    return weights


def alike_where_free(weights: NDArray[np.int16], channels: int) -> NDArray[np.int16]:
    """The same energy, with neighbouring weights made alike where a byte is always 0.

    Such a byte is behind an odd number of channels, and behind the style's three colours. A search
    is faster if the weights of bytes are alike in pairs.

    Parameters
    ----------
    weights : (lanes,) int16
        From :func:`lane_weights`.
    channels : int
        Of the guides.
    """
    weights = weights.copy()
    weights[-1] = weights[-2]
    if len(weights) > STYLE_LANES and channels % 2:
        weights[channels] = weights[channels - 1]
    return weights


def check_sum(weights: NDArray[np.int16], pixels: int) -> None:
    """Refuse weights whose largest energy does not fit 32 bits.

    Raises
    ------
    InputError
    """
    if int(weights.sum()) * pixels * 255**2 > _LARGEST_SUM:
        raise InputError(
            "are too large for patches of this width; use smaller weights, another mu, or a "
            "smaller patch_width",
            parameter="weights",
        )
