"""Scenes in the renderer's form."""

import mitsuba as mi
import numpy as np


def point_on_light(light, u, v):
    """The point of a light at ``u``, ``v`` in [-1, 1] along its sides."""
    return np.array(_light_to_world(light) @ mi.ScalarPoint3f(u, v, 0))


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
            "to_world": _light_to_world(scene.light),
            "emitter": {"type": "area", "radiance": _grey(scene.light.radiance)},
        },
    }
    if scene.sky:
        entries["sky"] = {"type": "constant", "radiance": _grey(scene.sky)}
    for name, mesh in scene.parts.items():
        entries[name] = _shape(name, mesh, scene.materials[name])
    return mi.load_dict(entries, optimize=False)


def _light_to_world(light):
    turn = mi.ScalarTransform4f().look_at(light.middle, light.target, (0, 1, 0))
    return turn @ mi.ScalarTransform4f().scale((*light.half, 1))


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
