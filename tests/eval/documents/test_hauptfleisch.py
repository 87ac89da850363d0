"""The report on views and sequences on tiny frames: all is there, and nothing is done twice."""

import json
import re
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from PIL import Image
from small_shot import EFFORT, slides, sliding

import eval.documents.hauptfleisch.report as report_module
import eval.runs.local
from eval.__main__ import main
from eval.documents.hauptfleisch.goals import GOALS
from eval.documents.hauptfleisch.long_shot import LongShot
from eval.documents.hauptfleisch.pictures import steps_of
from eval.documents.hauptfleisch.presets import PRESETS, Preset
from eval.documents.hauptfleisch.sintel import FLOW, FRAMES, HIDDEN, read_sintel
from eval.frame_sets import FrameSet
from eval.metrics.warping import warping_error
from eval.pages.claims import HELD, NOT_HELD, OPEN
from stylit_ref import InputError, Params, write_image
from stylit_ref.views.frames import grid_pairs
from stylit_ref.views.params import SEQUENTIAL, Coherence

COUNTS = {"house": 4, "animation": 3}


def tiny_frames(scene, style, data, guides, frames):
    """A sequence that slides, or a grid of which two views each are the same."""
    if "600" in str(data):
        raise InputError(f"{data}: holds no manifest.json")
    shot = sliding(COUNTS[scene])
    renderings = np.stack([each[0] + np.uint8(k) for k, each in enumerate(shot.guides)])
    edges = shot.edges
    if scene == "house":
        line = slides(renderings.shape[1:3], 4)
        edges = {
            (to, other): line[0, 1]._replace(field=line[0, 1].field * (other - to))
            for to, other in grid_pairs(2, 2)
        }
    halves = np.zeros((*renderings.shape[:3], 1), np.uint8)
    halves[:, :, 20:] = 200
    depths = np.where(halves[..., 0], np.float32(9), np.float32(18))
    return FrameSet(
        f"{scene}_{style}", shot.style, tuple(shot.sources), tuple(map(tuple, shot.guides)), edges,
        renderings, depths, halves,
    )  # fmt: skip


def tiny_footage(folder):
    """Two frames that slide, of which nothing else is known."""
    shot = sliding(2)
    renderings = np.stack([each[0] + np.uint8(k) for k, each in enumerate(shot.guides)])
    guides = tuple(map(tuple, shot.guides))
    return FrameSet("footage", shot.style, tuple(shot.sources), guides, shot.edges, renderings)


@pytest.fixture
def tiny(monkeypatch):
    """Tiny frames, short runs, and few of them."""
    few = {
        "house": {"ref": (Coherence(0.5), Coherence(1.0))},
        "large": {"ref": (Coherence(1.0),)},
        "animation": {"ref": (Coherence(1.0, order=SEQUENTIAL), Coherence(1.0))},
        "sintel": {"ref": (Coherence(1.0, order=SEQUENTIAL),)},
    }
    monkeypatch.setattr(report_module, "read_frames", tiny_frames)
    monkeypatch.setattr(report_module, "read_sintel", tiny_footage)
    methods = {"ref": Params(**EFFORT), "stylit": Params("stylit", error_limit=5)}
    monkeypatch.setitem(
        report_module.PRESETS,
        "quick",
        Preset(methods, few, 3, 1, (("house", "ref"),), ("marker",), ()),
    )


@pytest.fixture
def folder(tiny, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["hauptfleisch", "--output", "report"]) == 0
    return tmp_path / "report"


def test_every_table_picture_and_claim_is_there_and_nothing_is_done_twice(
    folder, monkeypatch, capsys
):
    text = (folder / "report.md").read_text(encoding="utf-8")
    record = json.loads((folder / "report.json").read_text(encoding="utf-8"))
    shown = set(re.findall(r"\(([a-z_0-9]+\.(?:webp|csv))\)", text))
    assert shown == set(record["files"]) - {"report.md", "report.html"}

    house = pd.read_csv(folder / "house.csv")
    assert house["method"].tolist() == ["renderings", *4 * ["ref"]]
    assert house["order"].tolist()[1:] == ["alone", *3 * ["parallel"]]
    assert house["silhouettes"].fillna("").tolist() == [*4 * [""], "no"]
    assert house["of alone"][1] == 1
    assert (house["round"][1:] > 0).all()
    assert "round" not in pd.read_csv(folder / "animation.csv")
    assert not {"outlines", "silhouettes"} & set(pd.read_csv(folder / "sintel.csv"))
    assert (pd.read_csv(folder / "costs.csv")["coherent [s]"] >= 0).all()

    claims = pd.read_csv(folder / "claims.csv")
    assert set(claims["verdict"]) <= {HELD, NOT_HELD, OPEN}
    assert claims["claim"].is_unique
    assert not claims.isna().any(axis=None)
    missing = claims["claim"].str.contains("600x456")
    assert (claims.loc[missing, "verdict"] == OPEN).all()
    assert "Left out: large (build/data/600x456: holds no manifest.json)" in text

    with Image.open(folder / "animation_ref_preview.webp") as preview:
        assert (preview.n_frames, preview.width) == (4, 2 * 44)

    monkeypatch.setattr(eval.runs.local, "compute", None)
    assert main(["hauptfleisch", "--output", "report"]) == 0
    assert "is up to date" in capsys.readouterr().err


def test_without_any_data_it_is_said_what_is_missing(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["hauptfleisch"]) == 2
    error = capsys.readouterr().err
    assert error.count("holds no manifest.json; render it with 'make data'") == 3
    assert "--sintel names no folder" in error
    assert not Path("build").exists()


@pytest.mark.parametrize("preset", PRESETS.values(), ids=PRESETS)
def test_every_setting_that_is_judged_is_run(preset):
    for study, goals in GOALS.items():
        assert {goal.coherence for goal in goals} <= set(preset.ways[study]["ref"])


def test_a_preview_of_a_grid_steps_between_neighbours():
    steps = steps_of(9, is_grid=True)
    assert set(steps) == set(range(9))
    pairs = set(grid_pairs(3, 3))
    assert all(pair in pairs for pair in zip(steps, [*steps[1:], steps[0]], strict=True))
    assert steps_of(4, is_grid=False) == [0, 1, 2, 3, 2, 1]


@pytest.mark.slow
def test_a_long_shot_is_made_by_the_command_and_moves_along(tmp_path):
    effort = "--pyramid-levels", "3", "--search-vote-iters", "2"
    shot = LongShot(5, (40, 60), 3, ("--preset", "fast", *effort))
    scene = tiny_frames("animation", "oil", None, None, None)
    outcome = shot.run(scene, 0)
    assert outcome.image.shape == (4, 40, 60, 3)
    row = outcome.history.iloc[0]
    assert row["coherent"] < 0.9 * row["alone"]
    assert (row > 0).all()


@pytest.fixture
def footage(tmp_path):
    """Two frames whose right half moves by three pixels, over a still left half."""
    first = np.random.default_rng(0).integers(0, 256, (30, 40, 3), dtype=np.uint8)
    second = first.copy()
    second[:, 23:] = first[:, 20:37]
    for name, image in zip(FRAMES, (first, second), strict=True):
        write_image(tmp_path / name, image)
    hidden = np.zeros((30, 40, 1), np.uint8)
    hidden[:, 37:] = 255
    write_image(tmp_path / HIDDEN, hidden)
    flow = np.zeros((30, 40, 2), np.float32)
    flow[:, 20:, 0] = 3
    header = np.array([202021.25], np.float32).tobytes() + np.array([40, 30], np.int32).tobytes()
    (tmp_path / FLOW).write_bytes(header + flow.tobytes())
    return tmp_path


def test_footage_is_read_with_the_way_back(footage):
    found = read_sintel(footage)
    assert found.size == "40x30"
    assert found.style.shape == (30, 40, 3)
    assert warping_error(found.renderings, found.edges, [(0, 1), (1, 0)]) == 0
    assert found.edges[0, 1].visible.sum() == 30 * 37
    assert (found.edges[1, 0].field[:, 23:, 0] == -3).all()
    assert not found.edges[1, 0].visible[:, 20:23].any()


def test_footage_that_lacks_a_file_is_named(footage):
    (footage / HIDDEN).unlink()
    with pytest.raises(InputError, match=f"holds no {HIDDEN}"):
        read_sintel(footage)
