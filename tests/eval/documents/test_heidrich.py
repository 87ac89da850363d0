"""The thesis' tables and figures on small pictures: all exist, and no run is done twice."""

import json
import re
from functools import cache

import numpy as np
import pandas as pd
import pytest
from skimage.io import imsave

import eval.documents.heidrich.report as report_module
import eval.runs.local
from data_gen.manifest import Manifest
from data_gen.multilayer_exr import write_layers
from eval.__main__ import main
from eval.documents.heidrich import stage
from eval.documents.heidrich.busy import BesideOthers, Busy
from eval.documents.heidrich.places import densest
from eval.documents.heidrich.plan import LEFT_OUT, METHODS, STYLES, Plan, Preset
from eval.documents.heidrich.printed import TABLE_1, milliseconds
from eval.documents.heidrich.reach import reach
from eval.documents.heidrich.turning import turning
from eval.methods.realtime import of_every_pixel
from eval.pages.claims import HELD, NOT_HELD, OPEN
from eval.scenes import LIGHT_PASSES
from stylit_ref import InputError


@cache
def small(style):
    """The stage, 80 pixels along."""
    return stage.enlarged(stage.bundled(style), 80)


def tiny_plan(name, preset, shown, timed, large, turning, asides):
    """The plan on small pictures; frames are timed on a hundredth of their pixels."""
    return Plan(
        name,
        Preset(("oil",), 1, 1, 1, widths=(3, 5), depths=(2, 3)),  # others take long to compile
        small,
        lambda side: stage.enlarged(small("oil"), side // 10),
        large=lambda style: stage.enlarged(small(style), 120),
        asides=(Busy(small("oil"), BesideOthers(seconds=0.2, trials=1)),),
    )


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("heidrich")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setattr(report_module, "Plan", tiny_plan)
        assert main(["heidrich", "--output", "report"]) == 0
    return folder


@pytest.mark.slow
def test_every_table_and_figure_is_there(folder):
    record = json.loads((folder / "report" / "report.json").read_text(encoding="utf-8"))
    text = (folder / "report" / "report.md").read_text(encoding="utf-8")
    shown = set(re.findall(r"\(([a-z_0-9]+\.(?:webp|csv))\)", text))
    assert shown == set(record["files"]) - {"report.md", "report.html"}
    titles = " ".join(re.findall("^### .*", text, re.MULTILINE))
    assert set(map(int, re.findall(r"\((\d+)\)", titles))) == set(range(21, 29))


@pytest.mark.slow
def test_tables_have_published_and_own_numbers(folder):
    times = pd.read_csv(folder / "report" / "table_1.csv")
    cited = times[times["with rendering"] == "yes"]
    assert cited["thesis [ms]"].tolist() == [49.87, 21.69, 146.75, 47.93]
    assert cited["ours [fps]"].isna().all()
    assert (times.loc[times["with rendering"] == "no", "ours, one thread [ms]"] > 0).all()
    quality = pd.read_csv(folder / "report" / "quality.csv")
    assert quality["method"].tolist() == [*METHODS] * len(STYLES)
    assert (quality["image_energy"] > 0).all()
    assert len(pd.read_csv(folder / "report" / "ablation.csv")) == len(LEFT_OUT) == 8
    required = pd.read_csv(folder / "report" / "requirements.csv")
    assert required["method"].tolist() == [*METHODS]


@pytest.mark.slow
def test_every_claim_has_a_rule_and_a_verdict(folder):
    claims = pd.read_csv(folder / "report" / "claims.csv")
    assert set(claims["verdict"]) <= {HELD, NOT_HELD, OPEN}
    assert claims["claim"].is_unique
    assert not claims.isna().any(axis=None)


@pytest.mark.slow
def test_a_saving_that_reads_less_changes_no_picture(folder):
    """Terms without weight are read or not; the picture is the same."""
    table = pd.read_csv(folder / "report" / "ablation.csv", keep_default_na=False)
    energy = table.set_index("left out")["energy"]
    assert energy["unread terms"] == energy["nothing"]
    assert energy["packing, unread terms"] == energy["packing"]


@pytest.mark.slow
def test_a_second_time_nothing_is_computed(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    monkeypatch.setattr(report_module, "Plan", tiny_plan)
    monkeypatch.setattr(eval.runs.local, "compute", None)
    assert main(["heidrich", "--output", "report"]) == 0
    assert "is up to date" in capsys.readouterr().err


def test_the_printed_times_are_those_of_the_thesis():
    assert milliseconds("optimized", 1000) == 43.01
    assert milliseconds("simple", 500) == 45.81
    assert (abs(1000 / TABLE_1["ms_per_frame"] - TABLE_1["fps"]) < 0.02).all()


@pytest.mark.parametrize(
    ("means", "depth", "width"), [("box", 1, 1), ("box", 3, 9), ("box", 4, 27), ("mip", 3, 4)]
)
def test_scales_reach_as_far_as_their_means(means, depth, width):
    assert reach(means, depth) == width


def test_a_pixel_lies_in_the_patch_of_its_nearest_entry():
    entries = np.array([[[9, 9], [20, 5]], [[30, 7], [3, 40]]], np.int32)
    nnf = of_every_pixel(entries, 3, (5, 4), (50, 50))
    for y in range(5):
        for x in range(4):
            row, column = min(1, (y + 1) // 3), min(1, (x + 1) // 3)
            expected = entries[row, column] + (y - 3 * row, x - 3 * column)
            assert nnf[y, x].tolist() == expected.tolist()


def test_the_densest_window_is_that_of_brute_force():
    weights = np.random.default_rng(2).integers(0, 9, (70, 90))
    window = densest(weights)
    sums = {
        (y, x): weights[y : y + 64, x : x + 64].sum() for y in range(7) for x in range(27)
    }  # fmt: skip
    assert weights[window].sum() == max(sums.values())


def test_an_enlarged_scene_repeats_its_pixels():
    scene = stage.enlarged(small("oil"), 160)
    assert scene.size == "160x160"
    assert np.array_equal(scene.style[::2, ::2], small("oil").style)
    assert all(a.shape == b.shape == (160, 160, a.shape[2]) for a, b in scene.buffers.values())


def test_a_size_that_cannot_be_rendered_is_one_sentence(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "build/data/48x48").mkdir(parents=True)
    (tmp_path / "build/data/48x48/notes.txt").write_text("mine")
    with pytest.raises(InputError, match="holds files but no manifest"):
        stage.rendered("oil", 48)


@pytest.fixture
def turning_data(tmp_path):
    """A data set of which the target "turns" by moving 6 pixels to the right, twice."""
    manifest = Manifest(tmp_path, {}, {})
    golem = small("oil")

    def save(piece, side, moved=0):
        folder = tmp_path / piece
        folder.mkdir(parents=True)
        for name in {*LIGHT_PASSES, *golem.buffers}:
            image = golem.buffers.get(name, golem.buffers["FULL"])[side]
            image = np.roll(image, moved, axis=1).squeeze()
            imsave(folder / f"{name}.png", image, check_contrast=False)
        return folder

    (save("source", 0) / "styles").mkdir()
    imsave(tmp_path / "source" / "styles" / "oil.png", golem.style, check_contrast=False)
    motion = np.zeros((80, 80, 2), np.float32)
    motion[..., 0] = 6
    visible = np.zeros((80, 80, 1), np.float32)
    visible[:, :-6] = 1
    (tmp_path / "turning" / "motion").mkdir(parents=True)
    for frame in range(3):
        save(f"turning/{frame:02}", 1, 6 * frame)
        layers = {"MOTION": motion, "VISIBLE": visible}
        write_layers(tmp_path / "turning" / "motion" / f"{frame:02}_to_{frame + 1:02}.exr", layers)
    for piece in ("source", "turning/00", "turning/01", "turning/02", "turning/motion"):
        manifest.add(piece)
    return tmp_path


def test_a_turning_target_is_stylized_warm_and_cold(turning_data):
    job = turning(turning_data, "oil", ("quick",))
    history = job.method.run(job.scene, 0).history.set_index("frames")
    assert list(history.index) == ["cold", "warm", "the first, kept"]
    assert history.loc["cold", "rise"] == 1
    assert history.loc["the first, kept", "rise"] > history.loc["warm", "rise"]
    assert history.loc["cold", "flicker"] > 0


def test_a_turning_target_is_another_run_with_other_motion(turning_data):
    before = turning(turning_data, "oil", ("quick",)).key
    manifest = Manifest.read(turning_data)
    manifest.pieces["turning/motion"]["turning/motion/00_to_01.exr"] = "0" * 64
    manifest.save()
    assert turning(turning_data, "oil", ("quick",)).key != before
