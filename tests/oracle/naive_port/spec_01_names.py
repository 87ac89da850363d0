"""1. Names.

Grids of pixels are int64 arrays inside; section 17 gives the outputs their types.
"""

import numpy as np


def offsets(radius):
    """List (dy, dx) of a patch in rows."""
    span = range(-radius, radius + 1)
    return [(dy, dx) for dy in span for dx in span]


def assigned_pixels(nnf):
    """Tell which target pixels hold a source patch (are not at -1)."""
    return nnf[..., 0] >= 0


def target_grid(height, width):
    """Give the rows and columns of all pixels."""
    return np.meshgrid(np.arange(height), np.arange(width), indexing="ij")


def clamp_to_centres(nnf, source_shape, radius):
    """Clamp each coordinate to the centres of the source."""
    low = np.array([radius, radius])
    high = np.array([source_shape[0] - 1 - radius, source_shape[1] - 1 - radius])
    return np.minimum(np.maximum(nnf, low), high)


def box_sum(values, radius):
    """Sum the w x w pixels around each pixel; pixels outside count 0."""
    height, width = values.shape
    padded = np.pad(values, radius)
    total = np.zeros((height, width), np.int64)
    for dy, dx in offsets(radius):
        total += padded[radius + dy : radius + dy + height, radius + dx : radius + dx + width]
    return total


def patch_counts(nnf, source_shape):
    """Count the patches centred at each source pixel."""
    counts = np.zeros(source_shape, np.int64)
    centres = nnf[assigned_pixels(nnf)]
    np.add.at(counts, (centres[:, 0], centres[:, 1]), 1)
    return counts


def occurrence(nnf, source_shape, radius):
    """Count omega and W, its sums over patches."""
    omega = box_sum(patch_counts(nnf, source_shape), radius)
    return omega, box_sum(omega, radius)


def radius_of(p):
    """Give the radius of the case's patches."""
    return p["patch_width"] // 2


def source_shape_of(p):
    """Give the size of a source that is known by its size only."""
    return p["source_height"], p["source_width"]


def stage_occurrence(p, a):
    """Do stage occurrence."""
    omega, omega_sums = occurrence(a["nnf"], source_shape_of(p), radius_of(p))
    return {"omega": omega, "omega_sums": omega_sums}


STAGES = {"occurrence": stage_occurrence}
