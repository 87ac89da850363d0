"""The report levels on a tiny scene."""

import pandas as pd
import pytest

from eval.__main__ import main
from eval.reports import levels as report_on_levels
from eval.scenes import BUNDLED


@pytest.mark.slow
def test_levels_report(layers, tmp_path, monkeypatch):
    monkeypatch.setattr(report_on_levels, "SHOWN", ("teapot/oil",))
    assert main(["levels", "--data", str(layers), "--seed", "3"]) == 0
    report = tmp_path / "build" / "reports" / "levels"
    numbers = pd.read_csv(report / "levels.csv")
    fast = numbers[numbers["effort"] == "fast"]
    assert list(fast["levels"]) == 4 * [1, 2, 3]
    assert set(fast["guides"]) == {"light", "light, ID", "alike", "alike, ID"}
    assert set(numbers["effort"]) == {"fast", "thesis"}
    guided = fast["guides"].str.endswith("ID")
    assert fast[guided]["spilled"].mean() < fast[~guided]["spilled"].mean()
    assert (report / "levels_50x38.webp").exists()
    assert "over one fewer" in (report / "report.md").read_text()


def test_scenes_without_layers_are_refused(capsys):
    assert main(["levels", "--data", str(BUNDLED), "--scene", "teapot/oil"]) == 2
    assert "does not list source/passes.exr" in capsys.readouterr().err
