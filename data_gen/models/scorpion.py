"""Scorpion: a ringed body, eight thin legs, two claws, a tail curled over the back."""

from itertools import pairwise

import numpy as np

from data_gen.models.mesh import standing, turned
from data_gen.models.sculpture import Sculpture, ball, chain, ellipsoid, limb


def scorpion():
    """Faces z, its head at z > 0."""
    clay = Sculpture((-2.0, -0.1, -2.1), (2.0, 2.6, 2.7))
    clay.join(ellipsoid((0, 0.55, 0.62), (0.40, 0.22, 0.46)))
    for ring in range(7):
        z = 0.22 - 0.2 * ring
        width = 0.47 - 0.018 * (ring - 2) ** 2
        clay.join(ellipsoid((0, 0.56, z), (width, 0.25, 0.15)), softness=0.02)
    for side in (-1, 1):
        clay.join(ball((side * 0.08, 0.76, 0.72), 0.05), softness=0.03)
        clay.join(limb((side * 0.1, 0.5, 0.98), (side * 0.07, 0.42, 1.16), 0.07), softness=0.03)
        for leg in range(4):
            _leg(clay, side, leg)
        _claw(clay, side)
    _tail(clay)
    return standing(turned(clay.mesh(), 34), width=4.3)


def _leg(clay, side, leg):
    spread = np.array([0.55, 0.15, -0.3, -0.85])[leg]
    root = np.array([side * 0.33, 0.48, 0.72 - 0.24 * leg])
    knee = root + np.array([side * 0.52, 0.38, spread * 0.45])
    shin = knee + np.array([side * 0.42, -0.42, spread * 0.40])
    foot = np.array([shin[0] + side * 0.12, 0.03, shin[2] + spread * 0.15])
    clay.join(limb(root, knee, 0.085, 0.065), softness=0.04)
    clay.join(limb(knee, shin, 0.065, 0.045), softness=0.015)
    clay.join(limb(shin, foot, 0.045, 0.02), softness=0.015)


def _claw(clay, side):
    shoulder = np.array([side * 0.3, 0.52, 0.92])
    elbow = np.array([side * 0.98, 0.62, 1.05])
    wrist = np.array([side * 1.12, 0.55, 1.42])
    clay.join(limb(shoulder, elbow, 0.09, 0.13), softness=0.04)
    clay.join(limb(elbow, wrist, 0.13, 0.12), softness=0.03)
    palm = wrist + np.array([-side * 0.04, 0, 0.26])
    clay.join(ellipsoid(palm, (0.21, 0.19, 0.28)), softness=0.04)
    # two curved fingers with a gap between them
    for across, bulge, tip in ((0.11, 0.24, 0.05), (-0.13, -0.20, -0.05)):
        finger = [
            palm + np.array([side * x, 0, z])
            for x, z in ((across, 0.1), (bulge, 0.36), (tip, 0.72))
        ]
        clay.join(chain(finger, (0.12, 0.085, 0.02)), softness=0.03)


def _tail(clay):
    angles = np.linspace(-0.35, 1.18 * np.pi, 7)
    middle, reach = np.array([1.38, -1.02]), np.array([0.82, 0.74])
    joints = [
        np.array([0, middle[0] - reach[0] * np.cos(a), middle[1] - reach[1] * np.sin(a)])
        for a in angles
    ]
    clay.join(limb((0, 0.56, -1.05), joints[0], 0.24, 0.2), softness=0.04)
    for k, (start, end) in enumerate(pairwise(joints)):
        thickness = 0.19 - 0.012 * k
        clay.join(ellipsoid(start, (thickness * 1.1,) * 3), softness=0.01)
        clay.join(limb(start, end, thickness * 0.8, thickness * 0.75), softness=0.02)
    sting = joints[-1]
    clay.join(ellipsoid(sting, (0.19, 0.2, 0.23)), softness=0.03)
    hook = sting + np.array([0, -0.14, 0.30])
    clay.join(limb(sting + np.array([0, -0.02, 0.12]), hook, 0.10, 0.05), softness=0.03)
    clay.join(limb(hook, hook + np.array([0, -0.22, 0.08]), 0.05, 0.012), softness=0.02)
