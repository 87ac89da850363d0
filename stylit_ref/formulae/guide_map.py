r"""Guide maps: the guides of patches that hardly vary are compared by their means (thesis 5.2).

.. math:: \mathrm{mean}_i(P) = \frac{1}{w^2} \sum_{x,y} f_i^P(x, y) \qquad
          \mathrm{var}(P) = \sum_i \frac{1}{w^2} \sum_{x,y} (\mathrm{mean}_i(P) - f_i^P(x,y))^2

A target patch whose guides have var(P) < ε is white on the map G. For a white patch the guides'
part of δ is :math:`w^2 \sum_i \frac{\mu}{n_g} (\mathrm{mean}_i(P) - \mathrm{mean}_i(Q))^2`, from
two precomputed means; the style's part stays as it is. The code uses sums in place of means, so
that all numbers are exact:

.. math:: w^4 \mathrm{var}(P) = \sum_i \Bigl( w^2 \sum f^2 - \bigl(\sum f\bigr)^2 \Bigr) \qquad
          w^2 (\mathrm{mean}_P - \mathrm{mean}_Q)^2
          = \Bigl(\sum f^P - \sum f^Q\Bigr)^2 / w^2
"""

from fractions import Fraction
from math import ceil

import numpy as np
from numba import njit
from numpy.typing import NDArray

from stylit_ref.formulae.patch_similarity import squared_differences


@njit
def patch_sum(
    texture: NDArray[np.uint8], first_y: int, first_x: int, channel: int, patch_width: int
) -> int:
    """Sum of a channel over a patch, w² times its mean; the first pixel is given (Evaluate_Means).

    Parameters
    ----------
    texture : (H, W, C) uint8
    first_y, first_x, channel, patch_width : int

    Returns
    -------
    int64
    """
    total = np.int64(0)
    for dy in range(patch_width):
        for dx in range(patch_width):
            total += texture[first_y + dy, first_x + dx, channel]
    return total


@njit
def scaled_variance(
    texture: NDArray[np.uint8],
    sums: NDArray[np.uint16 | np.uint32],
    weights: NDArray[np.int64],
    first_y: int,
    first_x: int,
    patch_width: int,
) -> int:
    """w⁴ var of the patch whose first pixel is given (Evaluate_Map).

    A guide of weight 0 does not count, as in the metric.

    Parameters
    ----------
    texture : (H, W, C) uint8
    sums : (n,) uint16 or uint32
        :func:`patch_sum` of the patch's guide channels, the first n of a packed pixel.
    weights : (C,) int64
    first_y, first_x, patch_width : int

    Returns
    -------
    int64
    """
    total = np.int64(0)
    for c in range(sums.shape[0]):
        if weights[c]:
            squares = np.int64(0)
            for dy in range(patch_width):
                for dx in range(patch_width):
                    value = np.int64(texture[first_y + dy, first_x + dx, c])
                    squares += value * value
            total += patch_width * patch_width * squares - np.int64(sums[c]) * np.int64(sums[c])
    return total


def variance_limit(epsilon: float, patch_width: int) -> int:
    """The integer limit of w⁴ var: var < ε if and only if w⁴ var is below it."""
    return min(ceil(Fraction(float(epsilon)) * int(patch_width) ** 4), np.iinfo(np.int64).max)


def sums_dtype(patch_width: int) -> type[np.uint16 | np.uint32]:
    """The smallest type that holds the sum of a channel over a patch."""
    return np.uint16 if patch_width**2 * 255 < 1 << 16 else np.uint32


@njit
def guides_by_means(
    weights: NDArray[np.int64],
    target_sums: NDArray[np.uint16 | np.uint32],
    source_sums: NDArray[np.uint16 | np.uint32],
    channels: int,
    patch_width: int,
    y: int,
    x: int,
    source_y: int,
    source_x: int,
) -> int:
    """The guides' part of δ by their means (SSD, thesis 5.2.2).

    Parameters
    ----------
    weights : (C,) int64
    target_sums, source_sums : (H_B, W_B, n) and (H_A, W_A, n) uint16 or uint32
        :func:`patch_sum` of every patch.
    channels : int
        n, as a constant for the compiler.
    patch_width, y, x, source_y, source_x : int

    Returns
    -------
    int64
        In fixed point, rounded down.
    """
    total = np.int64(0)
    for c in range(channels):
        sum_p = np.int64(target_sums[y, x, c])
        difference = sum_p - np.int64(source_sums[source_y, source_x, c])
        # The second of two neighbours has the weight of the first or is padding, and a weight has
        # 32 bits. With this knowledge a GPU's compiler takes a quarter fewer registers.
        weight = np.int64(np.uint32(weights[c - c % 2]))
        total += weight * difference * difference
    return total // (patch_width * patch_width)


@njit
def delta_by_means(
    source: NDArray[np.uint8],
    target: NDArray[np.uint8],
    weights: NDArray[np.int64],
    target_sums: NDArray[np.uint16 | np.uint32],
    source_sums: NDArray[np.uint16 | np.uint32],
    patch_width: int,
    y: int,
    x: int,
    source_y: int,
    source_x: int,
) -> int:
    """δ of a patch that is white on the map, in its simplest form (SSD, thesis 5.2.2).

    Parameters
    ----------
    source, target, weights, patch_width, y, x, source_y, source_x
        As for :func:`stylit_ref.formulae.patch_similarity.delta`.
    target_sums, source_sums
        As for :func:`guides_by_means`.

    Returns
    -------
    int64
        In fixed point, the guides' part rounded down.
    """
    guides = target_sums.shape[2]
    return guides_by_means(
        weights, target_sums, source_sums, guides, patch_width, y, x, source_y, source_x
    ) + squared_differences(source, target, weights, patch_width, y, x, source_y, source_x, guides)
