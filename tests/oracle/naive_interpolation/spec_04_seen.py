"""4. What is seen."""

from math import floor

import numpy as np

from .spec_03_cameras import rays_of


def cut_off(corners, near):
    """Give what of a triangle is deeper than near, as a polygon in pixels."""
    kept = []
    for k in range(3):
        one, other = corners[k], corners[(k + 1) % 3]
        if one[2] > near:
            kept.append(one)
        if (one[2] > near) != (other[2] > near):
            kept.append(one + (near - one[2]) / (other[2] - one[2]) * (other - one))
    return [corner[:2] / corner[2] for corner in kept]


def is_inside(polygon, x, y):
    """Tell whether a point lies in a convex polygon, or on its edge."""
    turns = []
    for one, other in zip(polygon, [*polygon[1:], polygon[0]], strict=True):
        turns.append((other[0] - one[0]) * (y - one[1]) - (other[1] - one[1]) * (x - one[0]))
    return bool(turns) and (min(turns) >= 0 or max(turns) <= 0)


def stage_rasterize(p, a):
    """Do stage rasterize."""
    size = p["height"], p["width"]
    triangles, inverse = np.full(size, -1), np.zeros(size)
    rays, eye = rays_of(a["camera"])
    for number, (first, second, third) in enumerate(a["corners"]):
        normal = np.cross(second - first, third - first)
        distance = normal @ (first - eye)
        if distance == 0:
            continue
        corners = np.array([first, second, third]) @ a["camera"][:, :3].T + a["camera"][:, 3]
        polygon = cut_off(corners, p["near"])
        for y, x in np.ndindex(size):
            v = normal @ rays @ (x, y, 1) / distance
            if v > inverse[y, x] and is_inside(polygon, x, y):
                triangles[y, x], inverse[y, x] = number, v
    return {"triangles": triangles, "inverse": inverse}


def stage_splat(p, a):
    """Do stage splat."""
    size = height, width = a["labels"].shape[1:]
    sparse, far = np.full(size, -1), np.zeros(size)
    for view, y, x in np.ndindex(a["labels"].shape):
        across, down, depth = a["camera"] @ (*a["points"][view, y, x].astype(float), 1)
        if a["labels"][view, y, x] < 0 or not depth > 0:
            continue
        row, column = floor(down / depth + 1 / 2), floor(across / depth + 1 / 2)
        if 0 <= row < height and 0 <= column < width and 1 / depth > far[row, column]:
            sparse[row, column], far[row, column] = a["labels"][view, y, x], 1 / depth
    found, inverse = sparse.copy(), far.copy()
    for y, x in np.ndindex(size):
        if sparse[y, x] >= 0:
            continue
        for one, other in (((y, x - 1), (y, x + 1)), ((y - 1, x), (y + 1, x))):
            if min(one) < 0 or other[0] >= height or other[1] >= width:
                continue
            if sparse[one] >= 0 and sparse[other] >= 0:
                farther = other if far[other] < far[one] else one
                found[y, x], inverse[y, x] = sparse[farther], far[farther]
                break
    return {"found": found, "inverse": inverse}


STAGES = {"rasterize": stage_rasterize, "splat": stage_splat}
