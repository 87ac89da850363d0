"""Where what a pixel shows appears to another camera.

A camera is a matrix M, (3, 4): it takes a point of the scene to (x z, y z, z), with x and y in
pixels, whole at their centres, and z the depth. Let R be the inverse of its first three columns and
e the camera's place. The ray of a pixel is then e + z R (x, y, 1), and with N the other camera's
matrix, v = 1 / z and homogeneous coordinates, which a factor does not change,

    N (e + z R (x, y, 1))  ~  T (x, y, 1, v),    T = [N₃ R | N (e, 1)]

So the pixel, its inverse depth and one matrix tell where the point appears; and a plane's inverse
depth is linear in x and y. Both hold at any pixel exactly, unlike values interpolated from corners.
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray


def transfer_of(camera: NDArray[np.float64], other: NDArray[np.float64]) -> NDArray[np.float64]:
    """T, from the pixels of a camera to those of another.

    Parameters
    ----------
    camera, other : (3, 4) float64
        M and N.

    Returns
    -------
    (3, 4) float64
    """
    rays, eye = rays_of(camera)
    turned = other[:, :3] @ rays
    return np.column_stack([turned, other[:, :3] @ eye + other[:, 3]])


def rays_of(camera: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """R, (3, 3) float64, and the camera's place, (3,) float64."""
    rays = np.linalg.inv(camera[:, :3])
    return rays, -rays @ camera[:, 3]


def plane_depths(camera: NDArray[np.float64], corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """The inverse depths of the planes of triangles: v = a x + b y + c.

    With n normal to a plane, p a point of it and the ray e + z R (x, y, 1), n · (ray - p) = 0 gives
    v = nᵀ R (x, y, 1) / (n · (p - e)).

    Parameters
    ----------
    camera : (3, 4) float64
    corners : (T, 3, 3) float64
        The corners of each triangle, in the scene.

    Returns
    -------
    (T, 3) float64
        (a, b, c); 0 for a plane that the camera lies in, which it does not see.
    """
    rays, eye = rays_of(camera)
    first = corners[:, 0]
    normals = np.cross(corners[:, 1] - first, corners[:, 2] - first)
    distances = np.einsum("tk,tk->t", normals, first - eye)
    visible = distances != 0
    planes = normals @ rays
    return np.where(visible[:, None], planes, 0) / np.where(visible, distances, 1)[:, None]


@njit
def transferred(
    transfer: NDArray[np.float64], x: float, y: float, inverse: float
) -> tuple[float, float]:
    """Where a pixel's point appears: (x, y), or infinitely far away if it is behind the camera.

    Parameters
    ----------
    transfer : (3, 4) float64
        T.
    x, y : float
        The pixel.
    inverse : float
        1 / z of its point.
    """
    depth = transfer[2, 0] * x + transfer[2, 1] * y + transfer[2, 2] + transfer[2, 3] * inverse
    if not depth > 0:
        return np.inf, np.inf
    across = transfer[0, 0] * x + transfer[0, 1] * y + transfer[0, 2] + transfer[0, 3] * inverse
    down = transfer[1, 0] * x + transfer[1, 1] * y + transfer[1, 2] + transfer[1, 3] * inverse
    return across / depth, down / depth


@njit
def projected(
    camera: NDArray[np.float64], point: NDArray[np.float32]
) -> tuple[float, float, float]:
    """Where a camera sees a point: (x, y), and 1 / depth; NaN if the point is behind the camera.

    Parameters
    ----------
    camera : (3, 4) float64
        M.
    point : (3,) float32
        In the scene.
    """
    a, b, c = np.float64(point[0]), np.float64(point[1]), np.float64(point[2])
    depth = camera[2, 0] * a + camera[2, 1] * b + camera[2, 2] * c + camera[2, 3]
    if not depth > 0:
        return np.nan, np.nan, np.nan
    across = camera[0, 0] * a + camera[0, 1] * b + camera[0, 2] * c + camera[0, 3]
    down = camera[1, 0] * a + camera[1, 1] * b + camera[1, 2] * c + camera[1, 3]
    return across / depth, down / depth, 1 / depth
