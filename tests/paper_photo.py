"""Photographs of a sheet of paper, as a phone would take them, and where the picture is in them."""

from typing import NamedTuple

import numpy as np
from PIL import Image
from scipy.ndimage import gaussian_filter

from stylit_ref.studio.sheet.layout import layout_of

SIZE = 500, 500
"""Width and height of the picture."""


class Photo(NamedTuple):
    """What was photographed.

    Attributes
    ----------
    pixels : (H, W, 3) uint8
    corners : (4, 2) float
        (x, y) of the picture's corners.
    """

    pixels: np.ndarray
    corners: np.ndarray


def a_painting(seed):
    """Broad strokes of clear colours on white, (500, 500, 3) uint8."""
    rng = np.random.default_rng(seed)
    fields = gaussian_filter(rng.standard_normal((3, 500, 500)), (0, 22, 22))
    shares = np.argsort(np.argsort(fields.reshape(3, -1))).reshape(fields.shape) / 250_000
    painted = np.floor(4 * shares) / 3
    return (255 * (0.15 + 0.85 * np.moveaxis(painted, 0, -1))).astype(np.uint8)


def with_painting(page, painting):
    """A page, as a grey image, with something painted over its picture."""
    page = page.convert("RGB")
    layout = layout_of(*painting.shape[1::-1])
    page.paste(Image.fromarray(painting).resize(layout), tuple(place_of(page, layout)))
    return page


def place_of(page, layout):
    """The upper left corner of the picture on a page."""
    return np.array([page.width - layout.width, page.height - layout.height]) // 2


def photographed(page, *, seed, longest=640, turns=0, light=True, zoom=1.0, aside=(0.0, 0.0)):
    """Photograph a page on a table.

    Parameters
    ----------
    page : PIL image, RGB
    seed : int
        Of the perspective, the light, the blur and the noise.
    longest : int
        Height of the photograph, before it is turned.
    turns : int
        Quarter turns, counterclockwise.
    light : bool
        Whether the light is uneven and coloured.
    zoom : float
        How much of the height the page fills, about.
    aside : (float, float)
        By how much of the photograph the page lies away from the middle.

    Returns
    -------
    Photo
    """
    rng = np.random.default_rng(seed)
    height, width = longest, longest * 3 // 4
    size = 0.42 * zoom * height
    half = np.array([size * page.width / page.height, size])
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
    angle = np.radians(rng.uniform(-14, 14))
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    outline = square * half * (1 + rng.uniform(-0.12, 0.05, (4, 2))) @ turn
    outline += (0.5 + np.array(aside)) * (width, height)
    matrix = _solved(square * (page.width / 2, page.height / 2), outline)
    seen, is_page = _taken(page, matrix, width, height)
    table = np.array((0.30, 0.19, 0.11)) * (
        1 + 0.4 * gaussian_filter(rng.standard_normal((height, width)), (1, 9))[..., None] * 8
    )
    linear = np.where(is_page, _linear(seen), np.clip(table, 0.01, 1))
    if light:
        linear *= _shade(rng, height, width) * rng.uniform((0.75, 0.75, 0.45), (1, 0.95, 0.95))
    blurred = gaussian_filter(linear, (rng.uniform(0.3, 1.0) * longest / 1000,) * 2 + (0,))
    shown = np.clip(blurred, 0, 1) ** (1 / 2.2) * 255 + rng.normal(0, 4, linear.shape)
    layout = layout_of(*SIZE)
    corners = _through(matrix, layout.corners - (layout.width / 2, layout.height / 2))
    for _ in range(turns):
        corners = np.stack([corners[:, 1], width - corners[:, 0]], axis=1)
        width, height = height, width
    return Photo(np.rot90(np.clip(shown, 0, 255).astype(np.uint8), turns).copy(), corners)


def _taken(page, matrix, width, height):
    """Colours of the page from 0 to 255 where it is seen, and where that is."""
    fine = 2  # as if each pixel were four
    back = np.linalg.inv(matrix)
    back = np.array([[1, 0, page.width / 2], [0, 1, page.height / 2], [0, 0, 1]]) @ back
    back = back @ np.diag([1 / fine, 1 / fine, 1])
    coefficients = (back / back[2, 2]).ravel()[:8]
    both = Image.merge("RGBA", (*page.split(), Image.new("L", page.size, 255)))
    seen = both.transform(
        (width * fine, height * fine),
        Image.Transform.PERSPECTIVE,
        coefficients,
        Image.Resampling.BILINEAR,
    ).reduce(fine)
    values = np.asarray(seen, float)
    return values[..., :3], values[..., 3:] > 127


def _shade(rng, height, width):
    """Brightness that falls off to one side and to the corners."""
    y, x = np.mgrid[-1 : 1 : 1j * height, -1 : 1 : 1j * width]
    angle = rng.uniform(0, 2 * np.pi)
    side = 1 - rng.uniform(0, 0.25) * (1 + x * np.cos(angle) + y * np.sin(angle))
    return (side / (1 + rng.uniform(0, 0.25) * (x * x + y * y)))[..., None]


def _linear(values):
    return (values / 255) ** 2.2


def _solved(points, others):
    """The homography through four points, as the system of eight equations that it is."""
    rows = []
    for (x, y), (u, v) in zip(points, others, strict=True):
        rows += [(x, y, 1, 0, 0, 0, -u * x, -u * y), (0, 0, 0, x, y, 1, -v * x, -v * y)]
    return np.append(np.linalg.solve(rows, others.ravel()), 1).reshape(3, 3)


def _through(matrix, points):
    taken = np.append(points, np.ones((len(points), 1)), axis=1) @ matrix.T
    return taken[:, :2] / taken[:, 2:]
