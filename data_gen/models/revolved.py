"""Round parts of buildings: profiles turned about an upright axis, united with flat parts."""

import numpy as np

from data_gen.models.mesh import Mesh

_STEPS = 96
"""Of a whole turn."""
_RIBS = 12
"""Edges that run up a whole turn, as a modeller's polygons would show them."""


def revolved(profile, middle, begin=0.0, end=360.0, smooth=False):
    """Turn a profile about an upright axis.

    Parameters
    ----------
    profile : sequence of (float, float)
        Radius and height, from below to above; outside lies to its right.
    middle : (float, float)
        x and z of the axis.
    begin, end : float
        Degrees about the axis, from z towards x.
    smooth : bool
        The profile is a curve: shaded smoothly along it, with an edge at its ends alone.

    Returns
    -------
    Mesh
        Its edges are the rings at the corners of the profile, and ribs.
    """
    profile = np.array(profile, float)
    steps = max(1, round(_STEPS * (end - begin) / 360))
    angles = np.radians(np.linspace(begin, end, steps + 1))
    along = np.diff(profile, axis=0)
    outwards = np.stack([along[:, 1], -along[:, 0]], axis=1)
    outwards /= np.linalg.norm(outwards, axis=1, keepdims=True)
    both = np.stack([outwards, outwards], axis=1)  # of the two ends of each piece
    if smooth:
        between = outwards[:-1] + outwards[1:]
        between /= np.linalg.norm(between, axis=1, keepdims=True)
        both[1:, 0], both[:-1, 1] = between, between
    pieces = np.stack([profile[:-1], profile[1:]], axis=1)
    vertices, normals = _turned(pieces, angles), _turned(both, angles)
    vertices += (middle[0], 0, middle[1])
    corner = np.arange(vertices[..., 0].size).reshape(vertices.shape[:-1])
    a, b = corner[:, 0, :-1], corner[:, 0, 1:]
    c, d = corner[:, 1, 1:], corner[:, 1, :-1]
    faces = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    rings = [vertices[0, 0], vertices[-1, 1]] if smooth else [*vertices[:, 0], vertices[-1, 1]]
    ribs = vertices[:, :, :: _STEPS // _RIBS].swapaxes(1, 2).reshape(-1, 2, 3)
    edges = [np.stack([ring[:-1], ring[1:]], axis=1) for ring in rings]
    return Mesh(
        vertices.reshape(-1, 3).astype(np.float32),
        faces.astype(np.uint32),
        normals.reshape(-1, 3).astype(np.float32),
        np.concatenate([*edges, ribs]).astype(np.float32),
    )


def united(flat, round_parts):
    """A mesh of polygons and meshes of round parts as one, each shaded as it was.

    Parameters
    ----------
    flat : Mesh
        Of :func:`data_gen.models.mesh.polygons`.
    round_parts : sequence of Mesh

    Returns
    -------
    Mesh
    """
    a, b, c = np.moveaxis(flat.vertices[flat.faces], 1, 0)
    normals = np.zeros_like(flat.vertices)
    normals[flat.faces] = np.cross(b - a, c - a)[:, None]
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    meshes = [flat._replace(normals=normals), *round_parts]
    first = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes[:-1])])
    return Mesh(
        np.concatenate([mesh.vertices for mesh in meshes]),
        np.concatenate([mesh.faces + np.uint32(f) for mesh, f in zip(meshes, first, strict=True)]),
        np.concatenate([mesh.normals for mesh in meshes]),
        np.concatenate([mesh.edges for mesh in meshes]),
    )


def _turned(profile, angles):
    """Points (..., 2), radius and height, at every angle: (..., A, 3)."""
    radius, height = profile[..., :1], np.repeat(profile[..., 1:], len(angles), axis=-1)
    return np.stack([radius * np.sin(angles), height, radius * np.cos(angles)], axis=-1)
