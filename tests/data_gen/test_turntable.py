"""The scene that the studio opens with."""

import numpy as np
import pytest
from PIL import Image

from data_gen.manifest import DataError, Manifest
from data_gen.turntable import BUFFERS, BUNDLED, turntable
from data_gen.turntable.__main__ import main, pack
from stylit_ref import read_uint8
from stylit_ref.realtime.packing import StagePacking, choose_packing

STEPS = [f"{degrees:03}" for degrees in range(0, 360, 30)]


def test_it_is_whole():
    scene = turntable()
    manifest = Manifest.read(BUNDLED)
    assert all(manifest.complete(piece) for piece in manifest.pieces)
    assert list(scene.steps) == STEPS
    for files in (scene.source, *scene.steps.values()):
        assert set(files) == set(BUFFERS)
    assert set(scene.styles) == {"crayon", "oil", "watercolour", "pen"}


def test_nothing_lies_beside_it():
    listed = {file for files in Manifest.read(BUNDLED).pieces.values() for file in files}
    there = {f.relative_to(BUNDLED).as_posix() for f in BUNDLED.rglob("*") if f.is_file()}
    assert there == listed | {"manifest.json", "LICENSE"}


def test_it_is_small():
    assert sum(file.stat().st_size for file in BUNDLED.rglob("*") if file.is_file()) < 4_000_000


def test_the_packing_of_the_stage_suits_it():
    scene = turntable()
    source = {name: read_uint8(file) for name, file in scene.source.items()}
    assert isinstance(choose_packing(source), StagePacking)
    for name, image in source.items():
        assert image.shape == (500, 500, 1 if name == "FRESNEL" else 3)


@pytest.mark.parametrize("step", STEPS)
def test_every_step_shows_another_side(step):
    """All are of the size of the source, and none is the one before it."""
    steps = turntable().steps
    before = STEPS[STEPS.index(step) - 1]
    image, other = (read_uint8(steps[name]["FULL"]).astype(int) for name in (step, before))
    assert image.shape == (500, 500, 3)
    assert np.abs(image - other).mean() > 2


@pytest.fixture
def rendered(tmp_path):
    """A data set of 4x4 pixels, as the renderer would leave it."""
    rng = np.random.default_rng(0)
    manifest = Manifest.open(tmp_path / "rendered")
    manifest.restart({"size": "4x4"})
    for piece in ("source", "turntable/000", "turntable/030"):
        folder = manifest.folder / piece
        folder.mkdir(parents=True)
        for name in (*BUFFERS, "NORMAL"):
            shape = (4, 4) if name == "FRESNEL" else (4, 4, 3)
            Image.fromarray(rng.integers(0, 256, shape, np.uint8)).save(folder / f"{name}.png")
        if piece == "source":
            (folder / "styles").mkdir()
            Image.new("RGB", (4, 4), "red").save(folder / "styles" / "oil.png")
        manifest.add(piece)
    return manifest.folder


def test_packing_loses_nothing_but_what_is_not_read(rendered, tmp_path):
    pack(rendered, tmp_path / "packed")
    for piece in ("source", "turntable/030"):
        files = {file.stem: file for file in (tmp_path / "packed" / piece).glob("*.*")}
        assert set(files) == set(BUFFERS)
        for name, file in files.items():
            assert np.array_equal(read_uint8(file), read_uint8(rendered / piece / f"{name}.png"))
    painted = read_uint8(tmp_path / "packed" / "source" / "styles" / "oil.webp")
    assert np.abs(painted.astype(int) - (255, 0, 0)).max() < 10


def test_packing_again_gives_the_same_bytes(rendered, tmp_path):
    pack(rendered, tmp_path / "packed")
    once = (tmp_path / "packed" / "manifest.json").read_bytes()
    pack(rendered, tmp_path / "packed")
    assert (tmp_path / "packed" / "manifest.json").read_bytes() == once


def test_a_set_that_lacks_a_file_is_refused(rendered, tmp_path, capsys):
    (rendered / "source" / "LDE.png").unlink()
    assert main([str(rendered), "--folder", str(tmp_path / "packed")]) == 2
    assert "LDE.png: is missing" in capsys.readouterr().err


def test_a_changed_file_is_noticed(rendered, tmp_path, monkeypatch):
    pack(rendered, tmp_path / "packed")
    monkeypatch.setattr("data_gen.turntable.BUNDLED", tmp_path / "packed")
    assert list(turntable().steps) == ["000", "030"]
    (tmp_path / "packed" / "turntable" / "030" / "LDE.webp").write_bytes(b"other")
    with pytest.raises(DataError, match=r"LDE\.webp: differs"):
        turntable()
