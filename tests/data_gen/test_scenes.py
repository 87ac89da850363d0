"""What scenes are made of, and the manifests that tell their files; no renderer is needed."""

import json
from itertools import pairwise
from pathlib import Path

import pytest

from data_gen.pieces import Motion, MotionOfTurn, SceneMesh, ViewsManifest
from data_gen.scenes import SCENES, USUAL

SHOTS = Path(__file__).parents[1] / "shots"

WITH_MANIFEST = [name for name, pieces in SCENES.items() if isinstance(pieces[-1], ViewsManifest)]


def pairs_of(rows):
    """Neighbours in rows and columns, both ways, as the texts between ``motion/`` and ``.exr``."""
    along = [pair for row in rows for pair in pairwise(row)]
    down = [pair for pair in pairwise(rows) for pair in zip(*pair, strict=True)]
    return {f"{a}_to_{b}" for pair in along + down for a, b in (pair, pair[::-1])}


@pytest.mark.parametrize("name", WITH_MANIFEST)
def test_a_manifest_names_what_the_scenes_pieces_make(name, tmp_path):
    *pieces, manifest = SCENES[name]
    manifest.make(tmp_path, None, False)
    content = json.loads((tmp_path / "views.json").read_text())
    names = {piece.name for piece in pieces} | {"source"}
    views = [view for row in content["grid"] for view in row]
    assert set(content["cameras"]) == set(views)
    for view in views:
        for guide in content["guides"]:
            assert guide["view"].replace("{view}", view).split("/{")[0].count("../") == 2
            assert f"{manifest.scene}/{view}" in names
    assert content["style"].split("/")[2] in names


@pytest.mark.parametrize("name", WITH_MANIFEST)
def test_there_is_motion_between_all_neighbours_both_ways(name):
    *pieces, manifest = SCENES[name]
    motion = next((p for p in pieces if isinstance(p, Motion | MotionOfTurn)), None)
    assert (motion is not None) == manifest.has_motion
    if isinstance(motion, Motion):
        assert {f"{a}_to_{b}" for a, b in motion.pairs} == pairs_of(manifest.rows)
        assert all(a in motion.cameras and b in motion.cameras for a, b in motion.pairs)


def test_manifests_of_buildings_name_their_mesh(tmp_path):
    *pieces, manifest = SCENES["house_5"]
    [mesh] = [piece for piece in pieces if isinstance(piece, SceneMesh)]
    manifest.make(tmp_path, None, False)
    content = json.loads((tmp_path / "views.json").read_text())
    assert content["mesh"] == f"../../{mesh.name}/scene.obj"
    mesh.make(tmp_path, None, False)
    lines = (tmp_path / "scene.obj").read_text().splitlines()
    parts = mesh.scene().parts
    assert [line[2:] for line in lines if line.startswith("o ")] == list(parts)
    assert sum(line.startswith("f ") for line in lines) == sum(
        len(part.faces) for part in parts.values()
    )


def test_the_animation_moves_object_and_camera():
    *_, motion, manifest = SCENES["animation"]
    assert len(motion.scenes) == len(motion.cameras) == 16
    assert len(set(motion.cameras)) == 16
    assert motion.degrees != 0
    assert manifest.rows == (tuple(f"{frame:02}" for frame in range(16)),)


def test_the_bundled_scenes_are_those_rendered_by_default():
    assert "house" in USUAL
    assert not {"turning", "animation", "chapel", "house_9x9"} & set(USUAL)


def test_the_source_view_itself_is_among_the_views_around_it():
    sketches, *views, _ = SCENES["house_around"]
    cameras = {view.name: view.camera for view in views}
    assert cameras["house_around/0"] == sketches.view.camera
    assert len(cameras) == 8


@pytest.mark.parametrize("scene", ["animation", "house"])
def test_all_files_of_the_small_shots_are_there(scene):
    folder = SHOTS / "manifests" / scene
    content = json.loads((folder / "views.json").read_text())
    files = {content["style"], *(guide["source"] for guide in content["guides"])}
    for row in content["grid"]:
        for view in row:
            files |= {guide["view"].replace("{view}", view) for guide in content["guides"]}
    for pair in pairs_of(content["grid"]):
        view, _, other = pair.partition("_to_")
        files.add(content["motion"].replace("{view}", view).replace("{other}", other))
    assert [file for file in files if not (folder / file).is_file()] == []


def test_the_small_shots_stay_small():
    assert sum(file.stat().st_size for file in SHOTS.rglob("*") if file.is_file()) < 300_000


@pytest.mark.parametrize("exr", [False, True])
def test_depth_is_named_where_it_is_kept(exr, tmp_path):
    SCENES["house_5"][-1].make(tmp_path, None, exr)
    content = json.loads((tmp_path / "views.json").read_text())
    assert content["ids"] == "../../house/{view}/IDMASK.png"
    assert content.get("depth") == ("../../house/{view}/passes.exr:DEPTH" if exr else None)
