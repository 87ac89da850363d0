"""EXR layers, guides and manifests."""

import json

import numpy as np
import pytest

from data_gen.guides import guide
from data_gen.manifest import DataError, Manifest, recipe
from data_gen.multilayer_exr import read_layers, write_layers
from stylit_ref import read_uint8

LAYERS = {
    "LDE": np.random.default_rng(0).uniform(0, 1.5, (5, 7, 3)).astype(np.float32),
    "NORMAL": np.random.default_rng(1).uniform(-1, 1, (5, 7, 3)).astype(np.float32),
    "DEPTH": np.random.default_rng(2).uniform(5, 15, (5, 7, 1)).astype(np.float32),
    "MOTION": np.random.default_rng(3).uniform(-50, 50, (5, 7, 2)).astype(np.float32),
}


def test_layers_come_back_as_half_floats(tmp_path):
    write_layers(tmp_path / "a.exr", LAYERS)
    read = read_layers(tmp_path / "a.exr")
    assert set(read) == set(LAYERS)
    for name, layer in LAYERS.items():
        assert np.array_equal(read[name], layer.astype(np.float16).astype(np.float32))


def test_the_same_layers_give_the_same_bytes(tmp_path):
    for name in "ab":
        write_layers(tmp_path / f"{name}.exr", LAYERS)
    assert (tmp_path / "a.exr").read_bytes() == (tmp_path / "b.exr").read_bytes()


def test_light_guides_are_what_the_program_reads_from_the_exr(tmp_path):
    light = np.clip(LAYERS["LDE"], 0, 1).astype(np.float16).astype(np.float32)
    write_layers(tmp_path / "a.exr", {"LDE": light, "DEPTH": LAYERS["DEPTH"]})
    assert np.array_equal(read_uint8(f"{tmp_path / 'a.exr'}:LDE"), guide("LDE", light))


@pytest.mark.parametrize(
    ("name", "values", "expected"),
    [
        ("FULL", [0, 0.0031308, 0.2140411, 1, 7], [0, 10, 127, 255, 255]),
        ("IDMASK", [0, 0.5, 1], [0, 128, 255]),
        ("NORMAL", [-1, 0, 1], [0, 128, 255]),
        ("DEPTH", [0, 13.5, 9.75, 6, 40], [0, 0, 128, 255, 0]),
    ],
)
def test_transfer(name, values, expected):
    assert guide(name, np.array(values, float)).tolist() == expected


RECIPE = {"size": "3x3", "samples": 1, "seed": 0, "exr": True, "versions": {}, "code": "x"}


@pytest.fixture
def folder(tmp_path):
    """A data set of one target with one file and one style."""
    manifest = Manifest.open(tmp_path / "set")
    manifest.restart(RECIPE)
    for file in ("teapot/FULL.png", "source/FULL.png", "source/styles/oil.png"):
        path = tmp_path / "set" / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(file.encode())
    manifest.add("teapot")
    manifest.add("source")
    return tmp_path / "set"


def test_manifest_knows_what_is_there(folder):
    manifest = Manifest.read(folder)
    assert manifest.recipe == RECIPE
    assert manifest.targets == ["teapot"]
    assert manifest.styles == ["oil"]
    assert manifest.complete("teapot")
    assert not manifest.complete("golem")
    assert manifest.path("teapot/FULL.png") == folder / "teapot" / "FULL.png"


def test_targets_are_views_that_no_style_was_painted_over(folder):
    """Motion fields are no view."""
    for file in ("house/0_1/FULL.png", "house/motion/0_0_to_0_1.exr"):
        (folder / file).parent.mkdir(parents=True)
        (folder / file).write_bytes(b"")
    manifest = Manifest.read(folder)
    manifest.add("house/0_1")
    manifest.add("house/motion")
    assert Manifest.read(folder).targets == ["house/0_1", "teapot"]


def test_a_changed_file_is_noticed(folder):
    (folder / "teapot" / "FULL.png").write_bytes(b"other")
    with pytest.raises(DataError, match=r"FULL\.png: differs from manifest\.json"):
        Manifest.read(folder).path("teapot/FULL.png")
    assert not Manifest.read(folder).complete("teapot")


def test_a_missing_file_is_noticed(folder):
    (folder / "teapot" / "FULL.png").unlink()
    with pytest.raises(DataError, match=r"FULL\.png: is missing; render it again with 'make data'"):
        Manifest.read(folder).path("teapot/FULL.png")


def test_an_unknown_file_is_named(folder):
    with pytest.raises(DataError, match=r"does not list golem/FULL\.png"):
        Manifest.read(folder).path("golem/FULL.png")


@pytest.mark.parametrize("content", ["", "[]", json.dumps({"pieces": {}})])
def test_a_broken_manifest_is_refused(tmp_path, content):
    (tmp_path / "manifest.json").write_text(content)
    with pytest.raises(DataError, match="is not a manifest of rendered data"):
        Manifest.read(tmp_path)


def test_no_manifest_is_said(tmp_path):
    with pytest.raises(DataError, match=r"holds no manifest\.json"):
        Manifest.read(tmp_path)


def test_another_recipe_removes_what_the_first_one_made(folder):
    (folder / "notes.txt").write_text("mine")
    manifest = Manifest.open(folder)
    manifest.restart(RECIPE)
    assert manifest.complete("teapot")
    manifest.restart(RECIPE | {"samples": 2})
    assert Manifest.read(folder).pieces == {}
    left = {file.name for file in folder.rglob("*") if file.is_file()}
    assert left == {"manifest.json", "notes.txt"}


@pytest.mark.parametrize(
    "other", [{"size": (4, 3)}, {"samples": 4}, {"seed": 1}, {"exr": False}], ids=str
)
def test_a_recipe_tells_settings_apart(other):
    settings = {"size": (3, 3), "samples": 1, "seed": 0, "exr": True}
    assert recipe(**settings) == recipe(**settings)
    assert recipe(**settings) != recipe(**settings | other)


def test_what_a_killed_process_left_of_a_manifest_is_no_file_of_somebody_else(tmp_path):
    (tmp_path / "manifest.json.partial").write_text("{")
    Manifest.open(tmp_path).save()
    assert [file.name for file in tmp_path.iterdir()] == ["manifest.json"]


def test_a_folder_of_somebody_else_is_refused(tmp_path):
    (tmp_path / "source").mkdir()
    with pytest.raises(DataError, match="choose an empty folder"):
        Manifest.open(tmp_path)
