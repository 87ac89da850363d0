"""Hand: standing on its wrist, fingers spread and a little bent."""

import numpy as np

from data_gen.models.mesh import standing, turned
from data_gen.models.sculpture import Sculpture, ball, box, chain, ellipsoid, limb

# Root of each finger on the palm, direction to the side, lengths of the three bones, radius.
_FINGERS = (
    ((-0.42, 1.62, 0.0), -0.24, (0.52, 0.34, 0.25), 0.14),
    ((-0.13, 1.72, 0.0), -0.06, (0.58, 0.40, 0.27), 0.145),
    ((0.16, 1.68, 0.0), 0.10, (0.54, 0.37, 0.26), 0.14),
    ((0.42, 1.52, 0.0), 0.28, (0.42, 0.27, 0.22), 0.125),
)


def hand():
    """Palm towards z, thumb at x < 0."""
    clay = Sculpture((-1.7, -0.1, -0.8), (1.5, 3.3, 1.2))
    clay.join(limb((0.02, 0.0, 0), (0.0, 0.55, 0), 0.36, 0.31))
    clay.join(ellipsoid((0.0, 1.12, -0.02), (0.56, 0.66, 0.24)), softness=0.25)
    for root, *_ in _FINGERS:
        clay.join(limb((root[0] * 0.7, 0.9, 0), root, 0.2, 0.17), softness=0.1)
    clay.join(ellipsoid((-0.34, 0.9, 0.16), (0.26, 0.42, 0.2)), softness=0.12)
    clay.join(ellipsoid((0.36, 0.9, 0.12), (0.2, 0.44, 0.18)), softness=0.12)
    for bend, (root, sideways, bones, radius) in zip(
        (0.30, 0.16, 0.24, 0.42), _FINGERS, strict=True
    ):
        _finger(clay, np.array(root), sideways, bones, radius, bend)
    _thumb(clay)
    clay.cut(box((0, -0.5, 0), (1, 0.5, 1)))  # the wrist stands flat
    # creases of the palm
    for line in (((-0.36, 1.38, 0.27), (0.46, 1.26, 0.27)), ((-0.4, 1.2, 0.3), (0.3, 0.98, 0.3))):
        clay.cut(limb(*line, 0.03), softness=0.05)
    return standing(turned(clay.mesh(), -18), height=2.9)


def _finger(clay, root, sideways, bones, radius, bend):
    angle, joints, radii = 0.05, [root], [radius * 1.1]
    for number, length in enumerate(bones):
        direction = np.array([sideways * np.cos(angle), np.cos(angle), np.sin(angle)])
        joints.append(joints[-1] + length * direction / np.linalg.norm(direction))
        radii.append(radii[-1] * 0.89)
        angle += bend * (1 + number)
    clay.join(chain(joints, radii), softness=0.08)
    for joint, thickness in zip(joints[1:-1], radii[1:-1], strict=True):
        clay.join(ball(joint, thickness * 1.05), softness=0.06)


def _thumb(clay):
    joints = np.array(
        [(-0.42, 0.72, 0.12), (-0.78, 1.08, 0.30), (-1.0, 1.46, 0.38), (-1.06, 1.78, 0.36)]
    )
    clay.join(chain(joints, (0.24, 0.19, 0.16, 0.135)), softness=0.1)
    clay.join(ball(joints[2], 0.17), softness=0.06)
