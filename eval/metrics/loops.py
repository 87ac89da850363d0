"""What a round of four views shows of a point."""

import numpy as np

from eval.frame_sets import FrameSet
from eval.motion_paths import along, cells, landing
from eval.number import Number

NUMBERS = {
    "round": Number("round of a cell", "{:.2f}"),
    "round_gap": Number("gap of a round [px]", "{:.2f}"),
}

DEFINITION = """\
- **round of a cell**: the picture of a view is shifted around a cell of the grid. Mean over points
  seen in all four views of the largest difference between any two of them, in 8-bit steps.
  **gap**: how far from where it began the motion of a round ends, mean in pixels; a large one tells
  of wrong motion."""


def measure(scene, outcome):
    """Both numbers, if the frames have cells."""
    found = cells(scene.edges) if isinstance(scene, FrameSet) else []
    rounds = [round_of(outcome.image, scene.edges, cell) for cell in found]
    rounds = [each for each in rounds if each is not None]
    if not rounds:
        return {}
    spread, gap = np.mean(rounds, axis=0)
    return {"round": float(spread), "round_gap": float(gap)}


def round_of(images, edges, cell):
    """The largest difference at a point, and the gap of the motion, means over points.

    Parameters
    ----------
    images : (F, H, W, n) uint8
    edges : mapping
    cell : tuple of 4 int
        Frames, each a neighbour of the one before, and the last of the first.

    Returns
    -------
    tuple of 2 float, or None
        None if no point is seen all around.
    """
    paths = [cell[: k + 1] for k in range(1, 4)]
    ends = [landing(along(edges, path)) for path in paths]
    home = along(edges, (*cell, cell[0]))
    seen = np.logical_and.reduce([home.visible, *(end[2] for end in ends)])
    if not seen.any():
        return None
    values = [images[cell[0]][seen]] + [
        images[path[-1]][y[seen], x[seen]] for path, (y, x, _) in zip(paths, ends, strict=True)
    ]
    spread = np.ptp(np.stack(values).astype(int), axis=0).mean()
    return float(spread), float(np.hypot(*home.field[seen].T).mean())
