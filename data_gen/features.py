"""Features of the surface that each pixel centre sees, traced exactly, without noise.

========= ==================================================================
IDMASK    a colour for each part; thesis 5.2.4 (object, ground, wall),
          Heidrich 2017
FRESNEL   Schlick's approximation from the viewing angle; Heidrich 2017
LIGHTMASK highlight (R), lit (G), in shadow (B): the light's reflection is
          brighter than ``HIGHLIGHT``, at least half of the light is seen, or
          not; Heidrich 2017
NORMAL    unit normal, in the axes of the stage
POSITION  in units of the stage
DEPTH     distance from the eye's plane
WIREFRAME visible edges of the polygons, or slices of a smooth surface;
          Hauptfleisch 2020
========= ==================================================================

Heidrich's IDMASK also tells the cast shadow: here it is LIGHTMASK.B outside the object.
"""

from typing import NamedTuple

import mitsuba as mi
import numpy as np

from data_gen.load import point_on_light
from data_gen.visibility import sees
from data_gen.wireframe import visible_wires, wireframe

HIGHLIGHT = 0.5
_REFLECTANCE_AT_NORMAL = 0.04  # of a dielectric with index 1.5
_LIGHT_SIDE = 8  # shadow rays on each side of the light
_COLOURS = np.array([(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (0, 1, 1), (1, 0, 1)], np.float32)


class Surface(NamedTuple):
    """What the pixel centres of a view see.

    Attributes
    ----------
    part : (H, W) int
        Number of the part, -1 for none.
    position, normal : (H, W, 3) float32
        Zero where there is no part. Normals are turned towards the eye.
    directions : (H, W, 3) float32
        From the eye.
    """

    part: np.ndarray
    position: np.ndarray
    normal: np.ndarray
    directions: np.ndarray


def trace(rendered, scene, camera, height, width):
    """Follow a ray through each pixel centre.

    Parameters
    ----------
    rendered : mitsuba.Scene
        From :func:`data_gen.load.load`.
    scene : Scene
    camera : Camera
    height, width : int

    Returns
    -------
    Surface
    """
    directions = camera.directions(height, width).astype(np.float32)
    ray = mi.Ray3f(mi.Point3f(camera.origin), mi.Vector3f(directions.reshape(-1, 3).T))
    si = rendered.ray_intersect(ray)
    shapes = {shape.id(): shape for shape in rendered.shapes()}
    part = np.full(height * width, -1)
    for number, name in enumerate(scene.parts):
        part[np.array(si.is_valid() & (si.shape == mi.ShapePtr(shapes[name])))] = number
    seen = (part >= 0)[:, None]
    normal = np.where(seen, np.array(si.sh_frame.n).T, 0)
    away = (normal * directions.reshape(-1, 3)).sum(axis=1, keepdims=True) > 0
    position = np.where(seen, np.array(si.p).T, 0)
    return Surface(
        part.reshape(height, width),
        np.ascontiguousarray(position.reshape(height, width, 3), np.float32),
        np.ascontiguousarray(np.where(away, -normal, normal).reshape(height, width, 3), np.float32),
        directions,
    )


def features(rendered, scene, camera, surface, highlights):
    """All features of a view.

    Parameters
    ----------
    rendered, scene, camera
        As for :func:`trace`.
    surface : Surface
    highlights : (H, W, 3) float32
        LSE.

    Returns
    -------
    dict of str to (H, W, n) float32
    """
    seen = (surface.part >= 0)[..., None]
    towards_eye = -(surface.normal * surface.directions).sum(axis=-1, keepdims=True)
    fresnel = _REFLECTANCE_AT_NORMAL + (1 - _REFLECTANCE_AT_NORMAL) * (1 - towards_eye) ** 5
    size = surface.part.shape
    forward = camera.axes()[2]
    depth = (surface.position - np.asarray(camera.origin)) @ forward
    result = {
        "IDMASK": np.where(seen, _COLOURS[surface.part], 0),
        "FRESNEL": np.where(seen, fresnel, 0),
        "LIGHTMASK": _light_mask(rendered, scene, surface, highlights),
        "NORMAL": surface.normal,
        "POSITION": surface.position,
        "DEPTH": np.where(seen, depth[..., None], 0),
        "WIREFRAME": wireframe(visible_wires(rendered, scene, camera, *size), *size),
    }
    return {name: layer.astype(np.float32) for name, layer in result.items()}


def _light_mask(rendered, scene, surface, highlights):
    seen = surface.part >= 0
    steps = (2 * np.arange(_LIGHT_SIDE) + 1) / _LIGHT_SIDE - 1
    visible = sum(
        sees(rendered, surface.position, surface.normal, point_on_light(scene.light, u, v))
        for u in steps
        for v in steps
    )
    shine = seen & (highlights.max(axis=-1) > HIGHLIGHT)
    lit = seen & ~shine & (visible >= _LIGHT_SIDE**2 / 2)
    return np.stack([shine, lit, seen & ~shine & ~lit], axis=-1)
