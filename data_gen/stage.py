"""Scenes: parts with materials, one area light, a camera.

``on_stage`` is the scene of Fišer et al. 2016 and of thesis 4.1: a red glossy object on a
white ground before a white wall. ``house_scene`` and ``chapel_scene`` are architectural
(Hauptfleisch 2020), seen from grids of views.
"""

from typing import NamedTuple

import numpy as np

from data_gen.models.chapel import chapel
from data_gen.models.house import ground, house
from data_gen.models.mesh import backdrop


class Light(NamedTuple):
    """A rectangle that shines to one side: its middle, what it faces, half sides, radiance."""

    middle: tuple
    target: tuple
    half: tuple
    radiance: float


class Material(NamedTuple):
    """Diffuse reflectance (RGB), and the roughness of a coat that mirrors, if it has one."""

    reflectance: tuple
    roughness: float | None = None


class Scene(NamedTuple):
    """What a view is rendered from.

    Attributes
    ----------
    parts : dict of str to Mesh
    materials : dict of str to Material
        Of each part.
    light : Light
    sky : float
        Radiance from all around; 0 is black.
    """

    parts: dict
    materials: dict
    light: Light
    sky: float


def on_stage(model):
    """A model in red on the white stage."""
    wall_turn = np.radians(5)
    along = np.array([np.cos(wall_turn), 0, np.sin(wall_turn)])
    foot, up = np.array([0, 0, -3.2]), np.array([0, 14.0, 0])
    left, right = foot - 25 * along, foot + 25 * along
    front = np.array([0, 0, 40.0])
    return Scene(
        parts={
            "object": model,
            "ground": backdrop([left + front, right + front, right, left]),
            "wall": backdrop([left, right, right + up, left + up]),
        },
        materials={
            "object": Material((0.80, 0.012, 0.012), roughness=0.09),
            "ground": Material((0.80, 0.80, 0.80)),
            "wall": Material((0.72, 0.72, 0.72)),
        },
        light=Light((2.1, 6.2, 1.0), (0.0, 0.9, 0.0), (0.95, 0.5), 85.0),
        sky=0.0,
    )


def house_scene():
    """The house on its lawn, in the evening sun of a large light."""
    materials = {
        "walls": Material((0.78, 0.70, 0.56)),
        "roof": Material((0.50, 0.13, 0.08)),
        "glass": Material((0.05, 0.07, 0.10), roughness=0.05),
        "frames": Material((0.75, 0.75, 0.72), roughness=0.2),
        "stone": Material((0.42, 0.40, 0.38)),
        "ground": Material((0.24, 0.34, 0.14)),
    }
    return Scene(
        parts=house() | {"ground": ground()},
        materials=materials,
        light=Light((16.0, 17.0, 15.0), (0.0, 2.0, 0.0), (2.5, 2.5), 105.0),
        sky=0.4,
    )


def chapel_scene():
    """The chapel on dry grass, in a sun that is small enough for the cross' shadow to be sharp."""
    materials = {
        "walls": Material((0.82, 0.80, 0.74)),
        "roof": Material((0.36, 0.20, 0.15)),
        "glass": Material((0.05, 0.07, 0.10), roughness=0.05),
        "stone": Material((0.46, 0.43, 0.38)),
        "copper": Material((0.16, 0.36, 0.30), roughness=0.25),
        "ground": Material((0.42, 0.40, 0.22)),
    }
    return Scene(
        parts=chapel() | {"ground": ground()},
        materials=materials,
        light=Light((12.0, 21.0, 15.0), (0.0, 2.0, 0.0), (0.45, 0.45), 2700.0),
        sky=0.4,
    )
