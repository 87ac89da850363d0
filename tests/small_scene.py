"""A small scene as a user would hand it over: images, not textures."""

import numpy as np
from skimage.filters import gaussian


def small_scene(
    seed=0, source_size=(40, 46), target_size=(38, 44), guide_channels=(3, 1), style_channels=3
):
    """Smooth guides, a style with grain: (style, source guides, target guides), uint8."""
    rng = np.random.default_rng(seed)

    def image(size, channels, sigma):
        noise = gaussian(rng.standard_normal((*size, channels)), sigma, channel_axis=2)
        return np.clip(128 + 60 * noise / noise.std(), 0, 255).astype(np.uint8)

    return (
        image(source_size, style_channels, 0.7),
        [image(source_size, channels, 5) for channels in guide_channels],
        [image(target_size, channels, 5) for channels in guide_channels],
    )
