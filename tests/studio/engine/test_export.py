"""What is exported makes the picture again, to the byte, by the command line."""

import shlex
from pathlib import Path

import numpy as np
import pytest
from small_studio import make_painting, make_scene

from stylit_ref import InputError, stylize, write_image
from stylit_ref.cli import main
from stylit_ref.files.field import Field
from stylit_ref.studio.engine import export as export_module
from stylit_ref.studio.engine.export import export
from stylit_ref.studio.engine.follower import Follower
from stylit_ref.studio.engine.parameters import Settings
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.engine.scene_reading import read_scene
from stylit_ref.studio.engine.shown import Shown

STROKE = np.full((6, 5, 3), 250, np.uint8)


def check(shown, folder):
    """Export, and run what is exported; returns the command lines."""
    exported = export(shown, folder)
    assert all((Path(exported.folder) / file).is_file() for file in exported.files)
    assert Path(exported.folder).is_absolute()
    picture = (folder / "picture.png").read_bytes()
    for line in exported.commands:
        program, *words = shlex.split(line)
        assert program == "stylit-ref"
        assert main(words) == 0
        assert (folder / f"{words[0]}.png").read_bytes() == picture, line
    assert (folder / "commands.sh").read_text().splitlines() == list(exported.commands)
    return exported.commands


def prepare(follower):
    follower.prepare(*[lambda *what: None] * 2)


def framed(scene, settings=None, *, step=0, warm=False):
    follower = Follower(scene, make_painting(), settings or Settings(), threads=1)
    follower.step = 1 if warm else step
    prepare(follower)
    follower.frame(warm=False)
    if warm:
        follower.step = 0
        prepare(follower)
        assert follower.frame(warm=True)[0] == "warm"
    return follower


def written(folder, scene, **buffers):
    """The files of a scene: for each guide that of the source and those of the steps."""
    guides = []
    for name in scene.buffers:
        paths = [folder / "source" / f"{name}.png"]
        write_image(paths[0], scene.source[name])
        for step in range(scene.steps):
            paths.append(folder / f"turn {step}" / f"{name}.png")
            write_image(paths[-1], scene.target(step)[name])
        guides.append([str(path) for path in paths])
    return guides


def test_a_frame_with_settings_of_all_kinds(tmp_path):
    values = {"mu": [0, 5], "labels": False, "iterations": [1, 2], "levels": 4, "terms": "means"}
    scene = make_scene()
    settings = Settings(seed=7).with_parameters(values)
    settings = settings.with_weights({"LSE": 0, "FULL": 3}, scene.buffers)
    run, replay = check(framed(scene, settings).shown(), tmp_path / "a folder")
    assert "--mu 0,5" in run
    assert "--weight 3" in run
    assert "replay --nnf" in replay


def test_a_replay_and_a_warm_frame_are_replayed(tmp_path):
    follower = framed(make_scene(2), warm=True)
    (line,) = check(follower.shown(), tmp_path / "warm")
    assert "stylit-ref replay" in line
    follower.paint(3, 4, STROKE, 1)
    prepare(follower)
    follower.replay()
    (line,) = check(follower.shown(), tmp_path / "replay")
    assert "stylit-ref replay" in line


def test_a_dense_finish(tmp_path):
    settings = Settings().with_parameters({"dense_finish": True})
    assert len(check(framed(make_scene(), settings).shown(), tmp_path)) == 2


@pytest.mark.parametrize("which", ["fast", "full"])
def test_a_picture_of_the_background(tmp_path, which):
    scene = make_scene()
    settings = Settings(seed=2).with_parameters({"uniformity": 2500, "patch_width": 3})
    settings = settings.with_weights({"LDE": 2}, scene.buffers)
    guides = list(scene.source.values()), list(scene.target(0).values())
    params = settings.dense_params(which, scene.buffers)
    result = stylize(make_painting(), *guides, params, seed=2, threads=1)
    field = Field(result.nnf, 3, style_size=scene.size)
    shown = Shown(which, result.image, make_painting(), field, scene, 0, settings)
    run, _ = check(shown, tmp_path)
    assert f"--preset {'fast' if which == 'fast' else 'final'}" in run
    assert "--uniformity 2500" in run


def test_a_scene_of_files_is_named_as_the_user_did(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    guides = written(tmp_path, make_scene(2))
    guides = [[path.removeprefix(f"{tmp_path}/") for path in paths] for paths in guides]
    scene = read_scene("files", "Files", guides)
    run, _ = check(framed(scene, step=1).shown(), tmp_path / "out")
    assert "--guide source/FULL.png 'turn 1/FULL.png'" in run
    assert not (tmp_path / "out" / "source").exists()


def test_steps_of_floating_point_are_encoded_as_all_of_them_were(tmp_path):
    guides = []
    for name, image in make_scene().source.items():
        paths = []
        for step, buffers in enumerate([{name: image}, *(make_scene(2).target(k) for k in (0, 1))]):
            paths.append(str(tmp_path / f"{step}" / f"{name}.exr"))
            light = buffers[name].astype(np.float32) / 255 * (3 if step == 2 else 1)
            if name in ("IDMASK", "LIGHTMASK"):
                light = light.clip(0, 1)
            write_image(paths[-1], light)
        guides.append(paths)
    scene = read_scene("exr", "EXR", guides)
    run, _ = check(framed(scene, Settings().with_parameters({"labels": False})).shown(), tmp_path)
    assert "--guide-encoding" in run


def test_buffers_of_another_scene_are_mixed_without_weights(tmp_path):
    stage = make_scene()
    names = "FULL", "IDMASK"
    scene = Scene(
        "plain", "Plain", {name: stage.source[name] for name in names},
        [lambda: {name: stage.target(0)[name] for name in names}],
    )  # fmt: skip
    settings = Settings().with_weights({"FULL": 3}, scene.buffers)
    run, _ = check(framed(scene, settings).shown(), tmp_path)
    assert "--weight" not in run


def test_an_export_that_fails_leaves_no_folder(tmp_path, monkeypatch):
    def fail(*arguments):
        raise InputError("the disk is full")

    shown = framed(make_scene()).shown()
    monkeypatch.setattr(export_module, "write_text", fail)
    with pytest.raises(InputError, match="the disk is full"):
        export(shown, tmp_path / "001")
    assert list(tmp_path.iterdir()) == []
