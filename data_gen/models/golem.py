"""Golem: a heavy walking figure with long arms."""

from data_gen.models.mesh import standing, turned
from data_gen.models.sculpture import Sculpture, ball, ellipsoid, limb


def golem():
    clay = Sculpture((-1.7, -0.1, -1.0), (1.7, 3.5, 1.1))
    # trunk: hips, waist, chest, shoulders
    clay.join(ellipsoid((0, 1.45, 0), (0.42, 0.30, 0.32)))
    clay.join(ellipsoid((0, 1.85, 0.02), (0.42, 0.42, 0.31)), softness=0.2)
    clay.join(ellipsoid((0, 2.35, 0.02), (0.62, 0.42, 0.38)), softness=0.25)
    for side in (-1, 1):
        clay.join(ellipsoid((side * 0.26, 2.38, 0.26), (0.29, 0.20, 0.16)), softness=0.08)
        clay.join(limb((side * 0.2, 2.72, -0.02), (side * 0.62, 2.58, 0), 0.2, 0.2), softness=0.2)
        for row in range(3):
            belly = ellipsoid((side * 0.13, 2.02 - 0.17 * row, 0.28), (0.12, 0.08, 0.08))
            clay.join(belly, softness=0.05)
    # head bent forward: skull, brow, nose, jaw, eye sockets, mouth
    clay.join(limb((0, 2.65, 0.05), (0, 2.92, 0.16), 0.2), softness=0.15)
    clay.join(ellipsoid((0, 3.08, 0.2), (0.24, 0.30, 0.27)), softness=0.1)
    clay.join(limb((-0.14, 3.12, 0.43), (0.14, 3.12, 0.43), 0.055), softness=0.08)
    clay.join(ellipsoid((0, 2.9, 0.33), (0.16, 0.12, 0.15)), softness=0.08)
    clay.join(limb((0, 3.1, 0.45), (0, 2.98, 0.51), 0.035, 0.06), softness=0.05)
    for side in (-1, 1):
        clay.cut(ball((side * 0.1, 3.04, 0.49), 0.06), softness=0.05)
        clay.join(limb((side * 0.22, 3.1, 0.18), (side * 0.26, 3.02, 0.16), 0.06), softness=0.04)
    clay.cut(limb((-0.08, 2.86, 0.48), (0.08, 2.86, 0.48), 0.02), softness=0.03)
    _arm(clay, (-0.74, 2.55, 0), (-1.16, 1.95, -0.05), (-1.16, 1.3, 0.3), -1)
    _arm(clay, (0.74, 2.55, 0), (1.14, 1.95, 0.05), (1.3, 1.38, 0.45), 1)
    _leg(clay, (-0.26, 1.4, 0), (-0.42, 0.82, 0.22), (-0.44, 0.16, -0.02))
    _leg(clay, (0.28, 1.4, 0), (0.46, 0.84, 0.30), (0.62, 0.16, 0.22))
    return standing(turned(clay.mesh(), -14), height=2.95)


def _arm(clay, shoulder, elbow, wrist, side):
    clay.join(ball(shoulder, 0.30), softness=0.18)
    clay.join(limb(shoulder, elbow, 0.25, 0.19), softness=0.12)
    clay.join(ellipsoid(_between(shoulder, elbow, 0.5), (0.22, 0.28, 0.26)), softness=0.1)
    clay.join(limb(elbow, wrist, 0.2, 0.15), softness=0.1)
    clay.join(ellipsoid(_between(elbow, wrist, 0.35), (0.23, 0.27, 0.23)), softness=0.1)
    x, y, z = _between(elbow, wrist, 1.22)
    clay.join(ellipsoid((x, y, z), (0.15, 0.18, 0.19)), softness=0.08)
    for finger in range(4):
        knuckle = (x + side * 0.02, y - 0.02 - 0.075 * finger + 0.11, z + 0.15)
        tip = (x - side * 0.13, knuckle[1] - 0.02, z + 0.13)
        clay.join(limb(knuckle, tip, 0.062, 0.05), softness=0.02)
    clay.join(
        limb((x - side * 0.1, y + 0.1, z + 0.05), (x - side * 0.12, y + 0.02, z + 0.21), 0.055),
        softness=0.03,
    )


def _leg(clay, hip, knee, ankle):
    clay.join(limb(hip, knee, 0.34, 0.24), softness=0.16)
    clay.join(ellipsoid(_between(hip, knee, 0.45), (0.33, 0.36, 0.33)), softness=0.1)
    clay.join(ball(knee, 0.235), softness=0.08)
    clay.join(limb(knee, ankle, 0.24, 0.16), softness=0.1)
    x, _, z = _between(knee, ankle, 0.3)
    clay.join(ellipsoid((x, 0.55, z - 0.05), (0.24, 0.32, 0.25)), softness=0.1)
    x, _, z = ankle
    clay.join(limb((x, 0.12, z - 0.08), (x, 0.1, z + 0.26), 0.13, 0.12), softness=0.08)
    for toe in range(5):
        across = x + 0.075 * (toe - 2)
        clay.join(
            limb((across, 0.075, z + 0.28), (across * 1.02, 0.06, z + 0.42), 0.06, 0.05),
            softness=0.015,
        )


def _between(start, end, share):
    return tuple(s + share * (e - s) for s, e in zip(start, end, strict=True))
