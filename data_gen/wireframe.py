"""Wireframe with hidden lines removed (Hauptfleisch 2020, 2.4.1)."""

from typing import NamedTuple

import numpy as np

from data_gen.lines import draw_lines
from data_gen.visibility import NUDGE, sees


class VisibleWires(NamedTuple):
    """What a camera sees of the wires, in pieces of about two pixels.

    Attributes
    ----------
    lines : (N, 2, 2) float
        Both ends of each piece, (x, y), whole at pixel centres.
    wire : (N,) int
        The wire that each piece belongs to.
    piece : (N,) int
        Its number along that wire.
    """

    lines: np.ndarray
    wire: np.ndarray
    piece: np.ndarray

    def runs(self):
        """Straight lines from where a wire comes into sight to where it is hidden, each once.

        Returns
        -------
        (M, 2, 2) float
        """
        if not len(self.wire):
            return np.zeros((0, 2, 2))
        begins = (np.diff(self.wire) != 0) | (np.diff(self.piece) != 1)
        first = np.concatenate([[True], begins])
        last = np.concatenate([begins, [True]])
        runs = np.stack([self.lines[first, 0], self.lines[last, 1]], axis=1)
        # Two polygons share an edge, and each of them has it in its own direction.
        rounded = np.round(runs)
        turned = rounded @ (1e5, 1.0)
        rounded = np.where((turned[:, 0] > turned[:, 1])[:, None, None], rounded[:, ::-1], rounded)
        _, once = np.unique(rounded.reshape(-1, 4), axis=0, return_index=True)
        return runs[np.sort(once)]


def visible_wires(rendered, scene, camera, height, width):
    """Edges of the polygons and slices of the smooth surfaces that a camera sees.

    Parameters
    ----------
    rendered : mitsuba.Scene
    scene : Scene
    camera : Camera
    height, width : int

    Returns
    -------
    VisibleWires
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
    return VisibleWires(lines, number[visible], piece[visible])


def wireframe(wires, height, width):
    """Wires as a picture: lines 1/456 of the height wide, at least one pixel.

    Parameters
    ----------
    wires : VisibleWires
    height, width : int

    Returns
    -------
    (H, W, 1) float
        1 on a line.
    """
    count = len(wires.lines)
    layer = wires.lines, np.ones((count, 3)), np.full(count, max(1, height / 456)), 1.0
    return draw_lines(np.zeros((height, width, 3)), [layer])[..., :1]
