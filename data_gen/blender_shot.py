"""A small animated scene in Blender, with passes and vectors in its multilayer EXR.

Run it with the Python that has ``bpy`` (``make blender`` does); it needs nothing else of this
project. A block turns and slides past a ball on a floor while the camera moves. What it writes:

    FOLDER/perspective/shot.0001.exr ...   Combined, Diffuse Direct, Depth, Object Index, Vector
    FOLDER/source.exr                      the same in another arrangement, to paint a style on
    FOLDER/scene.json                      matrices of camera and objects in every frame
    FOLDER/blurred/shot.0001.exr ...       motion blur is on, and Vector is 0 everywhere
    FOLDER/orthographic/shot.0001.exr ...  the camera is orthographic, and Vector is wrong

Samples lie in the middle of a pixel, so that vectors and depths are exact there.
"""

import argparse
import json
import math
from pathlib import Path

import bpy
from mathutils import Vector

LENS, SENSOR = 50, 36
"""Focal length and width of the sensor, in millimetres."""

FLOOR, BLOCK, BALL = "floor", "block", "ball"
INDICES = {FLOOR: 1, BLOCK: 2, BALL: 3}


def main():
    """Render the shots."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--size", default="240x180", metavar="WIDTHxHEIGHT")
    parser.add_argument("--frames", type=int, default=12)
    parser.add_argument("--samples", type=int, default=16)
    options = parser.parse_args()
    width, height = map(int, options.size.split("x"))

    scene, camera, objects = make_scene(options.frames)
    set_output(scene, width, height, options.samples)
    facts = {"width": width, "height": height, "lens": LENS, "sensor": SENSOR, "indices": INDICES}
    facts["frames"] = {}
    for number in range(1, options.frames + 1):
        render(scene, options.folder / "perspective" / f"shot.{number:04}.exr", number)
        moved = {"camera": camera} | objects
        facts["frames"][number] = {name: rows_of(each.matrix_world) for name, each in moved.items()}
    (options.folder / "scene.json").write_text(json.dumps(facts, indent=1) + "\n")

    scene.render.use_motion_blur = True
    for number in (1, 2):
        render(scene, options.folder / "blurred" / f"shot.{number:04}.exr", number)
    scene.render.use_motion_blur = False
    camera.data.type, camera.data.ortho_scale = "ORTHO", 8
    for number in (1, 2):
        render(scene, options.folder / "orthographic" / f"shot.{number:04}.exr", number)
    camera.data.type = "PERSP"
    objects[BLOCK].animation_data_clear()
    objects[BLOCK].location, objects[BALL].location = (-1.3, 0.5, 0.8), (1.3, -0.4, 1)
    render(scene, options.folder / "source.exr", 1)


def make_scene(frames):
    """The scene with its keyframes; returns it, the camera, and the objects by name."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, frames
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.25, 0.28, 0.32, 1)

    bpy.ops.mesh.primitive_plane_add(size=60)
    floor = named(FLOOR, (0.55, 0.5, 0.42), 1.5)
    bpy.ops.mesh.primitive_cube_add(size=1.6, location=(0, 0, 0.8))
    block = named(BLOCK, (0.75, 0.3, 0.2), 3)
    bpy.ops.mesh.primitive_uv_sphere_add(radius=1, segments=96, ring_count=48, location=(0, 0, 1))
    ball = named(BALL, (0.25, 0.45, 0.7), 3)
    bpy.ops.object.shade_smooth()
    ball.location = (1.4, 1.2, 1)

    bpy.ops.object.light_add(type="SUN", rotation=(math.radians(40), math.radians(-25), 0))
    bpy.context.object.data.energy, bpy.context.object.data.angle = 3, 0.05
    bpy.ops.object.camera_add()
    camera = scene.camera = bpy.context.object
    camera.data.lens, camera.data.sensor_width = LENS, SENSOR

    for number in range(frames + 2):  # one before and one after: they have vectors too
        turn = math.radians(5 * number)
        move(block, number, location=(-2.0 + 0.2 * number, -0.6, 0.8), rotation=(0, 0, turn))
        angle = math.radians(-70 + 2.5 * number)
        eye = Vector((9 * math.cos(angle), 9 * math.sin(angle), 5.5 + 0.03 * number))
        aim = (Vector((0, 0, 0.6)) - eye).to_track_quat("-Z", "Y").to_euler()
        move(camera, number, location=eye, rotation=aim)
    return scene, camera, {FLOOR: floor, BLOCK: block, BALL: ball}


def named(name, colour, scale):
    """Name the object that was added last, and give it a speckled surface."""
    made = bpy.context.object
    made.name, made.pass_index = name, INDICES[name]
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    noise, ramp = nodes.new("ShaderNodeTexNoise"), nodes.new("ShaderNodeValToRGB")
    place = nodes.new("ShaderNodeTexCoord")
    noise.inputs["Scale"].default_value = scale
    for stop, light in zip(ramp.color_ramp.elements, (0.5, 1.3), strict=True):
        stop.color = (*(light * value for value in colour), 1)
    ramp.color_ramp.elements[0].position, ramp.color_ramp.elements[1].position = 0.42, 0.58
    links.new(place.outputs["Object"], noise.inputs["Vector"])
    links.new(noise.outputs["Fac"], ramp.inputs["Fac"])
    links.new(ramp.outputs["Color"], nodes["Principled BSDF"].inputs["Base Color"])
    made.data.materials.append(material)
    return made


def move(thing, number, location, rotation):
    """Set a keyframe."""
    thing.location, thing.rotation_euler = location, rotation
    thing.keyframe_insert("location", frame=number)
    thing.keyframe_insert("rotation_euler", frame=number)


def set_output(scene, width, height, samples):
    """Cycles on the processor, and the passes in one multilayer EXR."""
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples, scene.cycles.seed = "CPU", samples, 0
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "GAUSSIAN", 0.01
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    scene.render.use_stamp_date = scene.render.use_stamp_render_time = False
    layer = scene.view_layers[0]
    layer.use_pass_z = layer.use_pass_vector = layer.use_pass_object_index = True
    layer.use_pass_diffuse_direct = True
    output = scene.render.image_settings
    output.media_type = "MULTI_LAYER_IMAGE"  # before the format, which it offers
    output.file_format, output.color_depth, output.exr_codec = "OPEN_EXR_MULTILAYER", "16", "ZIP"


def render(scene, file, number):
    """Render a frame into a file."""
    scene.frame_set(number)
    scene.render.filepath = str(file.resolve())
    bpy.ops.render.render(write_still=True)


def rows_of(matrix):
    """A matrix as lists."""
    return [list(row) for row in matrix]


if __name__ == "__main__":
    main()
