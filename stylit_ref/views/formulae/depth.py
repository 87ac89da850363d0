"""What renderers write where nothing is: no depth is told there."""

import numpy as np

FARTHEST = 1e9
"""As far as that, and farther, nothing is."""


def depth_of_things(depth: np.ndarray) -> np.ndarray:
    """Depth that is infinite where nothing is: 0 or less, very large, infinite, or no number.

    Parameters
    ----------
    depth : (H, W) float32
        Farther is larger.

    Returns
    -------
    (H, W) float32
    """
    return np.where((depth > 0) & (depth < FARTHEST), depth, np.float32(np.inf))


def inverse_depth(depth: np.ndarray) -> np.ndarray:
    """1 / depth, and 0 where nothing is.

    Parameters
    ----------
    depth : (H, W) float32
        Farther is larger.

    Returns
    -------
    (H, W) float64
    """
    return 1 / depth_of_things(depth).astype(np.float64)
