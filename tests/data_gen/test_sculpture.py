"""Signed distances on a grid against the shapes evaluated everywhere."""

import numpy as np
import pytest

from data_gen.models.sculpture import (
    Sculpture,
    axes_of,
    ball,
    box,
    chain,
    ellipsoid,
    limb,
    plate,
    ring,
    shell,
    slab,
)

TURNED = axes_of((1, 0.4, 0.2))
SHAPES = {
    "ball": ball((0.1, 0, 0), 0.5),
    "ellipsoid": ellipsoid((0, 0.1, 0), (0.6, 0.3, 0.2), TURNED),
    "limb": limb((-0.4, -0.3, 0), (0.5, 0.2, 0.1), 0.2, 0.1),
    "box": box((0, 0, 0.1), (0.5, 0.2, 0.3), TURNED, rounding=0.05),
    "plate": plate([(-0.4, -0.3), (0.4, -0.3), (0, 0.5)], (0, 0, 0), TURNED, 0.2, rounding=0.05),
    "ring": ring((0, 0, 0), 0.5, 0.15, axis=0),
    "chain": chain([(-0.5, 0, 0), (0, 0.3, 0), (0.5, 0, 0.2)], (0.2, 0.15, 0.1)),
    "shell": shell(ball((0, 0, 0), 0.6), 0.2),
    "slab": slab(ball((0, 0, 0), 0.6), -0.1, 0.3),
}


def grid(sculpture):
    index = np.indices(sculpture.distances.shape)
    return [i * sculpture.cell + low for i, low in zip(index, sculpture.low, strict=True)]


@pytest.mark.parametrize("name", SHAPES)
def test_a_shape_lies_in_its_box_and_gets_all_of_it(name):
    clay = Sculpture((-1, -1, -1), (1, 1, 1), cell=0.05)
    clay.join(SHAPES[name])
    everywhere = SHAPES[name].distance(*grid(clay))
    clear = np.abs(everywhere) > 1e-6  # float32 on the surface itself
    assert ((clay.distances < 0) == (everywhere < 0))[clear].all()
    inside = np.stack(grid(clay))[:, everywhere < -1e-6]
    assert (inside.min(axis=1) >= SHAPES[name].low - 1e-9).all()
    assert (inside.max(axis=1) <= SHAPES[name].high + 1e-9).all()


def test_a_ball_is_a_ball():
    clay = Sculpture((-1, -1, -1), (1, 1, 1), cell=0.04)
    clay.join(ball((0.1, 0, -0.1), 0.7))
    mesh = clay.mesh()
    outward = mesh.vertices - (0.1, 0, -0.1)
    assert np.linalg.norm(outward, axis=1) == pytest.approx(0.7, abs=0.003)
    assert (outward * mesh.normals).sum(axis=1) == pytest.approx(0.7, abs=0.01)


def test_joining_and_cutting_without_softness():
    clay = Sculpture((-1, -1, -1), (1, 1, 1), cell=0.05)
    clay.join(ball((-0.2, 0, 0), 0.4), ball((0.2, 0, 0), 0.4))
    clay.cut(ball((0, 0.4, 0), 0.3))
    x, y, z = grid(clay)
    left, right, hole = (
        np.sqrt((x - cx) ** 2 + (y - cy) ** 2 + z**2) - r
        for cx, cy, r in ((-0.2, 0, 0.4), (0.2, 0, 0.4), (0, 0.4, 0.3))
    )
    expected = np.maximum(np.minimum(left, right), -hole)
    clear = np.abs(expected) > 1e-6  # float32 on the surface itself
    assert ((clay.distances < 0) == (expected < 0))[clear].all()


def test_softness_only_adds():
    hard, soft = (Sculpture((-1, -1, -1), (1, 1, 1), cell=0.05) for _ in range(2))
    for clay, softness in ((hard, 0), (soft, 0.3)):
        clay.join(ball((-0.3, 0, 0), 0.4))
        clay.join(ball((0.3, 0, 0), 0.4), softness=softness)
    assert (soft.distances <= hard.distances + 1e-6).all()
    assert (soft.distances < 0).sum() > (hard.distances < 0).sum()


def test_a_shape_outside_the_block_is_refused():
    with pytest.raises(ValueError, match="lies outside the block"):
        Sculpture((-1, -1, -1), (1, 1, 1)).join(ball((5, 0, 0), 0.5))
