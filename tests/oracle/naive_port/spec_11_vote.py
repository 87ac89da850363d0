"""11. Vote."""

import numpy as np

from .spec_01_names import assigned_pixels, offsets, radius_of, target_grid


def gather_votes(style, nnf, radius):
    """List the votes every pixel hears, in rows of the patches: values and which are cast."""
    height, width = nnf.shape[:2]
    ys, xs = target_grid(height, width)
    values, cast = [], []
    for dy, dx in offsets(radius):
        y, x = ys + dy, xs + dx
        inside = (y >= 0) & (y < height) & (x >= 0) & (x < width)
        patch = nnf[np.clip(y, 0, height - 1), np.clip(x, 0, width - 1)]
        heard = inside & assigned_pixels(patch)
        pixel = np.where(heard[..., None], patch - np.array([dy, dx]), 0)
        values.append(style[pixel[..., 0], pixel[..., 1]].astype(np.int64))
        cast.append(heard)
    return np.stack(values), np.stack(cast)


def leave_out(values, cast, outliers):
    """Take away the votes farthest from the mean of all; one always stays."""
    n = cast.sum(axis=0)
    total = (values * cast[..., None]).sum(axis=0)
    distance = ((n[..., None] * values - total) ** 2).sum(axis=-1)
    ys, xs = target_grid(*n.shape)
    kept = cast.copy()
    for _ in range(outliers):
        farthest = np.where(kept, distance, -1).argmax(axis=0)  # the first of equals
        drop = kept.sum(axis=0) > 1
        kept[farthest[drop], ys[drop], xs[drop]] = False
    return kept


def vote(style, nnf, radius, outliers=0):
    """Give every pixel the mean of its votes, rounded half up; 0 without votes."""
    values, cast = gather_votes(style, nnf, radius)
    kept = leave_out(values, cast, outliers)
    n = kept.sum(axis=0)[..., None]
    total = (values * kept[..., None]).sum(axis=0)
    return np.where(n > 0, (2 * total + n) // np.maximum(2 * n, 1), 0)


def stage_vote(p, a):
    """Do stage vote."""
    return {"style": vote(a["style"], a["nnf"], radius_of(p), p["outliers"])}


STAGES = {"vote": stage_vote}
