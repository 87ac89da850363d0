"""6. Pyramid."""

import numpy as np

from .spec_01_names import (
    assigned_pixels,
    box_sum,
    clamp_to_centres,
    radius_of,
    source_shape_of,
    target_grid,
)


def blocks(image):
    """List the four pixels of the 2 x 2 blocks; a last odd row or column is left out."""
    height, width = image.shape[0] // 2 * 2, image.shape[1] // 2 * 2
    return [image[i:height:2, j:width:2] for i in (0, 1) for j in (0, 1)]


def downsample(image):
    """Halve an image, rounding the mean of a block."""
    return (sum(block.astype(np.int64) for block in blocks(image)) + 2) // 4


def parts_of(mask, radius):
    """Tell which pixels of the finest level take part: those within r of an unmasked one."""
    return box_sum((~mask).astype(np.int64), radius) > 0


def coarser_part(part):
    """Tell which pixels of a coarser level take part: those any of whose children does."""
    height, width = part.shape[0] // 2, part.shape[1] // 2
    ys, xs = target_grid(*part.shape)
    coarser = np.zeros((height, width), bool)
    np.logical_or.at(
        coarser, (np.minimum(ys // 2, height - 1), np.minimum(xs // 2, width - 1)), part
    )
    return coarser


def level_count(levels, sides, patch_width):
    """Count the levels: the coarsest is halved once less than there are levels."""
    count = 1
    while count < levels and min(sides) >> count >= patch_width:
        count += 1
    return count


def pyramid(finest, count, halve):
    """List the levels, from the coarsest to the finest."""
    levels = [finest]
    while len(levels) < count:
        levels.append(halve(levels[-1]))
    return levels[::-1]


def upsample_nnf(coarse_nnf, nnf, source_shape, radius):
    """Take the NNF from the coarser level for every pixel that is not at -1."""
    coarse_height, coarse_width = coarse_nnf.shape[:2]
    ys, xs = target_grid(*nnf.shape[:2])
    parent_y = np.minimum(ys // 2, coarse_height - 1)
    parent_x = np.minimum(xs // 2, coarse_width - 1)
    remainder = np.stack([ys - 2 * parent_y, xs - 2 * parent_x], axis=-1)
    fine = 2 * coarse_nnf[parent_y, parent_x] + remainder
    fine = clamp_to_centres(fine, source_shape, radius)
    return np.where(assigned_pixels(nnf)[..., None], fine, -1)


def stage_downsample(p, a):
    """Do stage downsample."""
    return {"image": downsample(a["image"])}


def stage_upsample_nnf(p, a):
    """Do stage upsample_nnf."""
    return {"nnf": upsample_nnf(a["coarse_nnf"], a["nnf"], source_shape_of(p), radius_of(p))}


STAGES = {"downsample": stage_downsample, "upsample_nnf": stage_upsample_nnf}
