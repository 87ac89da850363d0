"""Cuts between two pictures that overlap (figures 3 and 5): by graph-cut, and by columns."""

import numpy as np
from numba import njit
from scipy.sparse import coo_array
from scipy.sparse.csgraph import breadth_first_order, maximum_flow

FIXED = 256
"""What a cost of 1 is as an integer."""

_ETA, _LARGEST = 1000, 1 << 22


def edge_costs(left, right):
    """M between a pixel of one picture and its neighbour in the other.

    Parameters
    ----------
    left, right : (H, W, c) uint8
        What each shows in the overlap.

    Returns
    -------
    along, down : (H, W) int64
        Of the edge to the right of each pixel, and of the edge below; the last ones are 0.
    """
    left, right = left.astype(np.int64), right.astype(np.int64)
    costs = []
    for axis in (1, 0):

        def moved(image, axis=axis):
            return np.take(image, np.minimum(np.arange(1, image.shape[axis] + 1),
                                             image.shape[axis] - 1), axis)  # fmt: skip

        difference = ((left - right) ** 2).sum(axis=2)
        gradients = sum(((image - moved(image)) ** 2).sum(axis=2) for image in (left, right))
        quotient = (difference + moved(difference)) / (_ETA + gradients)
        cost = np.minimum(np.rint(quotient**2 * FIXED), _LARGEST).astype(np.int64)
        cost[(slice(None), -1) if axis else (-1,)] = 0
        costs.append(cost)
    return tuple(costs)


def graph_cut(along, down):
    """The labelling with the cheapest border: the first column is left, the last is right.

    Parameters
    ----------
    along, down : (H, W) int64

    Returns
    -------
    (H, W) bool
        Where the left picture shows.
    """
    height, width = along.shape
    number = np.arange(height * width).reshape(height, width)
    first, last = height * width, height * width + 1
    pairs = [
        (number[:, :-1].ravel(), number[:, 1:].ravel(), along[:, :-1].ravel()),
        (number[:-1].ravel(), number[1:].ravel(), down[:-1].ravel()),
    ]
    here, there, costs = (np.concatenate(parts) for parts in zip(*pairs, strict=True))
    ends = np.full(height, 1 << 30)
    start = np.concatenate([here, there, np.full(height, first), number[:, -1]])
    end = np.concatenate([there, here, number[:, 0], np.full(height, last)])
    capacity = np.concatenate([costs, costs, ends, ends]).astype(np.int32)
    graph = coo_array((capacity, (start, end)), shape=(height * width + 2,) * 2).tocsr()
    rest = graph - maximum_flow(graph, first, last).flow
    rest.data = np.maximum(rest.data, 0)
    rest.eliminate_zeros()
    reached = breadth_first_order(rest, first, return_predecessors=False)
    left = np.zeros(height * width + 2, np.bool_)
    left[reached] = True
    return left[:-2].reshape(height, width)


def column_cut(along, down, jump):
    """The labelling whose border is one column a row, which moves by at most ``jump`` (section 4).

    Parameters
    ----------
    along, down : (H, W) int64
    jump : int
        J_max.

    Returns
    -------
    (H, W) bool
        Where the left picture shows.
    """
    columns = _cheapest_columns(along[:, :-1], down, jump)
    return np.arange(along.shape[1]) <= columns[:, None]


@njit
def _cheapest_columns(along, down, jump):
    height, width = along.shape
    totals, origins = along.copy(), np.zeros((height, width), np.int64)
    for y in range(1, height):
        running = np.cumsum(down[y - 1])
        for x in range(width):
            best = np.int64(1) << 60
            for j in range(max(0, x - jump), min(width, x + jump + 1)):
                total = totals[y - 1, j] + abs(running[x] - running[j])
                if total < best:
                    best, origins[y, x] = total, j
            totals[y, x] += best
    columns = np.empty(height, np.int64)
    columns[-1] = np.argmin(totals[-1])
    for y in range(height - 1, 0, -1):
        columns[y - 1] = origins[y, columns[y]]
    return columns


def border_cost(left_shows, along, down):
    """What the border of a labelling costs, in units of M."""
    total = along[:, :-1][left_shows[:, :-1] != left_shows[:, 1:]].sum()
    return float((total + down[:-1][left_shows[:-1] != left_shows[1:]].sum()) / FIXED)
