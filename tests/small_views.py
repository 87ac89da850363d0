"""A small grid of views of two boxes on a ground, with fields that nobody has stylized."""

import numpy as np

from stylit_ref.viewer.grid_views import GridViews
from stylit_ref.views.interpolation.camera import Camera
from stylit_ref.views.interpolation.orbit import orbit_of
from stylit_ref.views.mesh import make_mesh

SIZE = 46, 60
STYLE_SIZE = 50, 40


def cameras(rows, columns, apart=5.0):
    """Cameras that look at the origin, with the eye a little higher in each row."""
    made = []
    for row in range(rows):
        for column in range(columns):
            azimuth = np.radians(20 + apart * column)
            elevation = np.radians(8 + apart * row)
            away = np.array([
                np.sin(azimuth) * np.cos(elevation),
                np.sin(elevation),
                np.cos(azimuth) * np.cos(elevation),
            ])  # fmt: skip
            made.append(Camera(tuple((9 * away).tolist()), (0.0, 0.0, 0.0), 28.0))
    return made


def mesh():
    """A high box beside a flat one, and a ground that reaches behind every camera."""
    ground = np.float32([[-30, -1, -30], [30, -1, -30], [30, -1, 30], [-30, -1, 30]])
    parts = [(ground, [[0, 1, 2], [0, 2, 3]])]
    for low, high in (((-1, -1, -1), (0.2, 1, 0.3)), ((0.4, -1, -0.6), (1.5, -0.2, 0.8))):
        corners = np.array(np.meshgrid(*zip(low, high, strict=True), indexing="ij"), np.float32)
        corners = corners.reshape(3, -1).T
        sides = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)]
        parts.append((corners, [t for a, b, c, d in sides for t in ([a, b, c], [a, c, d])]))
    vertices, faces, owners, before = [], [], [], 0
    for number, (corners, triangles) in enumerate(parts):
        vertices.append(corners)
        faces += [[before + corner for corner in triangle] for triangle in triangles]
        owners += [number] * len(triangles)
        before += len(corners)
    return make_mesh(np.concatenate(vertices), np.array(faces), np.array(owners))


def style(random, size=STYLE_SIZE):
    """Noise, in which no two patches are alike."""
    return random.integers(0, 256, (*size, 3), dtype=np.uint8)


def field(random, size=SIZE, style_size=STYLE_SIZE, radius=2):
    """Patches that go on for a few pixels, as those of a search do."""
    height, width = size
    blocks = random.integers(0, style_size, (-(-height // 6), -(-width // 6), 2))
    nnf = blocks.repeat(6, 0).repeat(6, 1)[:height, :width] + np.mgrid[:height, :width].T.swapaxes(
        0, 1
    )
    return (nnf % (np.array(style_size) - 2 * radius) + radius).astype(np.int32)


def small_views(rows=2, columns=2, size=SIZE, style_size=STYLE_SIZE, seen_by=None):
    """Views as a page is made of them; ``seen_by`` are other cameras, row by row."""
    random = np.random.default_rng(0)
    orbit = orbit_of(seen_by or cameras(rows, columns), rows, columns)
    painting = style(random, style_size)
    fields = [field(random, size, style_size) for _ in range(rows * columns)]
    return GridViews(orbit.grid, size, painting, 5, fields.__getitem__, orbit, mesh())
