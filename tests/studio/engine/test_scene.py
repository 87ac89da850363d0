"""Scenes in memory and of files: what is read is what ``run`` reads, and odd ones are refused."""

import numpy as np
import pytest
from small_studio import make_buffers, make_scene

from stylit_ref import read_guides, write_image
from stylit_ref.errors import InputError
from stylit_ref.studio.engine import scene as scene_module
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.engine.scene_reading import read_scene

GREY = np.zeros((6, 5, 1), np.uint8)


def counted(buffers, steps=3):
    """Steps of a target, and a list of those that were read."""
    read = []
    return [lambda k=k: read.append(k) or buffers for k in range(steps)], read


def test_a_step_is_read_once_while_it_is_kept(monkeypatch):
    targets, read = counted({"FULL": GREY})
    scene = Scene("s", "S", {"FULL": GREY}, targets)
    for step in (0, 1, 0, 1):
        scene.target(step)
    assert read == [0, 1]
    monkeypatch.setattr(scene_module, "_MOST_KEPT", GREY.nbytes)
    for step in (2, 2, 0):
        scene.target(step)
    assert read == [0, 1, 2, 0]


@pytest.mark.parametrize(
    ("source", "target", "sentence"),
    [
        ({}, {}, "the scene s needs a buffer and a target"),
        ({"FULL": GREY, "LDE": GREY[:3]}, {}, "the source of s has buffers of several sizes"),
        ({"full": GREY}, {}, "a name of capitals"),
        ({"MY/BUFFER": GREY}, {}, "a name of capitals"),
        ({"FULL": GREY.repeat(4, 2)}, {}, "each needs one or three channels"),
        ({"FULL": GREY.astype(float)}, {}, "must have buffers of uint8"),
        ({"FULL": np.zeros((1, 4097, 1), np.uint8)}, {}, "is 4097x1; each side must be at most"),
        ({"FULL": GREY}, {"LDE": GREY}, "step 0 of s has other buffers or channels"),
        ({"FULL": GREY}, {"FULL": GREY.repeat(3, 2)}, "step 0 of s has other buffers or channels"),
    ],
)
def test_what_does_not_go_together_is_refused(source, target, sentence):
    with pytest.raises(InputError, match=sentence):
        Scene("s", "S", source, [lambda: target]).target(0)


def test_a_target_has_the_order_of_the_source():
    colours = GREY.repeat(3, 2)
    scene = Scene(
        "s", "S", {"FULL": colours, "DEPTH": GREY}, [lambda: {"DEPTH": GREY, "FULL": colours}]
    )
    assert list(scene.target(0)) == ["FULL", "DEPTH"]


def test_there_is_no_such_step():
    with pytest.raises(InputError, match="step is 2; it must be an integer from 0 to 1"):
        make_scene(2).target(2)


def test_files_are_read_as_run_reads_them(tmp_path):
    """Grey beside colour, alpha beside none, floating point."""
    random = np.random.default_rng(0)
    kinds = {"FULL": (3, 3), "LDE": (1, 3), "LSE": (4, 3), "DEPTH": (1, 1)}
    guides = []
    for name, channels in kinds.items():
        guides.append([])
        for side, number in enumerate(channels):
            image = random.integers(0, 256, (9, 8, number), np.uint8)
            suffix = "exr" if name == "DEPTH" else "png"
            if suffix == "exr":
                image = image.astype(np.float32) * (1 + side)
            path = tmp_path / f"{side}" / f"{name}.{suffix}"
            write_image(path, image)
            guides[-1].append(str(path))
    scene, read = read_scene("s", "S", guides), read_guides(guides)
    assert scene.buffers == tuple(kinds)
    for own, expected in zip(scene.source.values(), read.source, strict=True):
        assert np.array_equal(own, expected)
    for own, expected in zip(scene.target(0).values(), read.targets[0], strict=True):
        assert np.array_equal(own, expected)
    assert scene.encodings == read.encodings


def test_steps_with_other_channels_are_refused(tmp_path):
    paths = [str(tmp_path / f"{k}" / "FULL.png") for k in range(3)]
    for path, channels in zip(paths, (3, 3, 1), strict=True):
        write_image(path, np.zeros((4, 5, channels), np.uint8))
    with pytest.raises(InputError, match="has other channels than another step"):
        read_scene("s", "S", [paths])


@pytest.mark.parametrize("guides", [[], [["a.png"]], [["a.png", "b.png"], ["a.png"]]])
def test_each_guide_needs_all_files(guides):
    with pytest.raises(InputError, match="each guide needs a file of the source and one of every"):
        read_scene("s", "S", guides)


def test_buffers_are_called_as_run_calls_them(tmp_path):
    paths = []
    for name in ("scene_full", "beauty", "ids"):
        path = tmp_path / f"{name}.png"
        write_image(path, make_buffers((9, 8), 0)["FULL"])
        paths.append([str(path)] * 2)
    assert read_scene("s", "S", paths).buffers == ("FULL", "BEAUTY", "IDMASK")
