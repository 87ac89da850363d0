"""Colours that tell labels apart."""

import numpy as np

_STEPS = np.arange(0, 256, 17)
_PALETTE = np.stack(np.meshgrid(_STEPS, _STEPS, _STEPS, indexing="ij"), axis=-1).reshape(-1, 3)

MOST_LABELS = len(_PALETTE)
"""As many labels can have a colour of their own."""


def distinct_colours(count: int) -> list[tuple[int, int, int]]:
    """Choose colours far apart: black, and then always the one farthest from those before.

    Parameters
    ----------
    count : int
        At most :data:`MOST_LABELS`.

    Returns
    -------
    list of (r, g, b)
        From 0 to 255. Fewer colours are the first of more.
    """
    chosen, distance = [], np.full(MOST_LABELS, 3 * 255**2 + 1)
    for _ in range(count):
        colour = _PALETTE[distance.argmax()]  # the first of several
        chosen.append(tuple(colour.tolist()))
        distance = np.minimum(distance, ((_PALETTE - colour) ** 2).sum(axis=1))
    return chosen
