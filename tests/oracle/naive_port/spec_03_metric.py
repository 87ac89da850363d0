"""3. The metric."""

import numpy as np

from .spec_01_names import assigned_pixels, offsets, radius_of, target_grid


def usable_centres(nnf, radius):
    """Replace -1 by some centre, so that whole grids can be measured; the result is masked."""
    return np.where(assigned_pixels(nnf)[..., None], nnf, radius)


def patch_values(source, target, pixels, centres, dy, dx):
    """Give the target's and the source's values at an offset in their patches."""
    height, width = target.shape[:2]
    y = np.clip(pixels[..., 0] + dy, 0, height - 1)
    x = np.clip(pixels[..., 1] + dx, 0, width - 1)
    source_values = source[centres[..., 0] + dy, centres[..., 1] + dx]
    return target[y, x].astype(np.int64), source_values.astype(np.int64)


def patch_delta(source, target, weights, pixels, centres, radius):
    """Compare the patches of target pixels and of source centres."""
    total = np.zeros(pixels.shape[:-1], np.int64)
    for dy, dx in offsets(radius):
        target_values, source_values = patch_values(source, target, pixels, centres, dy, dx)
        difference = target_values - source_values
        total += (weights * difference * difference).sum(axis=-1)
    return total


def delta(source, target, weights, nnf, radius):
    """Compare the patches of each target pixel and of its source centre; 0 at -1."""
    pixels = np.stack(target_grid(*nnf.shape[:2]), axis=-1)
    total = patch_delta(source, target, weights, pixels, usable_centres(nnf, radius), radius)
    return np.where(assigned_pixels(nnf), total, 0)


def penalty(omega_sums, occurrence_weight, nnf):
    """Give lambda rho of each assignment; of no meaning at -1."""
    return occurrence_weight * omega_sums[nnf[..., 0], nnf[..., 1]]


def phi(delta_values, omega_sums, occurrence_weight, nnf):
    """Add the penalty to delta; 0 at -1."""
    total = penalty(omega_sums, occurrence_weight, nnf) + delta_values
    return np.where(assigned_pixels(nnf), total, 0)


def stage_delta(p, a):
    """Do stage delta."""
    n_g = p["guide_channels"]
    guides, style = (
        delta(
            a["source"][..., part], a["target"][..., part], a["weights"][part], a["nnf"],
            radius_of(p),
        )
        for part in (slice(None, n_g), slice(n_g, None))
    )  # fmt: skip
    return {"delta_guides": guides, "delta_style": style}


def stage_phi(p, a):
    """Do stage phi."""
    return {"phi": phi(a["delta"], a["omega_sums"], p["occurrence_weight"], a["nnf"])}


STAGES = {"delta": stage_delta, "phi": stage_phi}
