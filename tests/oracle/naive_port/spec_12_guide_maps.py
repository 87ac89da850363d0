"""12. Guide maps."""

import math
from fractions import Fraction

import numpy as np

from .spec_01_names import assigned_pixels, offsets, radius_of, target_grid
from .spec_03_metric import delta, usable_centres


def source_patch_sums(guides, radius):
    """Sum the source patches of each channel; 0 off the centres."""
    height, width = guides.shape[:2]
    sums = np.zeros(guides.shape, np.int64)
    inner = sums[radius : height - radius, radius : width - radius]
    for dy, dx in offsets(radius):
        inner += guides[
            radius + dy : height - radius + dy, radius + dx : width - radius + dx
        ].astype(np.int64)
    return sums


def target_patch_sums(guides, radius):
    """Sum the target patches of each channel, with clamped coordinates."""
    height, width = guides.shape[:2]
    ys, xs = target_grid(height, width)
    sums = np.zeros(guides.shape, np.int64)
    for dy, dx in offsets(radius):
        y, x = np.clip(ys + dy, 0, height - 1), np.clip(xs + dx, 0, width - 1)
        sums += guides[y, x].astype(np.int64)
    return sums


def guide_variances(target_guides, guide_weights, radius):
    """Give V, w to the fourth times the variance of every target patch."""
    area = (2 * radius + 1) ** 2
    values = target_guides.astype(np.int64)
    sums = target_patch_sums(values, radius)
    squares = target_patch_sums(values * values, radius)
    return (area * squares - sums * sums)[..., guide_weights != 0].sum(axis=-1)


def white_pixels(variances, epsilon, radius):
    """Tell which target pixels are white."""
    return variances < math.ceil(Fraction(epsilon) * (2 * radius + 1) ** 4)


def guide_map(source_guides, target_guides, guide_weights, radius, epsilon):
    """Make the sums of source and target, the variances and the white pixels."""
    variances = guide_variances(target_guides, guide_weights, radius)
    return (
        source_patch_sums(source_guides, radius),
        target_patch_sums(target_guides, radius),
        variances,
        white_pixels(variances, epsilon, radius),
    )


def white_delta(source, target, weights, nnf, radius, source_sums, target_sums, white):
    """Measure as in 3, but where white the guides by the sums of their patches."""
    n_g = source_sums.shape[-1]
    area = (2 * radius + 1) ** 2
    guides = delta(source[..., :n_g], target[..., :n_g], weights[:n_g], nnf, radius)
    style = delta(source[..., n_g:], target[..., n_g:], weights[n_g:], nnf, radius)
    centres = usable_centres(nnf, radius)
    difference = target_sums - source_sums[centres[..., 0], centres[..., 1]]
    white_guides = (weights[:n_g] * difference * difference).sum(axis=-1) // area
    total = np.where(white, white_guides, guides) + style
    return np.where(assigned_pixels(nnf), total, 0)


def stage_guide_map(p, a):
    """Do stage guide_map."""
    n_g = p["guide_channels"]
    source_sums, target_sums, variances, white = guide_map(
        a["source"][..., :n_g], a["target"][..., :n_g], a["weights"][:n_g], radius_of(p),
        p["epsilon"],
    )  # fmt: skip
    return {
        "source_sums": source_sums,
        "target_sums": target_sums,
        "variances": variances,
        "white": white,
    }


def stage_white_delta(p, a):
    """Do stage white_delta."""
    n_g, radius = p["guide_channels"], radius_of(p)
    source_sums = source_patch_sums(a["source"][..., :n_g], radius)
    target_sums = target_patch_sums(a["target"][..., :n_g], radius)
    values = white_delta(
        a["source"], a["target"], a["weights"], a["nnf"], radius, source_sums, target_sums,
        a["white"],
    )  # fmt: skip
    return {"delta": values}


STAGES = {"guide_map": stage_guide_map, "white_delta": stage_white_delta}
