"""Whether a point in space sees points of a surface."""

import drjit as dr
import mitsuba as mi
import numpy as np

NUDGE = 1e-3
"""How far from a surface a ray starts, in units of the stage, not to meet it again."""


def sees(rendered, position, normal, eye):
    """Whether a point in space sees points of a surface, from its front.

    Parameters
    ----------
    rendered : mitsuba.Scene
    position, normal : (..., 3) float
    eye : 3 floats

    Returns
    -------
    (...) bool
    """
    towards = eye - position
    facing = (towards * normal).sum(axis=-1) > 0
    start = mi.Point3f((position + NUDGE * normal).reshape(-1, 3).T)
    towards = mi.Point3f(eye) - start
    distance = dr.norm(towards)
    ray = mi.Ray3f(start, towards / distance)
    ray.maxt = distance * (1 - 1e-3)
    return facing & ~np.array(rendered.ray_test(ray)).reshape(facing.shape)
