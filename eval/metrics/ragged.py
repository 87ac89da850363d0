"""Whether painted edges run as smoothly along silhouettes as those of the painting."""

import numpy as np
from scipy.ndimage import gaussian_filter, gaussian_filter1d, map_coordinates
from skimage.measure import find_contours

from eval.metrics.wrong_things import FOREGROUND, views_of
from eval.number import Number

REACH = 6.0
"""Pixels to both sides of a silhouette within which its painted edge is looked for."""

SMOOTH = 3.0
"""Pixels along a silhouette (σ) over which an edge's course is its own, and not raggedness."""

_FAINTEST = 20.0
"""8-bit steps between both sides of a painted edge that can be seen."""

NUMBERS = {"ragged": Number("ragged edges", "{:.2f}")}

DEFINITION = """\
- **ragged edges**: along the silhouettes of the target, the RMS distance of the painted edge from
  its own smooth course (σ = 3 pixels along the silhouette), over that of the painting along the
  silhouettes of the source; 1 means as ragged as the painting is."""


def measure(scene, outcome):
    """The number, if the scene's masks are known and both pictures have edges there."""
    views = views_of(scene)
    if views is None:
        return {}
    source, target = (view.labels == FOREGROUND for view in views)
    ours, theirs = raggedness(outcome.image, target), raggedness(scene.style, source)
    return {"ragged": ours / theirs} if theirs and ours is not None else {}


def raggedness(image, mask):
    """How far painted edges stray from their smooth course.

    Parameters
    ----------
    image : (H, W, n) uint8
    mask : (H, W) bool
        Edges are looked for along its outline.

    Returns
    -------
    float or None
        RMS of pixels; None if no edge shows.
    """
    image = np.atleast_3d(image).astype(float)
    smooth = gaussian_filter(mask.astype(float), 1.0)
    offsets = np.arange(-REACH, REACH + 0.5, 0.5)
    squares, weights = 0.0, 0.0
    for outline in find_contours(smooth, 0.5):
        course = gaussian_filter1d(outline, 2.0, axis=0, mode="nearest")
        along = np.gradient(course, axis=0)
        length = np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
        across = along[:, ::-1] * (-1, 1) / length
        places = course[:, None] + offsets[:, None] * across[:, None]
        profiles = np.stack(
            [
                map_coordinates(channel, places.reshape(-1, 2).T, order=1, mode="nearest")
                for channel in np.moveaxis(image, -1, 0)
            ],
            axis=-1,
        ).reshape(*places.shape[:2], -1)
        edge, contrast = _edges(profiles, offsets)
        seen = contrast > _FAINTEST
        if not seen.any():
            continue
        course = gaussian_filter1d(edge * seen, SMOOTH) / np.maximum(
            gaussian_filter1d(seen.astype(float), SMOOTH), 1e-9
        )
        squares += ((edge - course)[seen] ** 2).sum()
        weights += seen.sum()
    return float(np.sqrt(squares / weights)) if weights else None


def _edges(profiles, offsets):
    """Where each profile changes from one side's colour to the other's, and by how much.

    Parameters
    ----------
    profiles : (N, k, n) float
    offsets : (k,) float

    Returns
    -------
    edge, contrast : (N,) float
    """
    end = len(offsets) // 4
    one, other = profiles[:, :end].mean(axis=1), profiles[:, -end:].mean(axis=1)
    way = other - one
    contrast = np.linalg.norm(way, axis=1)
    share = ((profiles - one[:, None]) * way[:, None]).sum(axis=2)
    share = (share / np.maximum(contrast[:, None] ** 2, 1e-9)).clip(0, 1)
    # The edge lies where as much of the profile before it is of the other side as after it is not.
    step = offsets[1] - offsets[0]
    return offsets[-1] - (share[:, 1:] + share[:, :-1]).sum(axis=1) / 2 * step, contrast
