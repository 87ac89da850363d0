"""How large the pieces are that a texture copies from its exemplar."""

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from eval.number import Number
from eval.textures import Texture

NUMBERS = {
    "piece": Number("piece [px]", "{:.0f}"),
    "largest_piece": Number("largest piece [px]", "{:.0f}"),
}

DEFINITION = """\
- **piece**: how many pixels the piece of a random pixel has; a piece is connected and copied
  without a change from one place of the exemplar. **largest piece**: the most of them."""


def measure(scene, outcome):
    """Sizes of pieces, if the method tells its coordinates."""
    if not isinstance(scene, Texture) or outcome.coordinates is None:
        return {}
    sizes = piece_sizes(outcome.coordinates)
    return {"piece": float((sizes**2).sum() / sizes.sum()), "largest_piece": float(sizes.max())}


def piece_sizes(coordinates):
    """Pixels of every piece; the border cuts pieces.

    Parameters
    ----------
    coordinates : (h, w, 3) int32
        Exemplar, y and x in quarters of a pixel.

    Returns
    -------
    (n,) float64
    """
    height, width = coordinates.shape[:2]
    number = np.arange(height * width).reshape(height, width)
    step = np.array([0, 4, 4])
    down = (coordinates[1:] - coordinates[:-1] == step * [1, 1, 0]).all(axis=2)
    along = (coordinates[:, 1:] - coordinates[:, :-1] == step * [1, 0, 1]).all(axis=2)
    here = np.concatenate([number[:-1][down], number[:, :-1][along]])
    there = np.concatenate([number[1:][down], number[:, 1:][along]])
    graph = coo_array((np.ones(here.size, np.int8), (here, there)), shape=(number.size,) * 2)
    _, labels = connected_components(graph, directed=False)
    return np.bincount(labels).astype(float)
