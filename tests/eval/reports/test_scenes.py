"""The report scenes on a tiny scene."""

import pandas as pd
import pytest

from eval.__main__ import main


@pytest.mark.slow
def test_scenes_report(data, tmp_path):
    assert main(["scenes", "--data", str(data)]) == 0
    report = tmp_path / "build" / "reports" / "scenes_small"
    assert {file.name for file in report.iterdir()} == {
        "passes.webp", "styles.webp", "stylized.webp", "scenes.csv", "report.md", "report.html",
        "report.json",
    }  # fmt: skip
    assert len(pd.read_csv(report / "scenes.csv")) == 4
