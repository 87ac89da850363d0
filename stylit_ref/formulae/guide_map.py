r"""Guide maps: means in place of a patch's guides where these hardly vary (thesis 5.2).

.. math:: \mathrm{mean}_i(P) = \frac{1}{w^2} \sum_{x,y} f_i^P(x, y) \qquad
          \mathrm{var}(P) = \sum_i \frac{1}{w^2} \sum_{x,y} (\mathrm{mean}_i(P) - f_i^P(x,y))^2

A target patch whose guides have var(P) < ε is white on the map G. There the guides' part
of δ is :math:`w^2 \sum_i \frac{\mu}{n_g} (\mathrm{mean}_i(P) - \mathrm{mean}_i(Q))^2`, read
from two precomputed means; the style's part stays. Sums take the place of means, so that all of
it is exact:

.. math:: w^4 \mathrm{var}(P) = \sum_i \Bigl( w^2 \sum f^2 - \bigl(\sum f\bigr)^2 \Bigr) \qquad
          w^2 (\mathrm{mean}_P - \mathrm{mean}_Q)^2
          = \Bigl(\sum f^P - \sum f^Q\Bigr)^2 / w^2
"""

from fractions import Fraction
from math import ceil

import numpy as np
from numba import njit

from stylit_ref.machine.vector_ssd import make_weighted_ssd


@njit
def patch_sum(texture, first_y, first_x, channel, patch_width):
    """w² times the mean of a channel over the patch whose first pixel is given (Evaluate_Means).

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
def scaled_variance(texture, sums, weights, first_y, first_x, patch_width):
    """w⁴ var of the patch whose first pixel is given (Evaluate_Map).

    A guide of weight 0, which the metric ignores, does not count here either.

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


def variance_limit(epsilon, patch_width):
    """The least w⁴ var that is black: var < ε exactly where w⁴ var is below this integer."""
    return min(ceil(Fraction(float(epsilon)) * int(patch_width) ** 4), np.iinfo(np.int64).max)


def sums_dtype(patch_width):
    """The smallest type that holds the sum of a channel over a patch."""
    return np.uint16 if patch_width**2 * 255 < 1 << 16 else np.uint32


@njit
def delta_by_means(
    source, target, weights, target_sums, source_sums, patch_width, y, x, source_y, source_x
):  # fmt: skip
    """δ of a patch that is white on the map, in its plainest form (SSD, thesis 5.2.2).

    Parameters
    ----------
    source, target, weights, patch_width, y, x, source_y, source_x
        As for :func:`stylit_ref.formulae.patch_similarity.delta`.
    target_sums, source_sums : (n,) uint16 or uint32
        :func:`patch_sum` of both patches' guide channels.

    Returns
    -------
    int64
        In fixed point, the guides' part rounded down.
    """
    guides = np.int64(0)
    for c in range(target_sums.shape[0]):
        difference = np.int64(target_sums[c]) - np.int64(source_sums[c])
        guides += weights[c] * difference * difference
    total = guides // (patch_width * patch_width)
    radius = patch_width // 2
    for dy in range(patch_width):
        for dx in range(patch_width):
            for c in range(target_sums.shape[0], source.shape[2]):
                f_p = np.int64(target[y + dy, x + dx, c])
                f_q = np.int64(source[source_y - radius + dy, source_x - radius + dx, c])
                total += weights[c] * (f_p - f_q) * (f_p - f_q)
    return total


def make_guide_map_delta(patch_width, channels, mean_channels, patch_delta):
    """Compile the SSD of thesis 5.2.2 for the CPU's vectors; equals :func:`delta_by_means`.

    Parameters
    ----------
    patch_width, channels, mean_channels : int
        See :func:`stylit_ref.metric.textures.metric_constants`.
    patch_delta : callable
        δ for patches that are black on the map.

    Returns
    -------
    callable
        ``(textures, y, x, source_y, source_x) -> int64``: δ in fixed point. Where the patch
        is white the guides' part is rounded down.
    """
    radius = patch_width // 2
    style_ssd = make_weighted_ssd(
        patch_width, patch_width, channels, element_bits=8, first_channel=mean_channels
    )

    @njit(forceinline=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)
    def guide_map_delta(textures, y, x, source_y, source_x):
        if not textures.guide_map[y, x]:
            return patch_delta(textures, y, x, source_y, source_x)
        sums_p = textures.target_sums[np.uint64(y), np.uint64(x)]
        sums_q = textures.source_sums[np.uint64(source_y), np.uint64(source_x)]
        guides = np.int64(0)
        for c in range(mean_channels):
            difference = np.int64(sums_p[c]) - np.int64(sums_q[c])
            guides += textures.weights[c] * difference * difference
        source_stride = np.int64(textures.source.shape[1]) * channels
        target_stride = np.int64(textures.target.shape[1]) * channels
        return guides // (patch_width * patch_width) + style_ssd(
            textures.target,
            y * target_stride + x * channels,
            target_stride,
            textures.source,
            (source_y - radius) * source_stride + (source_x - radius) * channels,
            source_stride,
            textures.style_pair_weights,
        )

    return guide_map_delta
