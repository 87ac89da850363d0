"""2. Weights."""

import numpy as np


def channel_weights(guide_channels, guide_weights, style_channels, guide_influence):
    """Give each channel its fixed-point weight."""
    n_g = sum(guide_channels)
    if not guide_weights:
        guide_weights = [1] * len(guide_channels)
    weights = []
    for channels, guide_weight in zip(guide_channels, guide_weights, strict=True):
        for _ in range(channels):
            product = 65536.0 * (float(guide_influence) / n_g)
            weights.append(round(product * float(guide_weight)))
    weights += [round(65536.0 / style_channels)] * style_channels
    return np.array(weights, np.int64)


def occurrence_weight_of(uniformity, patch_width, source_pixels, target_patches):
    """Give the fixed-point weight of W."""
    area = patch_width * patch_width
    best = float(area * target_patches) / float(source_pixels)
    return round((65536.0 * float(uniformity)) / (float(area) * best))


def stage_weights(p, a):
    """Do stage weights."""
    return {
        "weights": channel_weights(
            p["guide_channels"], p["guide_weights"], p["style_channels"], p["guide_influence"]
        ),
        "occurrence_weight": occurrence_weight_of(
            p["uniformity"], p["patch_width"], p["source_pixels"], p["target_patches"]
        ),
    }


STAGES = {"weights": stage_weights}
