"""What buildings are built of: boxes, wings with gabled roofs, windows.

Parts are lists of polygons by name; a polygon is a list of corners, counter-clockwise from outside.
"""


def box(faces, low, high):
    """Add the sides of an upright box between two corners."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    faces += [
        [(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)],
        [(x1, y0, z0), (x0, y0, z0), (x0, y1, z0), (x1, y1, z0)],
        [(x1, y0, z1), (x1, y0, z0), (x1, y1, z0), (x1, y1, z1)],
        [(x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (x0, y1, z0)],
        [(x0, y1, z1), (x1, y1, z1), (x1, y1, z0), (x0, y1, z0)],
        [(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)],
    ]


def swapped(faces):
    """Polygons with x and z exchanged, still counter-clockwise from outside."""
    return [[(z, y, x) for x, y, z in reversed(face)] for face in faces]


def wing(parts, x, z, eaves, ridge, along, overhang=0.35, thickness=0.14):
    """Walls with a gabled roof whose ridge runs along an axis."""
    (length, across) = (x, z) if along == 0 else (z, x)
    (l0, l1), (a0, a1), middle = length, across, sum(across) / 2
    walls = [
        [(l0, 0, a1), (l1, 0, a1), (l1, eaves, a1), (l0, eaves, a1)],
        [(l1, 0, a0), (l0, 0, a0), (l0, eaves, a0), (l1, eaves, a0)],
        [(l1, 0, a1), (l1, 0, a0), (l1, eaves, a0), (l1, ridge, middle), (l1, eaves, a1)],
        [(l0, 0, a0), (l0, 0, a1), (l0, eaves, a1), (l0, ridge, middle), (l0, eaves, a0)],
    ]
    slope = (ridge - eaves) / (a1 - middle)
    low = eaves - slope * overhang
    l0, l1, a0, a1 = l0 - overhang, l1 + overhang, a0 - overhang, a1 + overhang
    t = thickness
    roof = []
    for outer in (a0, a1):
        slab = [(low + t, outer), (ridge + t, middle), (ridge, middle), (low, outer)]
        ends = [[(end, y, a) for y, a in slab] for end in (l0, l1)]
        if outer == a0:
            ends = ends[::-1]
        roof += [ends[0], ends[1][::-1]]
        for k in range(4):
            n = (k + 1) % 4
            roof.append([ends[0][n], ends[0][k], ends[1][k], ends[1][n]])
    parts["walls"] += walls if along == 0 else swapped(walls)
    parts["roof"] += roof if along == 0 else swapped(roof)


def window(parts, middle, sill, plane, width, height, facing):
    """A framed window with one bar each way, on a wall that faces x (0) or z (2)."""
    glass, frames, stone = [], [], []
    left, right, top = middle - width / 2, middle + width / 2, sill + height
    out, bar = plane + 0.02, 0.07
    glass.append([(left, sill, out), (right, sill, out), (right, top, out), (left, top, out)])
    for low, high in (
        ((left - bar, sill - bar), (left, top + bar)),
        ((right, sill - bar), (right + bar, top + bar)),
        ((left, top), (right, top + bar)),
        ((left, sill - bar), (right, sill)),
        ((middle - 0.025, sill), (middle + 0.025, top)),
        ((left, sill + 0.6 * height), (right, sill + 0.6 * height + 0.05)),
    ):
        box(frames, (*low, plane), (*high, plane + 0.08))
    box(stone, (left - 0.15, sill - bar - 0.1, plane), (right + 0.15, sill - bar, plane + 0.18))
    for name, faces in (("glass", glass), ("frames", frames), ("stone", stone)):
        parts[name] += swapped(faces) if facing == 0 else faces
