"""Modelling with signed distances: shapes joined softly on a grid, then marching cubes.

A shape is a function of three arrays of coordinates that is negative inside, with a box
around it. It is evaluated inside that box only, so a creature of a hundred shapes costs
little more than its volume.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from skimage.measure import marching_cubes

from data_gen.models.mesh import Mesh


class Shape(NamedTuple):
    """A signed distance, exact or a bound of it near the surface, and the box it lies in."""

    distance: Callable
    low: np.ndarray
    high: np.ndarray


def ball(centre, radius):
    return ellipsoid(centre, (radius, radius, radius))


def ellipsoid(centre, radii, axes=None):
    """An ellipsoid; ``axes`` has its unit axes as rows."""
    centre, radii = np.asarray(centre, float), np.asarray(radii, float)
    axes = np.eye(3) if axes is None else np.asarray(axes, float)

    def distance(*position):
        local = _local(position, centre, axes)
        to_unit = np.sqrt(sum((p / r) ** 2 for p, r in zip(local, radii, strict=True)))
        steepness = np.sqrt(sum((p / r**2) ** 2 for p, r in zip(local, radii, strict=True)))
        return to_unit * (to_unit - 1) / np.maximum(steepness, 1e-6)

    reach = np.sqrt(((axes.T * radii) ** 2).sum(axis=1))
    return Shape(distance, centre - reach, centre + reach)


def limb(start, end, start_radius, end_radius=None):
    """A capsule whose radius goes from one end to the other."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    end_radius = start_radius if end_radius is None else end_radius
    along = end - start

    def distance(*position):
        offset = [p - s for p, s in zip(position, start, strict=True)]
        t = sum(o * a for o, a in zip(offset, along, strict=True)) / (along @ along)
        t = np.clip(t, 0, 1)
        away = np.sqrt(sum((o - t * a) ** 2 for o, a in zip(offset, along, strict=True)))
        return away - (start_radius + t * (end_radius - start_radius))

    ends = np.array(
        [start - start_radius, end - end_radius, start + start_radius, end + end_radius]
    )
    return Shape(distance, ends.min(axis=0), ends.max(axis=0))


def chain(points, radii):
    """Limbs one after another through points, without bulges at the joints."""
    limbs = [
        limb(*ends) for ends in zip(points[:-1], points[1:], radii[:-1], radii[1:], strict=True)
    ]
    return Shape(
        lambda *position: np.minimum.reduce([part.distance(*position) for part in limbs]),
        np.min([part.low for part in limbs], axis=0),
        np.max([part.high for part in limbs], axis=0),
    )


def box(centre, half, axes=None, rounding=0.0):
    """A box with rounded edges; ``half`` its half sides with the rounding."""
    centre, half = np.asarray(centre, float), np.asarray(half, float)
    axes = np.eye(3) if axes is None else np.asarray(axes, float)

    def distance(*position):
        beyond = [
            np.abs(p) - (h - rounding)
            for p, h in zip(_local(position, centre, axes), half, strict=True)
        ]
        outside = np.sqrt(sum(np.maximum(b, 0) ** 2 for b in beyond))
        return outside + np.minimum(np.maximum.reduce(beyond), 0) - rounding

    reach = np.abs(axes.T) @ half
    return Shape(distance, centre - reach, centre + reach)


def plate(outline, centre, axes, thickness, rounding=0.0):
    """A flat plate: a convex outline, (N, 2) counter-clockwise, along the first two axes.

    Its edges are rounded outwards of the outline.
    """
    outline, centre = np.asarray(outline, float), np.asarray(centre, float)
    axes = np.asarray(axes, float)
    edges = np.roll(outline, -1, axis=0) - outline
    outward = np.stack([edges[:, 1], -edges[:, 0]], axis=1)
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)

    def distance(*position):
        u, v, w = _local(position, centre, axes)
        sides = [
            (u - corner[0]) * normal[0] + (v - corner[1]) * normal[1]
            for corner, normal in zip(outline, outward, strict=True)
        ]
        side, face = np.maximum.reduce(sides), np.abs(w) - (thickness / 2 - rounding)
        outside = np.hypot(np.maximum(side, 0), np.maximum(face, 0))
        return outside + np.minimum(np.maximum(side, face), 0) - rounding

    before = np.roll(outward, 1, axis=0)
    mitre = (outward + before) / (1 + (outward * before).sum(axis=1, keepdims=True))
    corners = centre + (outline + rounding * mitre) @ axes[:2]
    reach = np.abs(axes[2]) * thickness / 2
    return Shape(distance, corners.min(axis=0) - reach, corners.max(axis=0) + reach)


def ring(centre, radius, thickness, axis=1):
    """A torus around a coordinate axis."""
    centre = np.asarray(centre, float)

    def distance(*position):
        local = [p - c for p, c in zip(position, centre, strict=True)]
        across = local.pop(axis)
        return np.hypot(np.hypot(*local) - radius, across) - thickness

    reach = np.full(3, radius + thickness)
    reach[axis] = thickness
    return Shape(distance, centre - reach, centre + reach)


def shell(shape, thickness):
    """The outermost ``thickness`` of a shape: hollow inside."""
    return shape._replace(
        distance=lambda *position: np.abs(shape.distance(*position) + thickness / 2) - thickness / 2
    )


def slab(shape, low, high):
    """The part of a shape between two heights."""
    return Shape(
        lambda x, y, z: np.maximum(shape.distance(x, y, z), np.maximum(low - y, y - high)),
        np.array([shape.low[0], max(low, shape.low[1]), shape.low[2]]),
        np.array([shape.high[0], min(high, shape.high[1]), shape.high[2]]),
    )


class Sculpture:
    """A block of space in which shapes are joined and cut.

    Parameters
    ----------
    low, high : 3 floats
        Corners of the block.
    cell : float
        Distance of grid points.
    """

    def __init__(self, low, high, cell=0.0125):
        self.low, self.cell = np.asarray(low, float), cell
        size = np.ceil((np.asarray(high) - self.low) / cell).astype(int) + 1
        self.distances = np.full(size, 0.5, np.float32)

    def join(self, *shapes, softness=0.0):
        """Smooth union with each shape; the seam is rounded over ``softness``."""
        for shape in shapes:
            self._blend(shape, softness, 1)

    def cut(self, *shapes, softness=0.0):
        """Smooth difference."""
        for shape in shapes:
            self._blend(shape, softness, -1)

    def mesh(self):
        """The surface as a :class:`Mesh` with smooth normals."""
        vertices, faces, normals, _ = marching_cubes(
            self.distances, 0.0, spacing=(self.cell,) * 3, gradient_direction="ascent"
        )
        return Mesh(
            (vertices + self.low).astype(np.float32),
            faces[:, ::-1].astype(np.uint32),  # skimage takes dark for outside
            -normals.astype(np.float32),
        )

    def _blend(self, shape, softness, sign):
        margin = softness + 3 * self.cell
        first = np.floor((shape.low - margin - self.low) / self.cell).astype(int)
        last = np.ceil((shape.high + margin - self.low) / self.cell).astype(int) + 1
        first, last = np.maximum(first, 0), np.minimum(last, self.distances.shape)
        if (last <= first).any():
            raise ValueError(f"a shape between {shape.low} and {shape.high} lies outside the block")
        grid = np.ogrid[tuple(slice(f, la) for f, la in zip(first, last, strict=True))]
        position = [
            (index * self.cell + low).astype(np.float32)
            for index, low in zip(grid, self.low, strict=True)
        ]
        part = self.distances[tuple(slice(f, la) for f, la in zip(first, last, strict=True))]
        a, b = sign * part, shape.distance(*position).astype(np.float32)
        joined = np.minimum(a, b)
        if softness:
            overlap = np.maximum(softness - np.abs(a - b), 0) / softness
            joined -= overlap**2 * (softness / 4)
        part[...] = sign * joined


def _local(position, centre, axes):
    offset = [p - c for p, c in zip(position, centre, strict=True)]
    return [sum(o * a for o, a in zip(offset, axis, strict=True)) for axis in axes]


def axes_of(forward, up=(0, 1, 0)):
    """Unit axes (forward, up, side) of a shape that points forward."""
    forward = np.asarray(forward, float) / np.linalg.norm(forward)
    side = np.cross(forward, up)
    side /= np.linalg.norm(side)
    return np.array([forward, np.cross(side, forward), side])
