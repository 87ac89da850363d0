"""The sphere that every style is painted over."""

import numpy as np

from data_gen.models.mesh import Mesh, standing


def sphere(steps=128):
    """Radius 1."""
    polar, around = np.meshgrid(
        np.linspace(0, np.pi, steps + 1), np.linspace(0, 2 * np.pi, 2 * steps + 1), indexing="ij"
    )
    normals = np.stack(
        [np.sin(polar) * np.sin(around), np.cos(polar), np.sin(polar) * np.cos(around)], axis=-1
    ).astype(np.float32)
    corner = np.arange(normals[..., 0].size).reshape(polar.shape)
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    faces = np.concatenate([np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)])
    flat = normals.reshape(-1, 3)
    return standing(Mesh(flat, faces.reshape(-1, 3).astype(np.uint32), flat), height=2.0)
