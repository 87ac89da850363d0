"""Walls that look alike in every guide, one drawn in brick, the other in boards."""

import numpy as np

from data_gen.lines import draw_lines
from data_gen.sketches.strokes import layer, paper, ruled, washed

_BRICK = np.array((0.72, 0.36, 0.24))
_TIMBER = np.array((0.80, 0.66, 0.44))
_COURSE = 0.22
_BOARD = 0.26
"""Heights of bricks and widths of boards, in units of the scene."""
_LEAST = 0.1
"""Share of the wall that a plane has; a strip of a round tower has less."""


def two_walls(building, seed=53):
    """Draw a :class:`Building`; (H, W, 3) float."""
    rng = np.random.default_rng(seed)
    unit, shape = building.unit, building.part.shape
    bricks, boards = _planes_in_turn(building)
    picture = paper(rng, shape)
    body = building.body
    shadow = 1 - 0.35 * building.shade[..., None]
    for where, colour, amount in (
        (body & ~bricks & ~boards, building.colour, 0.6),
        (building.ground & (building.shade > 0.5), building.colour, 0.45),
        (bricks, _BRICK * shadow, 0.75),
        (boards, _TIMBER * shadow, 0.75),
    ):
        picture = washed(
            rng, picture, np.broadcast_to(colour, picture.shape), amount * where, unit, spill=1.5
        )
    across = np.where(
        np.abs(building.normal[..., 2]) > np.abs(building.normal[..., 0]),
        building.position[..., 0],
        building.position[..., 2],
    )
    height = building.position[..., 1]
    course = np.floor(height / _COURSE)
    joints = _steps(course) | _steps(np.floor(across / (2 * _COURSE) + 0.5 * (course % 2)))
    for where, lines in ((bricks, joints), (boards, _steps(np.floor(across / _BOARD)))):
        ink = (where & lines)[..., None] * 0.6
        picture = picture * (1 - ink) + ink * np.array((0.30, 0.20, 0.16))
    return draw_lines(
        picture, [layer(rng, ruled(rng, building.lines, unit, 5, 0.7), 1.5, unit, 0.8)]
    )


def _planes_in_turn(building):
    """Flat walls that face the same way, from back to front: one brick, the next boards."""
    upright = building.body & (np.abs(building.normal[..., 1]) < 0.05)
    walls = upright & (building.part == np.bincount(building.part[upright]).argmax())
    brick = np.zeros_like(walls)
    for axis in (0, 2):
        faces = walls & (np.abs(building.normal[..., axis]) > 0.99)
        depth = np.round(2 * building.position[..., axis]) / 2
        planes, pixels = np.unique(depth[faces], return_counts=True)
        brick |= faces & np.isin(depth, planes[pixels > _LEAST * faces.sum()][::2])
    return brick, walls & ~brick


def _steps(values):
    """Where an image differs from its neighbour to the left or above."""
    right = np.diff(values, axis=1, prepend=values[:, :1]) != 0
    down = np.diff(values, axis=0, prepend=values[:1]) != 0
    return right | down
