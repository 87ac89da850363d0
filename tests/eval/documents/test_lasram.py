"""The paper's tables and figures on small textures: all exist, and no run is done twice."""

import itertools
import json
import re

import numpy as np
import pandas as pd
import pytest

import eval.documents.lasram.plan as plan_module
import eval.documents.lasram.report as report_module
import eval.runs.local
from eval.__main__ import main
from eval.documents.lasram import overlap, patch_pictures, timing
from eval.documents.lasram.cut_quality import summary
from eval.documents.lasram.plan import Plan
from eval.documents.lasram.presets import Preset
from eval.pages.claims import HELD, NOT_HELD, OPEN


def tiny_plan(name, preset, exemplars, rivals):
    """The plan on two exemplars, S a third as wide."""
    return Plan(name, Preset((0,), (256,), 3, (192, 256)), exemplars[:2], rivals, side=160)


def make_tiny(patch):
    """Let the report take that plan, and holes in one exemplar."""
    patch.setattr(report_module, "Plan", tiny_plan)
    patch.setattr(plan_module, "FILLED", ("bricks",))


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("lasram")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        make_tiny(patch)
        patch.setattr(patch_pictures, "TRIED", 5)
        patch.setattr(timing, "REPEATS", 1)
        assert main(["lasram", "--output", "report"]) == 0
    return folder


@pytest.mark.slow
def test_every_table_and_figure_is_there(folder):
    record = json.loads((folder / "report" / "report.json").read_text(encoding="utf-8"))
    text = (folder / "report" / "report.md").read_text(encoding="utf-8")
    shown = set(re.findall(r"\(([a-z_0-9]+\.(?:webp|csv))\)", text))
    assert shown == set(record["files"]) - {"report.md", "report.html"}
    titles = " ".join(re.findall("^### .*", text, re.MULTILINE))
    assert set(map(int, re.findall(r"\d+", titles))) == {*range(1, 18)} - {4, 8}


@pytest.mark.slow
def test_tables_have_published_and_own_numbers(folder):
    times = pd.read_csv(folder / "report" / "times.csv")
    assert times["paper, an iteration [ms]"].tolist() == [6]
    assert (times[["ours [MB]", "ours, 11 to 16 [ms]"]] > 0).all(axis=None)
    quality = pd.read_csv(folder / "report" / "quality.csv")
    assert quality["method"].tolist() == ["default", "one R", "paper", "image quilting"] * 2
    assert not quality.isna().any(axis=None)
    claims = pd.read_csv(folder / "report" / "claims.csv")
    assert set(claims["verdict"]) <= {HELD, NOT_HELD, OPEN}
    assert claims["rule"].is_unique


@pytest.mark.slow
def test_a_second_time_nothing_is_computed(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    make_tiny(monkeypatch)
    monkeypatch.setattr(eval.runs.local, "compute", None)
    assert main(["lasram", "--output", "report"]) == 0
    assert "is up to date" in capsys.readouterr().err


def test_a_program_that_is_not_there_is_one_sentence(capsys):
    assert main(["lasram", "--gmic", "nowhere"]) == 2
    assert "nowhere: is not a program that can be started" in capsys.readouterr().err


@pytest.mark.slow
def test_no_cut_is_better_than_the_optimum_and_a_second_pass_is_never_worse(folder):
    cuts = pd.read_csv(folder / "report" / "cut_quality.csv")
    assert cuts["trials"].tolist() == [3000] + [3] * 8
    assert (cuts.loc[cuts["laid over"] == "E zero", "optimal cut, mean"] >= 0).all()
    found = cuts[1:].groupby(["weighting", "laid over"])["approximate cut, mean"]
    assert (found.last() <= found.first()).all()
    assert (cuts["approximate cut, mean"] >= cuts["optimal cut, mean"]).all()


@pytest.mark.parametrize(
    ("cut", "optimum", "mean"), [([3, 0], [2, 0], 1.25), ([-3, 4], [-4, 2], 0.625)]
)
def test_ratios_are_of_costs_or_of_gains(cut, optimum, mean):
    found = pd.DataFrame({"first": cut, "optimum": optimum, "rank of first": 1, "all": 9.0})
    assert summary(found, "first")["mean of ratios"] == mean


def costs(seed, height, width):
    along, down = np.random.default_rng(seed).integers(0, 50, (2, height, width)) * 256
    along[:, -1] = down[-1] = 0
    return along, down


@pytest.mark.parametrize("seed", range(4))
def test_a_graph_cut_is_the_cheapest_labelling(seed):
    along, down = costs(seed, 3, 5)
    least = min(
        overlap.border_cost(
            np.column_stack([np.ones(3, bool), np.reshape(inner, (3, 3)), np.zeros(3, bool)]),
            along,
            down,
        )
        for inner in itertools.product((True, False), repeat=9)
    )
    assert overlap.border_cost(overlap.graph_cut(along, down), along, down) == least


@pytest.mark.parametrize("jump", [1, 3])
@pytest.mark.parametrize("seed", range(3))
def test_a_column_cut_is_the_cheapest_path(seed, jump):
    along, down = costs(seed, 4, 5)
    paths = [
        np.array(path)
        for path in itertools.product(range(4), repeat=4)
        if np.abs(np.diff(path)).max() <= jump
    ]
    least = min(overlap.border_cost(np.arange(5) <= path[:, None], along, down) for path in paths)
    found = overlap.column_cut(along, down, jump)
    assert overlap.border_cost(found, along, down) == least


def test_pictures_that_are_alike_have_no_errors():
    image = np.random.default_rng(1).integers(0, 256, (6, 7, 3), dtype=np.uint8)
    assert not np.any(overlap.edge_costs(image, image))
