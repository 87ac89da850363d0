"""Scenes of a folder and of a data set."""

import shutil

import pytest

from data_gen.manifest import Manifest
from data_gen.models import TARGETS
from eval.scenes import BUNDLED, load_scene
from stylit_ref import InputError


def test_scene_is_read_by_names(folder):
    scene = load_scene(folder)
    assert scene.name == "small"
    assert scene.guide_names == ("fullgi", "id")
    assert scene.size == "44x38"
    assert load_scene(folder, step=2).size == "22x19"


def test_a_guide_without_its_partner_is_named(folder):
    (folder / "target_id.png").unlink()
    with pytest.raises(InputError, match="the guide 'id' lacks its target_id image"):
        load_scene(folder)


@pytest.mark.parametrize("target", [*TARGETS, "house/source"])
def test_bundled_scenes_are_complete(target):
    for style in ("crayon", "oil", "pen", "watercolour"):
        scene = load_scene(f"{target}/{style}")
        assert scene.name == f"{target.replace('/', '_')}_{style}"
        assert scene.guide_names == ("FULL", "LDE", "LSE", "LDDE", "LD12E")
        assert scene.size == "300x228"
        assert scene.style.shape == scene.shown_guide.shape == (228, 300, 3)


def test_bundled_data_is_whole():
    manifest = Manifest.read(BUNDLED)
    assert set(TARGETS) < set(manifest.targets)
    assert all(manifest.complete(piece) for piece in manifest.pieces)
    motions = [file for file in manifest.pieces["house/motion"] if file.endswith(".exr")]
    assert len(motions) == 24
    assert sum(piece.startswith("house/") for piece in manifest.pieces) == 11


def test_a_scene_that_is_not_there_is_named():
    with pytest.raises(InputError, match=r"bunny/oil: is neither a folder nor TARGET/STYLE of"):
        load_scene("bunny/oil")


def test_a_damaged_data_set_is_refused(tmp_path):
    data = tmp_path / "data"
    shutil.copytree(BUNDLED, data, ignore=shutil.ignore_patterns("house"))
    (data / "golem" / "LDE.png").write_bytes((data / "golem" / "FULL.png").read_bytes())
    with pytest.raises(InputError, match=r"LDE\.png: differs from manifest\.json"):
        load_scene("golem/oil", data)
    assert load_scene("teapot/oil", data).size == "300x228"


def test_buffers_are_read_where_they_are_named_and_count_for_the_digest():
    plain = load_scene("golem/oil", step=6)
    named = load_scene("golem/oil", step=6, buffers=("NORMAL", "FRESNEL"))
    assert plain.buffers == {}
    assert list(named.buffers) == ["NORMAL", "FRESNEL"]
    assert [image.shape for image in named.buffers["FRESNEL"]] == [(38, 50, 1)] * 2
    assert named.digest != plain.digest


def test_a_folder_has_no_buffers(folder):
    with pytest.raises(InputError, match=r"has guides alone; name a TARGET/STYLE of a data set"):
        load_scene(folder, buffers=("NORMAL",))
