"""A small scene of analytic shapes, rendered into the render passes of Fišer et al. 2016.

A red glossy object on a white floor before a white wall under one area light: a sphere
as the source, a figure as the target. Shapes are signed distance fields, traced by
sphere marching; light is sampled on a fixed stratified pattern, so the same code gives
the same pixels.

Passes, in 8-bit display values: ``dirdif`` direct diffuse light (LDE), ``dirspc``
mirror image of the light (LSE), ``indirb`` one diffuse bounce (LDDE), ``fullgi`` all
together.
"""

import math

import numpy as np
from numba import njit, prange

FLOOR, WALL, OBJECT = 0, 1, 2
SPHERE, FIGURE = 0, 1
PASSES = ("fullgi", "dirdif", "dirspc", "indirb")

_CAMERA = np.array([0.0, 1.9, 7.2])
_LOOK_AT = np.array([0.0, 1.12, 0.0])
_FIELD_OF_VIEW = 0.315  # half the width of the image plane at distance 1
_LIGHT = np.array([2.5, 4.6, 3.4])
_LIGHT_SIDE = np.array([1.0, 0.0, -0.74])
_LIGHT_UP = np.array([-0.45, 0.8, -0.6])
_LIGHT_POWER = 75.0
_WALL_Z = -2.6
_ALBEDO = np.array([[0.78, 0.78, 0.78], [0.72, 0.72, 0.74], [0.75, 0.05, 0.04]])


@njit
def _capsule(p, ax, ay, az, bx, by, bz, radius):
    dx, dy, dz = bx - ax, by - ay, bz - az
    px, py, pz = p[0] - ax, p[1] - ay, p[2] - az
    t = (px * dx + py * dy + pz * dz) / (dx * dx + dy * dy + dz * dz)
    t = min(max(t, 0.0), 1.0)
    return math.sqrt((px - t * dx) ** 2 + (py - t * dy) ** 2 + (pz - t * dz) ** 2) - radius


@njit
def _smooth_union(a, b, softness):
    h = max(softness - abs(a - b), 0.0) / softness
    return min(a, b) - h * h * softness * 0.25


@njit
def _object_distance(p, shape):
    if shape == SPHERE:
        return math.sqrt(p[0] ** 2 + (p[1] - 1.0) ** 2 + p[2] ** 2) - 1.0
    d = _capsule(p, 0.0, 1.15, 0.0, 0.05, 1.55, 0.0, 0.38)
    d = _smooth_union(d, _capsule(p, -0.22, 1.72, 0.0, 0.30, 1.74, 0.0, 0.20), 0.15)
    d = _smooth_union(d, _capsule(p, -0.20, 0.85, 0.0, -0.42, 0.16, 0.12, 0.16), 0.18)
    d = _smooth_union(d, _capsule(p, 0.20, 0.85, 0.0, 0.46, 0.16, 0.20, 0.16), 0.18)
    d = _smooth_union(d, _capsule(p, -0.42, 0.12, 0.12, -0.46, 0.12, 0.40, 0.12), 0.10)
    d = _smooth_union(d, _capsule(p, 0.46, 0.12, 0.20, 0.56, 0.12, 0.46, 0.12), 0.10)
    d = _smooth_union(d, _capsule(p, -0.38, 1.72, 0.0, -0.86, 1.25, 0.10, 0.12), 0.12)
    d = _smooth_union(d, _capsule(p, -0.86, 1.25, 0.10, -0.92, 0.72, 0.42, 0.11), 0.06)
    d = _smooth_union(d, _capsule(p, 0.44, 1.74, 0.0, 0.92, 1.98, 0.16, 0.12), 0.12)
    d = _smooth_union(d, _capsule(p, 0.92, 1.98, 0.16, 1.02, 2.48, 0.30, 0.11), 0.06)
    d = _smooth_union(d, _capsule(p, 1.02, 2.52, 0.30, 1.03, 2.58, 0.31, 0.17), 0.05)
    d = _smooth_union(d, _capsule(p, -0.92, 0.70, 0.42, -0.92, 0.62, 0.44, 0.17), 0.05)
    d = _smooth_union(d, _capsule(p, 0.08, 1.95, 0.05, 0.10, 2.05, 0.08, 0.10), 0.10)
    d = _smooth_union(d, _capsule(p, 0.10, 2.28, 0.10, 0.11, 2.34, 0.10, 0.29), 0.06)
    d = _smooth_union(d, _capsule(p, 0.13, 2.28, 0.38, 0.135, 2.25, 0.44, 0.05), 0.05)
    return d


@njit
def _march(origin, direction, shape, farthest):
    """Distance along a ray and what it hits (-1 for nothing)."""
    # Floor and wall are planes; only the object needs marching, inside its bounding ball.
    nearest, what = farthest, -1
    if direction[1] < 0:
        t = -origin[1] / direction[1]
        if t < nearest:
            nearest, what = t, FLOOR
    if direction[2] < 0:
        t = (_WALL_Z - origin[2]) / direction[2]
        if 0 < t < nearest:
            nearest, what = t, WALL
    cx, cy, cz = origin[0], origin[1] - 1.3, origin[2]
    b = cx * direction[0] + cy * direction[1] + cz * direction[2]
    discriminant = b * b - (cx * cx + cy * cy + cz * cz - 1.75**2)
    if discriminant <= 0:
        return nearest, what
    t, end = max(-b - math.sqrt(discriminant), 0.0), min(-b + math.sqrt(discriminant), nearest)
    while t < end:
        d = _object_distance(origin + t * direction, shape)
        if d < 4e-4:
            return t, OBJECT
        t += d
    return nearest, what


@njit
def _normal(p, what, shape):
    normal = np.zeros(3)
    if what == FLOOR:
        normal[1] = 1.0
    elif what == WALL:
        normal[2] = 1.0
    else:
        for axis in range(3):
            step = np.zeros(3)
            step[axis] = 1e-3
            normal[axis] = _object_distance(p + step, shape) - _object_distance(p - step, shape)
        normal /= math.sqrt((normal * normal).sum())
    return normal


@njit
def _direct(p, normal, shape, side, first):
    """Irradiance over π from ``side * side`` points of the light, jittered by ``first``."""
    total = 0.0
    for k in range(side * side):
        u = ((k // side) + ((k * 0.6180339887 + first) % 1.0)) / side * 2 - 1
        v = ((k % side) + ((k * 0.7548776662 + first) % 1.0)) / side * 2 - 1
        towards = _LIGHT + u * _LIGHT_SIDE + v * _LIGHT_UP - p
        distance = math.sqrt((towards * towards).sum())
        towards /= distance
        cosine = (towards * normal).sum()
        if cosine <= 0:
            continue
        _, blocked = _march(p + 3e-3 * normal, towards, shape, distance - 1e-2)
        if blocked < 0:
            total += cosine / (distance * distance)
    return _LIGHT_POWER * total / (side * side) / math.pi


@njit
def _bounce(p, normal, shape, samples, first, radiance):
    """Add one diffuse bounce: cosine-weighted directions on a golden-angle spiral."""
    tangent = np.array([normal[1], normal[2], -normal[0]])
    tangent -= (tangent * normal).sum() * normal
    tangent /= math.sqrt((tangent * tangent).sum())
    bitangent = np.cross(normal, tangent)
    for k in range(samples):
        r = math.sqrt((k + 0.5) / samples)
        angle = 2.39996323 * k + 6.2831853 * first
        direction = (
            r * math.cos(angle) * tangent
            + r * math.sin(angle) * bitangent
            + math.sqrt(1 - r * r) * normal
        )
        start = p + 3e-3 * normal
        t, what = _march(start, direction, shape, 30.0)
        if what >= 0:
            hit = start + t * direction
            light = _direct(hit, _normal(hit, what, shape), shape, 1, (first + k * 0.37) % 1.0)
            radiance += _ALBEDO[what] * light / samples


@njit
def _mirror_of_light(p, normal, view):
    """1 where the mirrored ray meets the light, falling off softly beyond its edge."""
    mirrored = view - 2 * (view * normal).sum() * normal
    light_normal = np.cross(_LIGHT_SIDE, _LIGHT_UP)
    t = ((_LIGHT - p) * light_normal).sum() / (mirrored * light_normal).sum()
    if t <= 0:
        return 0.0
    offset = p + t * mirrored - _LIGHT
    u = abs((offset * _LIGHT_SIDE).sum() / (_LIGHT_SIDE * _LIGHT_SIDE).sum())
    v = abs((offset * _LIGHT_UP).sum() / (_LIGHT_UP * _LIGHT_UP).sum())
    return min(max(3.0 - 2.2 * max(u, v), 0.0), 1.0)


@njit(parallel=True)
def _render(shape, height, width, antialias, light_side, bounces):
    forward = _LOOK_AT - _CAMERA
    forward /= math.sqrt((forward * forward).sum())
    right = np.cross(forward, np.array([0.0, 1.0, 0.0]))
    right /= math.sqrt((right * right).sum())
    up = np.cross(right, forward)
    passes = np.zeros((3, height, width, 3))
    for y in prange(height):
        for x in range(width):
            for sample in range(antialias * antialias):
                sub_y = (sample // antialias + 0.5) / antialias
                sub_x = (sample % antialias + 0.5) / antialias
                u = (2 * (x + sub_x) / width - 1) * _FIELD_OF_VIEW
                v = (1 - 2 * (y + sub_y) / height) * _FIELD_OF_VIEW * height / width
                view = forward + u * right + v * up
                view /= math.sqrt((view * view).sum())
                t, what = _march(_CAMERA, view, shape, 60.0)
                if what < 0:
                    continue
                p = _CAMERA + t * view
                normal = _normal(p, what, shape)
                first = (math.sin(x * 12.9898 + y * 78.233 + sample * 37.719) * 43758.5453) % 1.0
                share = 1.0 / (antialias * antialias)
                direct = _direct(p, normal, shape, light_side, first)
                passes[0, y, x] += _ALBEDO[what] * direct * share
                if what == OBJECT:
                    fresnel = 0.25 + 0.75 * (1 + (view * normal).sum()) ** 5
                    shine = _mirror_of_light(p, normal, view) * (direct > 0)
                    passes[1, y, x] += fresnel * 3.0 * shine * share
                bounced = np.zeros(3)
                _bounce(p, normal, shape, bounces, first, bounced)
                passes[2, y, x] += _ALBEDO[what] * bounced * share
    return passes


def render(shape, height, width, antialias=2, light_side=6, bounces=48):
    """Render the passes of a shape.

    Parameters
    ----------
    shape : {SPHERE, FIGURE}
    height, width : int
    antialias : int
        Rays a pixel on each axis.
    light_side : int
        Shadow rays a sample on each axis of the light.
    bounces : int
        Directions of indirect light a sample.

    Returns
    -------
    dict of str to (height, width, 3) uint8
        One image a pass, by the names of ``PASSES``, encoded with gamma 2.2.
        ``indirb`` is brightened by 1.6 on its own; ``fullgi`` holds it as it is.
    """
    direct, specular, bounced = _render(shape, height, width, antialias, light_side, bounces)
    linear = {
        "fullgi": direct + specular + bounced,
        "dirdif": direct,
        "dirspc": specular,
        "indirb": 1.6 * bounced,
    }
    encoded = {name: np.clip(image, 0, 1) ** (1 / 2.2) for name, image in linear.items()}
    return {name: np.floor(255 * image + 0.5).astype(np.uint8) for name, image in encoded.items()}
