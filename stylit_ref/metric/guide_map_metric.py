"""δ with a guide map (thesis 5.2.2), in vector code for the CPU."""

from collections.abc import Callable

import numpy as np

from stylit_ref.formulae.guide_map import guides_by_means
from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.vector_ssd import make_weighted_ssd


def make_guide_map_delta(
    patch_width: int, channels: int, mean_channels: int, patch_delta: Callable[..., int]
) -> Callable[..., int]:
    """Compile the SSD of thesis 5.2.2.

    Parameters
    ----------
    patch_width, channels, mean_channels : int
        See :func:`stylit_ref.metric.textures.vector_sizes`.
    patch_delta : callable
        δ for patches that are black on the map.

    Returns
    -------
    callable
        ``(textures, y, x, source_y, source_x) -> int64``: δ in fixed point; for a white patch equal
        to :func:`stylit_ref.formulae.guide_map.delta_by_means`.
    """
    radius = patch_width // 2
    style_ssd = make_weighted_ssd(
        patch_width, patch_width, channels, element_bits=8, first_channel=mean_channels
    )

    @inlined
    def guide_map_delta(textures, y, x, source_y, source_x):
        if not textures.guide_map[y, x]:
            return patch_delta(textures, y, x, source_y, source_x)
        # Unsigned: with signed indices, Numba would check at every read for negative ones, which
        # count from the end.
        guides = guides_by_means(
            textures.weights, textures.target_sums, textures.source_sums, mean_channels,
            patch_width, np.uint64(y), np.uint64(x), np.uint64(source_y), np.uint64(source_x),
        )  # fmt: skip
        source_stride = np.int64(textures.source.shape[1]) * channels
        target_stride = np.int64(textures.target.shape[1]) * channels
        return guides + style_ssd(
            textures.target,
            y * target_stride + x * channels,
            target_stride,
            textures.source,
            (source_y - radius) * source_stride + (source_x - radius) * channels,
            source_stride,
            textures.style_pair_weights,
        )

    return guide_map_delta
