"""3. Levels."""

import numpy as np

from .spec_01_names import clamped, grid_of, ranges

FREE = -1


def halved(image):
    """Give the next coarser level of an image."""
    height, width = ((side + 1) // 2 for side in image.shape[:2])
    half = np.zeros((height, width, image.shape[2]), int)
    for y, x in np.ndindex(height, width):
        four = [clamped(image, 2 * y + v, 2 * x + u) for v in (0, 1) for u in (0, 1)]
        half[y, x] = (sum(four) + 2) >> 2
    return half


def pyramid(image, levels):
    """List an image on all levels."""
    images = [image]
    while len(images) < levels:
        images.append(halved(images[-1]))
    return images


def picked(labels, level):
    """Give labels of a level."""
    return labels[:: 1 << level, :: 1 << level]


def entry_labels(source, target, width, spacing):
    """Give the labels of the entries, from labels of one level."""
    (top, bottom), (left, right) = ranges(source.shape, width)
    known = set(source[top : bottom + 1, left : right + 1].ravel().tolist())
    found = np.full(grid_of(target.shape, spacing), FREE)
    for a, b in np.ndindex(found.shape):
        label = int(target[a * spacing, b * spacing])
        if label in known:
            found[a, b] = label
    return found


def stage_halve(p, a):
    """Do stage halve."""
    return {"half": halved(a["image"])}


def stage_entry_labels(p, a):
    """Do stage entry_labels."""
    sides = (picked(a[name], p["level"]) for name in ("source_labels", "target_labels"))
    return {"labels": entry_labels(*sides, p["patch_width"], p["spacing"])}


STAGES = {"halve": stage_halve, "entry_labels": stage_entry_labels}
