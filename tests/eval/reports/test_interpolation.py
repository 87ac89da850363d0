"""The report on views between others, on a small grid."""

import pandas as pd
import pytest
from small_run import cameras_of_grid, write_run

from eval import between_views
from eval.__main__ import main

GRID = {"cameras": cameras_of_grid((-10, 0, 10), (10, 15, 20)), "grid": (3, 3)}


def test_every_mode_is_measured(tmp_path, monkeypatch):
    monkeypatch.setattr(between_views, "STEP", 2.0)
    run = write_run(tmp_path / "run", **GRID)
    out = tmp_path / "report"
    code = main(["interpolation", "--run", str(run.folder), "--output", str(out)])
    assert code == 0
    path = pd.read_csv(out / "path.csv").set_index("mode")
    assert path.index.tolist() == ["limited", "linear", "image", "blend", "nnf", "fade"]
    assert path.loc["fade", "switch"] < path.loc["limited", "switch"]
    assert (path.loc["limited", "least"], path.loc["limited", "ratio"] > 1) == (1, True)
    middle = pd.read_csv(out / "middle.csv").set_index("mode")
    assert middle.loc["limited, thesis' masks", "outlines"] >= 0
    left_out = pd.read_csv(out / "left_out.csv").set_index("mode")
    assert left_out.loc["limited", "degrees"] == pytest.approx(20)
    text = (out / "report.md").read_text()
    assert "Figure 3.8" in text
    assert "Figure 3.7" not in text


def test_a_grid_that_is_too_small_is_refused(tmp_path, capsys):
    run = write_run(tmp_path / "run")
    assert main(["interpolation", "--run", str(run.folder), "--output", str(tmp_path / "r")]) == 2
    assert "is no grid of at least 3x3 views that holds a mesh" in capsys.readouterr().err
