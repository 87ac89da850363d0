"""Whether paint moves with its points: frames compared along the motion between them."""

import numpy as np

from eval.frame_sets import FrameSet
from eval.motion_paths import along, landing, pairs_apart
from eval.number import Number

LAGS = (1, 2, 5, 10)

NUMBERS = {
    "warping" if lag == 1 else f"warping_{lag}": Number(f"warping error, lag {lag}", "{:.2f}")
    for lag in LAGS
} | {"strokes": Number("warping error of strokes", "{:.2f}")}

DEFINITION = """\
- **warping error**: mean absolute difference between the value of a pixel and that of its point in
  a neighbouring frame, in 8-bit steps, over channels and the pixels that the neighbour shows, then
  over both directions of every edge. The nearest pixel is taken: interpolation would hide flicker.
  At a **lag** of 2 or more the frames are so many edges apart, and the motion along them is
  composed. **of strokes**: at lag 1, where pixels beside a silhouette take the motion of what is
  nearer: outlines that leave their thing and move with it count as still."""


def measure(scene, outcome):
    """The warping error at every lag that occurs among the frames."""
    if not isinstance(scene, FrameSet):
        return {}
    numbers = {}
    for name, lag in zip(NUMBERS, LAGS, strict=False):  # the last name is of no lag
        paths = pairs_apart(scene.edges, scene.frames, lag)
        if paths:
            numbers[name] = warping_error(outcome.image, scene.edges, paths)
    if scene.depths is not None:
        numbers["strokes"] = warping_error(outcome.image, scene.edges_of_strokes, list(scene.edges))
    return numbers


def warping_error(images, edges, paths):
    """The mean of the differences along some paths.

    Parameters
    ----------
    images : (F, H, W, n) uint8
    edges : mapping
    paths : sequence of tuple of int
        Their frames.

    Returns
    -------
    float
        Paths that nothing survives do not count; 0 if there is no other.
    """
    errors = [change(images[path[0]], images[path[-1]], along(edges, path)) for path in paths]
    seen = [error for error in errors if error is not None]
    return float(np.mean(seen)) if seen else 0.0


def change(image, other, motion):
    """How much the points of a frame differ in another one.

    Parameters
    ----------
    image, other : (H, W, n) uint8
    motion : Motion
        From the first to the second.

    Returns
    -------
    float or None
        In 8-bit steps; None if the other frame shows none of the points.
    """
    y, x, seen = landing(motion)
    if not seen.any():
        return None
    return float(np.abs(other[y, x][seen].astype(int) - image[seen]).mean())
