"""The report spilling on a tiny scene."""

import pandas as pd
import pytest

from eval.__main__ import main


@pytest.mark.slow
def test_spilling_report(data, tmp_path):
    assert main(["spilling", "--data", str(data), "--scene", "teapot/oil,teapot/pen"]) == 0
    report = tmp_path / "build" / "reports" / "spilling_small"
    numbers = pd.read_csv(report / "spilling.csv")
    spilled = numbers.drop(columns="scene").map(lambda text: float(text[:-1]))
    assert (spilled["ref with the ID guide"] < spilled["ref"]).all()
    assert spilled.shape == (2, 4)
    assert (report / "spilling.webp").exists()
