"""Whether drawn lines keep to the edges of the model: Hauptfleisch 2020, 2.4.1 and Figure 2.6."""

import numpy as np
from scipy.ndimage import gaussian_filter, map_coordinates
from skimage.transform import probabilistic_hough_line

from eval.number import Number

EDGES = "WIREFRAME"
"""The guide or buffer in which the model's edges are drawn."""

REACH = 3.0
"""Pixels to both sides of an edge within which its line is looked for, in a picture of 228 rows."""

SHORTEST = 20
"""Pixels of the shortest edge that counts, in a picture of 228 rows."""

_FAINTEST = 12.0
"""8-bit steps by which a line is darker than the paper beside it."""

NUMBERS = {
    "crooked": Number("lines off straight", "{:.2f}"),
    "lost_lines": Number("lines lost", "{:.1%}"),
}

DEFINITION = """\
- **lines off straight**: along each straight edge of the model as the target shows it, the RMS
  distance in pixels of the drawn line from the straight line that fits it best, over the same of
  the painting along the edges of the source. **lines lost**: share of these edges along which the
  output has no line, less that of the painting."""


def measure(scene, outcome):
    """Both numbers, if the scene has the model's edges."""
    edges = _edges_of(scene)
    if edges is None:
        return {}
    ours, theirs = (
        drawn_along(image, edge)
        for image, edge in zip((outcome.image, scene.style), edges[::-1], strict=True)
    )
    if ours is None or theirs is None or theirs[0] == 0:
        return {}
    return {"crooked": ours[0] / theirs[0], "lost_lines": ours[1] - theirs[1]}


def drawn_along(image, edges):
    """How the lines of a drawing follow the straight edges of a model.

    Parameters
    ----------
    image : (H, W, n) uint8
    edges : (H, W) uint8
        White where the model has an edge.

    Returns
    -------
    (float, float) or None
        RMS distance in pixels from the best straight line; share of the edges' length without a
        line. None if there are no straight edges.
    """
    scale = max(1.0, image.shape[0] / 228)
    grey = gaussian_filter(np.atleast_3d(image).astype(float).mean(axis=2), 0.7 * scale)
    offsets = np.linspace(-REACH * scale, REACH * scale, 13)
    squares, found, looked_at = 0.0, 0, 0
    for start, end in straight_edges(edges):
        along = end - start
        length = np.linalg.norm(along)
        across = along[::-1] * (-1, 1) / length
        steps = np.linspace(0, 1, int(length) + 1)
        points = start + steps[:, None, None] * along + offsets[:, None] * across
        profile = map_coordinates(grey, [points[..., 1], points[..., 0]], order=1, mode="nearest")
        # A line is darker than what lies on both its sides.
        sides = np.minimum(profile[:, 0], profile[:, -1])[:, None]
        ink = np.maximum(sides - profile, 0)
        is_drawn = ink.max(axis=1) > _FAINTEST
        looked_at += len(steps)
        found += is_drawn.sum()
        if is_drawn.sum() > 3:
            weight = ink[is_drawn] ** 2
            beside = (weight * offsets).sum(axis=1) / weight.sum(axis=1)
            fitted = np.polyval(np.polyfit(steps[is_drawn], beside, 1), steps[is_drawn])
            squares += ((beside - fitted) ** 2).sum()
    if not found:
        return None
    return float(np.sqrt(squares / found)), float(1 - found / looked_at)


def straight_edges(edges):
    """Straight pieces of the model's edges, the same for the same picture.

    Parameters
    ----------
    edges : (H, W) uint8

    Returns
    -------
    (N, 2, 2) float
        Both ends, (x, y).
    """
    length = round(SHORTEST * max(1.0, edges.shape[0] / 228))
    found = probabilistic_hough_line(
        edges > 127, threshold=10, line_length=length, line_gap=3, rng=0
    )
    return np.array(found, float).reshape(-1, 2, 2)


def _edges_of(scene):
    """The edges of source and target, (H, W) each, or None."""
    if EDGES in scene.buffers:
        pair = scene.buffers[EDGES]
    elif EDGES in scene.guide_names:
        number = scene.guide_names.index(EDGES)
        pair = scene.source_guides[number], scene.target_guides[number]
    else:
        return None
    return tuple(np.atleast_3d(image)[..., 0] for image in pair)
