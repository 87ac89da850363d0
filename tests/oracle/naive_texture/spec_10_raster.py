"""10. Raster."""

from .spec_01_names import window
from .spec_07_costs import Patch
from .spec_09_alignment import point


def raster(patch, path, shifts):
    """List the addresses of all places; ``shifts`` is None without deformation."""
    a, rows = patch.a, len(path)
    valid, border = a["valid"].ravel(), a["border"]

    def row_of(angle):
        row = (angle + 128) >> 8
        return row - rows if row >= rows else row

    written = []
    for place, dy, dx in window(patch.p["radius"]):
        radius, angle = int(a["radius_at"][place]), int(a["angle_at"][place])
        row = row_of(angle)
        b = int(border[path[row] + 1])
        if radius >= b or patch.locked(dy, dx):
            written.append(-1)
            continue
        address = patch.new(dy, dx)
        if shifts is not None and shifts[row] != 0:
            ratio = min((radius * 4096) // b, 4096)
            turned = angle + ((int(shifts[row]) * int(a["powers"][ratio])) >> 4)
            turned %= 256 * rows
            stretched = (radius * int(border[path[row_of(turned)] + 1])) // b
            address = point(patch, stretched, turned)
        written.append(address if valid[address % valid.size] else -1)
    return written


class Unseen(Patch):
    """A patch over a texture of which nothing but the lock is known."""

    def __init__(self, p, a):
        a["seams_x"] = None
        a["addresses"] = a.get("lock", a["valid"])
        super().__init__(p, a, p["source"], p["y"], p["x"])


def stage_raster(p, a):
    """Do stage raster."""
    return {"patch": raster(Unseen(p, a), a["path"].tolist(), a.get("shifts"))}


STAGES = {"raster": stage_raster}
