"""Scenes for the renderer: parts with materials, one area light, a camera.

``on_stage`` is the scene of Fišer et al. 2016 and of thesis 4.1: a red glossy object on a
white ground before a white wall. ``house_scene`` is an architectural one (Hauptfleisch
2020), seen from a grid of views.
"""

from typing import NamedTuple

import mitsuba as mi
import numpy as np

from data_gen.models.house import ground, house
from data_gen.models.mesh import backdrop


class Light(NamedTuple):
    """A rectangle that shines to one side: its middle, what it faces, half sides, radiance."""

    middle: tuple
    target: tuple
    half: tuple
    radiance: float

    def point(self, u, v):
        """The point at ``u``, ``v`` in [-1, 1] along its sides."""
        return np.array(self.to_world() @ mi.ScalarPoint3f(u, v, 0))

    def to_world(self):
        turn = mi.ScalarTransform4f().look_at(self.middle, self.target, (0, 1, 0))
        return turn @ mi.ScalarTransform4f().scale((*self.half, 1))


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


def load(scene, camera, height, width, samples, integrator):
    """The renderer's form of a scene and a view."""
    look_at = mi.ScalarTransform4f().look_at
    entries = {
        "type": "scene",
        "integrator": integrator,
        "sensor": {
            "type": "perspective",
            "fov": camera.field_of_view,
            "fov_axis": "y",
            "to_world": look_at(origin=camera.origin, target=camera.target, up=(0, 1, 0)),
            "film": {
                "type": "hdrfilm",
                "width": width,
                "height": height,
                "rfilter": {"type": "box"},
                "pixel_format": "rgb",
                "component_format": "float32",
            },
            "sampler": {"type": "multijitter", "sample_count": samples},
        },
        "light": {
            "type": "rectangle",
            "to_world": scene.light.to_world(),
            "emitter": {"type": "area", "radiance": _grey(scene.light.radiance)},
        },
    }
    if scene.sky:
        entries["sky"] = {"type": "constant", "radiance": _grey(scene.sky)}
    for name, mesh in scene.parts.items():
        entries[name] = _shape(name, mesh, scene.materials[name])
    return mi.load_dict(entries, optimize=False)


def _shape(name, mesh, material):
    reflectance = {"type": "rgb", "value": list(material.reflectance)}
    if material.roughness is None:
        bsdf = {"type": "diffuse", "reflectance": reflectance}
    else:
        bsdf = {
            "type": "roughplastic",
            "diffuse_reflectance": reflectance,
            "alpha": material.roughness,
        }
    properties = mi.Properties()
    properties["bsdf"] = mi.load_dict({"type": "twosided", "bsdf": bsdf})
    shape = mi.Mesh(
        name, len(mesh.vertices), len(mesh.faces), props=properties,
        has_vertex_normals=mesh.normals is not None,
    )  # fmt: skip
    values = mi.traverse(shape)
    values["vertex_positions"] = mesh.vertices.ravel()
    values["faces"] = mesh.faces.ravel()
    if mesh.normals is not None:
        values["vertex_normals"] = mesh.normals.ravel()
    values.update()
    return shape


def _grey(value):
    return {"type": "rgb", "value": [value] * 3}
