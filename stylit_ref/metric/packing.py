"""Guides and style in one texture, and the weights of the metric (thesis 2.1, 3.2).

The thesis keeps guidance and style channels together in textures Ā and B̄. So does this module, in
a layout for vector instructions: guides first, then the style, each pixel padded to a multiple of
16 bytes. Neighbouring channels ``2k`` and ``2k + 1`` always have equal weights; where needed the
second is a padding channel, zero on both sides and of weight 0.

Weights are fixed-point integers, so that φ is an exact integer in any order of evaluation, on
every processor and with any number of threads.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.formulae.patch_penalization import omega_best
from stylit_ref.machine.vector_ssd import LANES
from stylit_ref.metric.lower_bound import (
    BOUND_SCALE,
    CONSTANT,
    LINE_MOMENTS,
    STYLE_DEGREES,
    moment_width,
    squared_norm,
)

ONE = 1 << 16
"""Fixed-point one: φ, λρ and δ are held in units of 1/65536."""


@dataclass(frozen=True)
class Packing:
    """Where each channel lies in a packed pixel, and its weight.

    Attributes
    ----------
    guide_channels, guide_sizes : tuple of int
        First packed channel of each guide, and the number of its channels.
    style_channel, style_channels : int
        First packed channel of the style and the number of its channels.
    channels : int
        Packed channels a pixel, a multiple of 16.
    weights : (channels,) int64
        Fixed-point factor of each channel's squared differences.
    """

    guide_channels: tuple[int, ...]
    guide_sizes: tuple[int, ...]
    style_channel: int
    style_channels: int
    channels: int
    weights: NDArray[np.int64]

    @property
    def pair_weights(self) -> NDArray[np.uint32]:
        """Weights of neighbouring channels, (channels / 2,) uint32."""
        return self.weights.reshape(-1, 2).max(axis=1).astype(np.uint32)

    @property
    def style_pair_weights(self) -> NDArray[np.uint32]:
        """The same, with weights of 0 for the guides, (channels / 2,) uint32."""
        weights = self.pair_weights
        weights[: self.style_channel // 2] = 0
        return weights

    @property
    def moments(self) -> tuple[tuple[int, tuple[int, int]] | None, ...]:
        """Channel and degrees of each moment of a patch, or None for padding.

        A tuple of ``(channel, (vertical, horizontal))`` that fills whole cache lines: the sums of
        all channels, then the higher moments of the style channels.
        """
        moments = [(channel, CONSTANT) for channel in range(self.channels)]
        style = range(self.style_channel, self.style_channel + self.style_channels)
        for degrees in STYLE_DEGREES:
            moments += [(channel, degree) for channel in style for degree in degrees]
        return (*moments, *[None] * (-len(moments) % LINE_MOMENTS))

    def moment_weights(self, patch_width: int, guide_map: bool = False) -> NDArray[np.uint32]:
        """Weights of neighbouring moments in the bound of δ, (moments / 2,) uint32.

        They are rounded down, so that the bound remains a lower bound. With a guide map the guides
        weigh 0 if moments cover a part of the patch only: δ then compares the means of whole
        patches, and the means of a part are no bound of it.
        """
        width = moment_width(patch_width)
        guides_bound = width == patch_width or not guide_map
        weights = [
            BOUND_SCALE * int(self.weights[moment[0]]) // squared_norm(width, moment[1])
            if moment and (guides_bound or moment[0] >= self.style_channel)
            else 0
            for moment in self.moments
        ]
        return np.array(weights).reshape(-1, 2).max(axis=1).astype(np.uint32)

    def largest_delta(self, patch_width: int) -> int:
        """An upper bound of δ, fixed point."""
        return patch_width**2 * 255**2 * int(self.weights.sum())

    def pack(
        self, guides: Sequence[NDArray[np.uint8]], style: NDArray[np.uint8] | None = None
    ) -> NDArray[np.uint8]:
        """Lay guides and style side by side.

        Parameters
        ----------
        guides : sequence of (H, W, n) uint8
        style : (H, W, style_channels) uint8, optional
            Zeros by default.

        Returns
        -------
        (H, W, channels) uint8
        """
        texture = np.zeros((*guides[0].shape[:2], self.channels), np.uint8)
        for first, guide in zip(self.guide_channels, guides, strict=True):
            texture[:, :, first : first + guide.shape[2]] = guide
        if style is not None:
            self.set_style(texture, style)
        return texture

    def agrees_with(self, other: "Packing") -> bool:
        """Whether textures of both packings can be compared."""
        return self.guide_sizes == other.guide_sizes and np.array_equal(self.weights, other.weights)

    def set_style(self, texture: NDArray[np.uint8], style: NDArray[np.uint8]) -> None:
        """Write an image into a packed texture's style channels.

        Raises
        ------
        InputError
            If it has another size, type or number of channels.
        """
        place = self.style(texture)
        if style.shape != place.shape or style.dtype != np.uint8:
            raise InputError(
                f"the style is {style.dtype} of shape {style.shape}; it must be uint8 of shape "
                f"{place.shape}"
            )
        place[:] = style

    def guide(self, texture: NDArray[np.uint8], number: int) -> NDArray[np.uint8]:
        """View of a guide in a packed texture; -1 is the last."""
        first = self.guide_channels[number]
        return texture[:, :, first : first + self.guide_sizes[number]]

    def style(self, texture: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """View of a packed texture's style channels."""
        return texture[:, :, self.style_channel : self.style_channel + self.style_channels]


def make_packing(
    guide_sizes: Sequence[int],
    style_channels: int,
    guide_influence: float,
    guide_weights: Sequence[float],
) -> Packing:
    """Lay out channels and weights.

    Each guide channel weighs μ/n_g times its guide's weight and each style channel
    1/n_s (SSD, thesis 3.2), n_g and n_s being the numbers of channels.

    Parameters
    ----------
    guide_sizes : sequence of int
        Channels of each guide.
    style_channels : int
    guide_influence : float
        μ.
    guide_weights : sequence of float

    Returns
    -------
    Packing

    Raises
    ------
    InputError
        If a weight rounds to 0 or does not fit 32 bits in fixed point.
    """
    weights, guide_channels = [], []
    per_channel = guide_influence / sum(guide_sizes)
    for size, guide_weight in zip(guide_sizes, guide_weights, strict=True):
        fixed = round(ONE * per_channel * guide_weight)
        if guide_weight and guide_influence and not fixed:
            raise InputError(
                f"guide weight {guide_weight:g} with guide influence {guide_influence:g} is too "
                "small to count; raise it, or ignore the guide with a weight of 0"
            )
        if fixed >= 1 << 32:
            raise InputError(
                f"guide weight {guide_weight:g} times guide influence {guide_influence:g} "
                f"is too large; divided by {sum(guide_sizes)} guide channels it must be below 65536"
            )
        if len(weights) % 2 and weights[-1] != fixed:
            weights.append(0)
        guide_channels.append(len(weights))
        weights += [fixed] * size
    weights += [0] * (len(weights) % 2)
    style_channel = len(weights)
    weights += [round(ONE / style_channels)] * style_channels
    weights += [0] * (-len(weights) % LANES)
    return Packing(
        tuple(guide_channels),
        tuple(guide_sizes),
        style_channel,
        style_channels,
        len(weights),
        np.array(weights, np.int64),
    )


def occurrence_weight(
    uniformity: float, patch_width: int, source_pixels: int, target_patches: int
) -> int:
    """Fixed-point factor of W in φ: ``λ / (w² ω_best)``, since λρ = λω/ω_best and W = w²ω.

    Returns
    -------
    int
    """
    best = omega_best(patch_width, source_pixels, target_patches)
    return round(ONE * uniformity / (patch_width**2 * best))
