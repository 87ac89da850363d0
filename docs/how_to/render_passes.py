"""Renders the passes that stylit-ref takes, in Blender 4.2 or newer.

In Blender's text editor: paste this, and press Run Script. Or without a window:

    blender --background shot.blend --python render_passes.py
    python render_passes.py shot.blend

The second line needs the module bpy, and nothing else. The frames of ``shot.blend`` become
``renders/shot.0001.exr`` and so on, beside it. The scene's settings are put back afterwards.
"""

import sys
from pathlib import Path

import bpy

PASSES = "z", "vector", "object_index", "diffuse_direct", "diffuse_indirect", "glossy_direct"


def settings(scene, name):
    """What is set while the frames are rendered: of what, which, and the value."""
    render, output, layer = scene.render, scene.render.image_settings, scene.view_layers[0]
    yield render, "engine", "CYCLES"  # the only one with vectors
    yield render, "use_motion_blur", False  # with it, all vectors are zero
    yield render, "use_compositing", False
    yield render, "use_sequencer", False
    yield render, "filepath", f"//renders/{name}.####"
    if hasattr(output, "media_type"):  # Blender 5 offers the format only then
        yield output, "media_type", "MULTI_LAYER_IMAGE"
    yield output, "file_format", "OPEN_EXR_MULTILAYER"
    yield output, "color_depth", "32"
    for each in PASSES:
        yield layer, f"use_pass_{each}", True


def main():
    """Render every frame of the scene."""
    if bpy.app.module:
        bpy.ops.wm.open_mainfile(filepath=sys.argv[1])
    if not bpy.data.filepath:
        raise RuntimeError("save the file first: the renders are written beside it")
    scene = bpy.context.scene
    if scene.camera is None:
        raise RuntimeError("the scene has no camera")
    if scene.camera.data.type == "ORTHO" and scene.frame_start != scene.frame_end:
        raise RuntimeError("the camera is orthographic, and vectors are wrong if it moves")
    for thing in scene.objects:
        if thing.type == "MESH" and not thing.pass_index:
            print(f"{thing.name}: has no Pass Index; paint may spill onto it")

    wanted = list(settings(scene, Path(bpy.data.filepath).stem))
    before = [(owner, name, getattr(owner, name)) for owner, name, _ in wanted]  # one moves others
    try:
        for owner, name, value in wanted:
            setattr(owner, name, value)
        bpy.ops.render.render(animation=True)
    finally:
        for owner, name, value in before:
            setattr(owner, name, value)


if __name__ == "__main__":
    main()
