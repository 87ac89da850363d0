"""The script for Blender sets what vectors need, renders, and puts the scene's settings back."""

import runpy
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

SCRIPT = Path(__file__).parents[2] / "docs/how_to/render_passes.py"
PASSES = "z", "vector", "object_index", "diffuse_direct", "diffuse_indirect", "glossy_direct"


DEPTHS = {"PNG": ("8", "16"), "JPEG": ("8",), "OPEN_EXR_MULTILAYER": ("32", "16")}


class Settings:
    """Attributes that are there, as in Blender: another one cannot be set."""

    def __init__(self, **values):
        vars(self).update(values)

    def __setattr__(self, name, value):
        assert name in vars(self), f"Blender has no {name} here"
        vars(self)[name] = value


class Output(Settings):
    """The format of files, which change with what they depend on, as in Blender 5.

    A format is offered only after its kind of media, a depth only with a format that has it.
    """

    def __setattr__(self, name, value):
        if name == "file_format" and "media_type" in vars(self):
            layered = self.media_type == "MULTI_LAYER_IMAGE"
            assert layered == (value == "OPEN_EXR_MULTILAYER"), "not offered"
        if name == "color_depth":
            assert value in DEPTHS[self.file_format], "not offered"
        super().__setattr__(name, value)
        if name == "media_type":
            self.file_format = "OPEN_EXR_MULTILAYER" if value == "MULTI_LAYER_IMAGE" else "JPEG"
        if name == "file_format" and self.color_depth not in DEPTHS[value]:
            self.color_depth = DEPTHS[value][0]


def values_of(scene):
    """All settings of a scene."""
    owners = scene.render, scene.render.image_settings, scene.view_layers[0]
    return [dict(vars(owner)) for owner in owners]


@pytest.fixture(params=[4, 5])
def blender(request, monkeypatch):
    """A stand-in for Blender; ``rendered`` has the settings at the time of a render."""
    output = Output(file_format="PNG", color_depth="8")
    if request.param == 5:
        output = Output(media_type="IMAGE", **vars(output))
    render = Settings(
        engine="EEVEE", use_motion_blur=True, use_compositing=True, use_sequencer=True,
        filepath="//here", image_settings=output,
    )  # fmt: skip
    layer = Settings(**{f"use_pass_{name}": False for name in PASSES})
    scene = Settings(
        render=render, view_layers=[layer], objects=[], frame_start=1, frame_end=9,
        camera=SimpleNamespace(data=SimpleNamespace(type="PERSP")),
    )  # fmt: skip
    rendered = []

    def render_frames(animation):
        assert animation
        rendered.append(values_of(scene))

    module = SimpleNamespace(
        app=SimpleNamespace(module=False),
        context=SimpleNamespace(scene=scene),
        data=SimpleNamespace(filepath="/films/shot.blend"),
        ops=SimpleNamespace(
            render=SimpleNamespace(render=render_frames),
            wm=SimpleNamespace(open_mainfile=None),
        ),
        rendered=rendered,
    )
    monkeypatch.setitem(sys.modules, "bpy", module)
    return module


def run():
    """What *Run Script* does."""
    runpy.run_path(str(SCRIPT), run_name="__main__")


def test_frames_are_rendered_with_passes_and_vectors(blender):
    run()
    ((render, output, layer),) = blender.rendered
    assert render["engine"] == "CYCLES"
    assert not render["use_motion_blur"]
    assert render["filepath"] == "//renders/shot.####"
    assert output["file_format"] == "OPEN_EXR_MULTILAYER"
    assert output["color_depth"] == "32"
    assert layer == {f"use_pass_{name}": True for name in PASSES}


def test_settings_are_put_back(blender):
    before = values_of(blender.context.scene)
    run()
    assert values_of(blender.context.scene) == before


def test_settings_are_put_back_if_a_render_fails(blender):
    def fail(animation):
        raise RuntimeError("out of memory")

    before = values_of(blender.context.scene)
    blender.ops.render.render = fail
    with pytest.raises(RuntimeError, match="out of memory"):
        run()
    assert values_of(blender.context.scene) == before


def test_the_module_opens_the_file_that_is_named(blender, monkeypatch):
    opened = []
    blender.app.module = True
    blender.ops.wm.open_mainfile = lambda filepath: opened.append(filepath)
    monkeypatch.setattr(sys, "argv", ["render_passes.py", "shot.blend"])
    run()
    assert opened == ["shot.blend"]


def test_a_file_that_was_never_saved_is_refused(blender):
    blender.data.filepath = ""
    with pytest.raises(RuntimeError, match="save the file first"):
        run()


def test_a_scene_without_a_camera_is_refused(blender):
    blender.context.scene.camera = None
    with pytest.raises(RuntimeError, match="no camera"):
        run()


def test_a_moving_orthographic_camera_is_refused(blender):
    blender.context.scene.camera.data.type = "ORTHO"
    with pytest.raises(RuntimeError, match="orthographic"):
        run()


def test_things_without_a_number_are_named(blender, capsys):
    blender.context.scene.objects = [SimpleNamespace(name="cup", type="MESH", pass_index=0)]
    run()
    assert "cup: has no Pass Index" in capsys.readouterr().out
