"""Where points go along several edges of a graph of frames.

Motion belongs to a pixel of the frame where a path begins. It leads to a place between pixels of
the next frame, which takes the motion of its nearest pixel: a mean over an edge in depth would be
that of neither side. This is written apart from the library's own passes, which it judges.
"""

from collections import deque
from functools import reduce
from itertools import pairwise

import numpy as np

from stylit_ref.views.frames import Motion


def landing(motion):
    """The pixel of the other frame that is nearest to each pixel's point.

    Parameters
    ----------
    motion : Motion

    Returns
    -------
    y, x : (H, W) int
        0 where the point is not seen.
    seen : (H, W) bool
        Whether it is visible there, and inside.
    """
    height, width = motion.visible.shape
    moved = np.where(np.isfinite(motion.field), motion.field, width + height)
    x = np.floor(np.arange(width) + moved[..., 0] + 0.5)
    y = np.floor(np.arange(height)[:, None] + moved[..., 1] + 0.5)
    seen = motion.visible & (y >= 0) & (y < height) & (x >= 0) & (x < width)
    return np.where(seen, y, 0).astype(int), np.where(seen, x, 0).astype(int), seen


def compose(first, second):
    """Motion along two edges, one after the other.

    Parameters
    ----------
    first, second : Motion
        From frame a to b, and from b to c.

    Returns
    -------
    Motion
        From a to c; visible where the point is seen in all three.
    """
    y, x, seen = landing(first)
    field = np.where(seen[..., None], first.field + second.field[y, x], 0)
    return Motion(field.astype(np.float32), seen & second.visible[y, x])


def along(edges, path):
    """Motion from the first frame of a path to its last.

    Parameters
    ----------
    edges : mapping
    path : sequence of int
        Two frames or more, each a neighbour of the one before.

    Returns
    -------
    Motion
    """
    return reduce(compose, (edges[pair] for pair in pairwise(path)))


def shortest_paths(edges, start):
    """A shortest path to every frame that can be reached.

    Parameters
    ----------
    edges : mapping
    start : int

    Returns
    -------
    dict of int to tuple of int
        By the last frame; that of ``start`` is itself alone. Of several, the one whose frames come
        first.
    """
    paths, queue = {start: (start,)}, deque([start])
    while queue:
        frame = queue.popleft()
        for other in sorted(other for to, other in edges if to == frame):
            if other not in paths:
                paths[other] = (*paths[frame], other)
                queue.append(other)
    return paths


def pairs_apart(edges, frames, steps):
    """Paths between all frames that are so many edges apart, both ways.

    Parameters
    ----------
    edges : mapping
    frames : int
        How many there are.
    steps : int

    Returns
    -------
    list of tuple of int
    """
    return [
        path
        for start in range(frames)
        for path in shortest_paths(edges, start).values()
        if len(path) == steps + 1
    ]


def cells(edges):
    """Loops of four frames, such as those around a cell of a grid.

    Parameters
    ----------
    edges : mapping

    Returns
    -------
    list of tuple of 4 int
        Each once; opposite corners are no neighbours.
    """
    found = {}
    for a, b in sorted(edges):
        for c in sorted(other for to, other in edges if to == b and other != a):
            for d in sorted(other for to, other in edges if to == c and other not in (a, b)):
                if (d, a) in edges and (a, c) not in edges and (b, d) not in edges:
                    found.setdefault(frozenset((a, b, c, d)), (a, b, c, d))
    return list(found.values())
