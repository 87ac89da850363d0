"""Which pixel of a painted sphere has a normal: what Lit Sphere and StyleBlit look up."""

from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from stylit_ref import InputError

BUFFERS = "NORMAL", "IDMASK"
"""The passes of a scene that both methods read; red in IDMASK is the object."""

_FAR = 64.0
"""A quarter of the sphere: what faces away as far from all of its pixels takes the front's."""


class Object(NamedTuple):
    """What a view shows of its object.

    Attributes
    ----------
    normals : (H, W, 3) uint8
        ``(n + 1) / 2``, rounded.
    mask : (H, W) bool
    """

    normals: np.ndarray
    mask: np.ndarray


def objects(scene):
    """The objects of source and target.

    Raises
    ------
    InputError
        If the scene was read without these buffers, or shows no object.
    """
    if not set(BUFFERS) <= scene.buffers.keys():
        raise InputError(
            f"{scene.name}: was read without {' and '.join(BUFFERS)}, which a method that looks up "
            "normals needs"
        )
    normals, ids = (scene.buffers[name] for name in BUFFERS)
    views = [Object(n, i[..., 0] > 127) for n, i in zip(normals, ids, strict=True)]
    if not all(view.mask.any() for view in views):
        raise InputError(f"{scene.name}: shows no object, which is red in IDMASK")
    return views


def normal_table(source):
    """For every direction the pixel of the sphere that faces it best.

    Parameters
    ----------
    source : Object

    Returns
    -------
    (2, 256, 256) int32
        Position ``y * width + x`` in the source for the 8-bit x and y of a normal; the first table
        is for an 8-bit z below 128, the second for one above.
    """
    y, x = np.nonzero(source.mask)
    tree = cKDTree(source.normals[y, x].astype(float))
    steps = np.arange(256) - 127.5
    across, up = np.meshgrid(steps, steps, indexing="ij")
    reach = np.maximum(np.hypot(across, up) / 127.5, 1)  # no normal is longer than 1
    away = np.sqrt(np.maximum(127.5**2 - across**2 - up**2, 0))
    directions = (
        np.stack([across / reach, up / reach, sign * away], axis=-1) + 127.5 for sign in (-1, 1)
    )
    back, front = (tree.query(each, distance_upper_bound=_FAR)[1] for each in directions)
    front = np.minimum(front, len(y) - 1)  # what is far from all has the tree's size as its number
    nearest = np.stack([np.where(back < len(y), back, front), front])
    return (y * source.mask.shape[1] + x).astype(np.int32)[nearest]


def looked_up(table, normals):
    """Positions in the source for normals (..., 3) uint8."""
    return table[(normals[..., 2] >> 7), normals[..., 0], normals[..., 1]]
