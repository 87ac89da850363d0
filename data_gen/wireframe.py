"""Wireframe with hidden lines removed (Hauptfleisch 2020, 2.4.1)."""

import numpy as np

from data_gen.lines import draw_lines
from data_gen.visibility import NUDGE, sees


def wireframe(rendered, scene, camera, height, width):
    """Edges of the polygons and slices of the smooth surfaces that a camera sees.

    Lines are 1/456 of the height wide, at least one pixel.

    Parameters
    ----------
    rendered : mitsuba.Scene
    scene : Scene
    camera : Camera
    height, width : int

    Returns
    -------
    (H, W, 1) float
        1 on a line.
    """
    wires = np.concatenate([mesh.wires for mesh in scene.parts.values()]).astype(float)
    ends = camera.project(wires, height, width)
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    wires, length = wires[np.isfinite(length)], length[np.isfinite(length)]
    # Pieces of about two pixels are seen or hidden as their middle is.
    pieces = np.maximum(np.ceil(length / 2).astype(int), 1)
    number = np.repeat(np.arange(len(wires)), pieces)
    piece = np.arange(len(number)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    shares = (piece[:, None] + (0.0, 0.5, 1.0)) / pieces[number][:, None]
    points = wires[number, :1] + shares[..., None] * (wires[number, 1:] - wires[number, :1])
    middle = points[:, 1]
    towards_eye = np.asarray(camera.origin) - middle
    towards_eye /= np.linalg.norm(towards_eye, axis=1, keepdims=True)
    # An edge lies on two surfaces: it has to be lifted from both.
    lifted = middle + 3 * NUDGE * towards_eye
    visible = sees(rendered, lifted, towards_eye, np.asarray(camera.origin))
    lines = camera.project(points[visible][:, ::2], height, width)[..., ::-1]
    count = len(lines)
    layer = lines, np.ones((count, 3)), np.full(count, max(1, height / 456)), 1.0
    return draw_lines(np.zeros((height, width, 3)), [layer])[..., :1]
