"""Triangle meshes in the units of the stage: y up, x right, z towards the camera."""

from typing import NamedTuple

import numpy as np


class Mesh(NamedTuple):
    """A surface.

    Attributes
    ----------
    vertices : (V, 3) float32
    faces : (F, 3) uint32
        Corners of each triangle.
    normals : (V, 3) float32 or None
        Of a smooth surface; None where faces are flat.
    edges : (E, 2, 3) float32 or None
        Ends of the edges of its polygons; None on a smooth surface.
    """

    vertices: np.ndarray
    faces: np.ndarray
    normals: np.ndarray | None
    edges: np.ndarray | None = None

    @property
    def wires(self):
        """(E, 2, 3) float32: the polygons' edges, or slices of a smooth surface."""
        return slices(self) if self.edges is None else self.edges


def slices(mesh, spacing=0.125):
    """Segments in which a surface meets planes of constant x and of constant y.

    They give a smooth surface a wireframe that tells its form, the same for any model.

    Parameters
    ----------
    mesh : Mesh
    spacing : float
        Distance of the planes.

    Returns
    -------
    (E, 2, 3) float32
    """
    corners = mesh.vertices[mesh.faces]
    segments = []
    for axis in (0, 1):
        heights = corners[..., axis] / spacing
        for height in range(int(np.ceil(heights.min())), int(np.floor(heights.max())) + 1):
            above = heights > height
            cut = np.nonzero(above.any(axis=1) & ~above.all(axis=1))[0]
            # One corner lies alone on its side; the plane cuts the two edges that leave it.
            alone = np.argmax(above[cut] == (above[cut].sum(axis=1) == 1)[:, None], axis=1)
            start = corners[cut, alone]
            ends = []
            for other in (1, 2):
                end = corners[cut, (alone + other) % 3]
                rise = end[:, axis] - start[:, axis]
                share = (height * spacing - start[:, axis]) / rise
                ends.append(start + share[:, None] * (end - start))
            segments.append(np.stack(ends, axis=1))
    return np.concatenate(segments).astype(np.float32)


def polygons(faces):
    """A mesh of flat, convex polygons with all their edges.

    Parameters
    ----------
    faces : list of (N, 3) array_like
        Corners, counter-clockwise from outside.
    """
    vertices, triangles, edges = [], [], []
    for corners in faces:
        corners = np.asarray(corners, np.float32)
        first = sum(map(len, vertices))
        vertices.append(corners)
        triangles += [(first, first + k, first + k + 1) for k in range(1, len(corners) - 1)]
        edges.append(np.stack([corners, np.roll(corners, -1, axis=0)], axis=1))
    return Mesh(
        np.concatenate(vertices), np.array(triangles, np.uint32), None, np.concatenate(edges)
    )


def backdrop(corners):
    """A polygon that belongs to no model: its edges are not drawn."""
    return polygons([corners])._replace(edges=np.zeros((0, 2, 3), np.float32))


def turned(mesh, degrees):
    """A smooth mesh turned about the y axis, its front towards the right."""
    turn = rotation(degrees).T
    return mesh._replace(vertices=mesh.vertices @ turn, normals=mesh.normals @ turn)


def rotation(degrees):
    """The matrix (3, 3) float32 that turns points about the y axis, the front to the right."""
    angle = np.radians(degrees)
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.array([[cosine, 0, sine], [0, 1, 0], [-sine, 0, cosine]], np.float32)


def standing(mesh, height=None, width=None):
    """A smooth mesh scaled to a height or a width, on the floor and around the y axis."""
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    scale = height / (high[1] - low[1]) if height else width / (high[0] - low[0])
    foot = np.array([(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2], np.float32)
    return mesh._replace(vertices=np.float32(scale) * (mesh.vertices - foot))


def to_obj(parts):
    """The text of an ``.obj`` file, whose numbers are exact.

    Parameters
    ----------
    parts : dict of str to Mesh

    Returns
    -------
    str
    """
    lines, first = [], 1
    for name, mesh in parts.items():
        lines.append(f"o {name}")
        lines += ["v " + " ".join(map(repr, vertex)) for vertex in mesh.vertices.tolist()]
        lines += ["f " + " ".join(map(str, face)) for face in (mesh.faces + first).tolist()]
        first += len(mesh.vertices)
    return "\n".join(lines) + "\n"
