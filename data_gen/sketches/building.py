"""What a draughtsman sees of a building: its colours, parts, shadows, walls and edges."""

from typing import NamedTuple

import numpy as np
from skimage.filters import gaussian

from data_gen.guides import guide
from data_gen.styles.painting import at


class Building(NamedTuple):
    """A view of a building.

    Attributes
    ----------
    colour : (H, W, 3) float
        The render, sRGB in [0, 1].
    part : (H, W) int
        A number for each part, -1 for the sky.
    ground : (H, W) bool
        What lies around the building.
    shade : (H, W) float
        1 in shadow, 0 in the light.
    normal, position : (H, W, 3) float
        In the axes and the units of the scene.
    lines : (N, 2, 2) float
        Both ends, (x, y), of every edge as far as it is seen.
    """

    colour: np.ndarray
    part: np.ndarray
    ground: np.ndarray
    shade: np.ndarray
    normal: np.ndarray
    position: np.ndarray
    lines: np.ndarray

    @property
    def unit(self):
        """Pixels of a thin stroke: it shrinks with the picture, but not without end."""
        return max(self.part.shape[0] / 912, 0.45)

    @property
    def body(self):
        """(H, W) bool: the building itself."""
        return (self.part >= 0) & ~self.ground

    @property
    def is_outline(self):
        """(N,) bool: the lines on whose two sides lie the building and what is around it."""
        along = self.lines[:, 1] - self.lines[:, 0]
        across = along[:, ::-1] * (-1, 1) / (np.linalg.norm(along, axis=1, keepdims=True) + 1e-9)
        middle, beside = self.lines.mean(axis=1), max(2.0, 4 * self.unit)
        return at(self.body, middle + beside * across) != at(self.body, middle - beside * across)


def building(layers, lines):
    """Read render passes of a building.

    Parameters
    ----------
    layers : dict of str to (H, W, n) float
        FULL, IDMASK, LIGHTMASK, NORMAL and POSITION.
    lines : (N, 2, 2) float
        As of :class:`Building`.

    Returns
    -------
    Building
    """
    code = (layers["IDMASK"] > 0.5) @ (1, 2, 4)
    position = layers["POSITION"]
    part = code - 1
    flat = (layers["NORMAL"][..., 1] > 0.99) & (np.abs(position[..., 1]) < 1e-2)
    return Building(
        colour=guide("FULL", layers["FULL"]) / 255,
        part=part,
        ground=flat & (part >= 0),
        shade=np.clip(gaussian(layers["LIGHTMASK"][..., 2].astype(float), 0.7), 0, 1),
        normal=layers["NORMAL"],
        position=position,
        lines=lines,
    )
