"""5. Silhouettes."""

import numpy as np

from .spec_01_names import NOWHERE, Motion, pixels, place_of, told
from .spec_04_splatting import depth_of_things

NEIGHBOURS = (-1, 0), (0, -1), (1, 0), (0, 1)


def inverse_depths(depth, labels):
    """Give the inverse depths; those of labels where depth is not known."""
    if depth is None:
        return (labels != 0).astype(float)
    return 1 / depth_of_things(depth)


def is_nearer(value, other):
    """Tell whether an inverse depth is nearer than another."""
    return value > 1.05 * other


def is_inside(pixel, size):
    """Tell whether a pixel lies in the frame."""
    return 0 <= pixel[0] < size[0] and 0 <= pixel[1] < size[1]


def is_step(inverse, pixel, down, right):
    """Tell whether depth steps back towards a neighbour."""
    (y, x), size = pixel, inverse.shape
    neighbour, beyond = (y + down, x + right), (y + 2 * down, x + 2 * right)
    opposite = y - down, x - right
    if not is_inside(neighbour, size):
        return False
    near, far = inverse[pixel], inverse[neighbour]
    before = inverse[opposite] if is_inside(opposite, size) else 2 * near - far
    behind = inverse[beyond] if is_inside(beyond, size) else 2 * far - near
    slope = min(abs(before - near), abs(behind - far))
    return is_nearer(near, far) and near - far > 2 * slope


def rims_of(inverse):
    """Find the rims."""
    rims = np.zeros(inverse.shape, bool)
    for pixel in pixels(inverse.shape):
        rims[pixel] = any(is_step(inverse, pixel, *way) for way in NEIGHBOURS)
    return rims


def reach_of(size):
    """Tell how far strokes reach."""
    return max(1, (8 * max(size) + 300) // 600)


def past(inverse, pixel, rim):
    """Look past the rim, away from the pixel, unless the thing has ended there."""
    away = [
        here + (here > before) - (here < before) for here, before in zip(rim, pixel, strict=True)
    ]
    beyond = tuple(away)
    if not is_inside(beyond, inverse.shape) or is_nearer(inverse[rim], inverse[beyond]):
        return rim
    return beyond


def taken(inverse, reach):
    """Find what each pixel takes."""
    rims = [tuple(rim) for rim in np.argwhere(rims_of(inverse)).tolist()]
    places = np.empty((*inverse.shape, 2), np.int64)
    for y, x in pixels(inverse.shape):
        found = []
        for rim in rims:
            distance = (rim[0] - y) ** 2 + (rim[1] - x) ** 2
            if distance <= reach**2 and is_nearer(inverse[rim], inverse[y, x]):
                found.append((distance, -inverse[rim], rim))
        places[y, x] = past(inverse, (y, x), min(found)[2]) if found else (y, x)
    return places


def along(motion, here, there):
    """Let pixels beside silhouettes move with what they take."""
    reach = reach_of(here.shape)
    ours, theirs = taken(here, reach), taken(there, reach)
    field, visible = np.zeros_like(motion.field), np.zeros(here.shape, bool)
    for pixel in pixels(here.shape):
        mine = tuple(ours[pixel].tolist())
        field[pixel], visible[pixel] = motion.field[mine], motion.visible[mine]
    moved = Motion(field, visible.copy())
    for pixel in pixels(here.shape):
        place = place_of(moved, pixel)
        if place != NOWHERE:
            mine, other = tuple(ours[pixel].tolist()), tuple(theirs[place].tolist())
            u, v = here[mine], there[other]
            is_beside = mine != pixel or other != place
            visible[pixel] &= not is_beside or max(u, v) <= (1.05 * 1.05) * min(u, v)
    return Motion(field, visible)


def of_case(a, end=""):
    """Give the inverse depths of a case."""
    return inverse_depths(a.get(f"depth{end}"), a.get(f"labels{end}"))


def stage_rims(p, a):
    """Do stage rims."""
    return {"rims": rims_of(of_case(a))}


def stage_beside(p, a):
    """Do stage beside."""
    return {"places": taken(of_case(a), p["reach"])}


def stage_along(p, a):
    """Do stage along."""
    motion = Motion(a["field"], a["visible"])
    return told(along(motion, of_case(a, "_0"), of_case(a, "_1")))


STAGES = {"rims": stage_rims, "beside": stage_beside, "along": stage_along}
