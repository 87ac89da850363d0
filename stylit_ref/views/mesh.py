"""A scene's surface as triangles, and which of them form one face."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError

SMOOTH = 30.0
"""Triangles that meet at an edge belong to one face if they turn by less, in degrees."""

_LEAST_EXACT = 1e-6
"""Vertices may be rounded by that part of what the scene measures: by 1/1000 of a pixel."""


class Mesh(NamedTuple):
    """Triangles.

    Attributes
    ----------
    vertices : (V, 3) float32 or float64
        In the units of the cameras. 64 bits where the scene lies so far from where its coordinates
        are 0 that 32 could move it.
    faces : (T, 3) int32
        The corners of every triangle.
    groups : (T,) int32
        Which face it belongs to: strokes are not shifted from one to another.
    """

    vertices: NDArray[np.float32 | np.float64]
    faces: NDArray[np.int32]
    groups: NDArray[np.int32]


def make_mesh(
    vertices: NDArray[np.floating[Any]],
    faces: NDArray[np.integer[Any]],
    parts: NDArray[np.integer[Any]] | None = None,
) -> Mesh:
    """A mesh whose triangles form faces: those of a part that meet smoothly.

    Vertices at one place count as one, so that polygons with corners of their own meet.

    Parameters
    ----------
    vertices : (V, 3) float
    faces : (T, 3) int
    parts : (T,) int, optional
        The object, or the material, of each triangle.

    Returns
    -------
    Mesh

    Raises
    ------
    InputError
        If there are no triangles, a vertex is no number, or a face names one that is not there.
    """
    exact = np.ascontiguousarray(vertices, np.float64)
    with np.errstate(over="ignore"):
        vertices = exact.astype(np.float32)
    faces = np.ascontiguousarray(faces, np.int32)
    if not len(faces):
        raise InputError("holds no faces; export the scene with its faces")
    if not np.isfinite(vertices).all():
        raise InputError("holds a vertex that is no finite number; export the scene again")
    if np.spacing(np.abs(vertices).max()) / 2 > _LEAST_EXACT * np.ptp(exact, axis=0).max():
        vertices = exact
    if faces.min() < 0 or faces.max() >= len(vertices):
        raise InputError(
            f"holds a face with the vertex {faces.max()}, and there are {len(vertices)}; export "
            "the scene again"
        )
    parts = np.zeros(len(faces), np.int32) if parts is None else np.asarray(parts)
    return Mesh(vertices, faces, _smooth_groups(vertices, faces, parts))


def _smooth_groups(vertices, faces, parts):
    # Imported late: they take a tenth of the start-up time.
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    _, same = np.unique(vertices, axis=0, return_inverse=True)
    edges, owners = _edges(same.reshape(-1)[faces])
    first, second = owners[:-1], owners[1:]
    meets = (edges[:-1] == edges[1:]).all(axis=1) & (parts[first] == parts[second])
    first, second = first[meets], second[meets]
    normals = _normals(vertices[faces].astype(np.float64))
    # Corners may run either way around: what matters is how much the planes turn.
    cosine = np.abs(np.einsum("tk,tk->t", normals[first], normals[second]))
    joined = cosine > np.cos(np.radians(SMOOTH))
    links = coo_array(
        (np.ones(joined.sum(), np.bool_), (first[joined], second[joined])), (len(faces),) * 2
    )
    return connected_components(links, directed=False)[1].astype(np.int32)


def _edges(faces):
    """Both ends of every edge, sorted, and its triangle; edges of one place follow each other."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    edges = np.sort(edges, axis=1)
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    return edges[order], np.tile(np.arange(len(faces)), 3)[order]


def _normals(corners):
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    return normals / np.where(lengths > 0, lengths, 1)
