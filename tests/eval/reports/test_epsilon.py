"""The report epsilon on a tiny scene."""

import numpy as np
import pandas as pd
import pytest

from eval.__main__ import main


@pytest.mark.slow
def test_epsilon_report(folder, monkeypatch):
    monkeypatch.setattr("eval.reports.epsilon.EPSILONS", (100, 10000))
    monkeypatch.setattr("eval.reports.epsilon.MAPS_SHOWN", (100,))
    assert main(["epsilon", "--scene", str(folder)]) == 0
    report = folder.parent / "build" / "reports" / "epsilon_small_44x38"
    numbers = pd.read_csv(report / "epsilon.csv").set_index("method")
    assert list(numbers.index) == [
        "ref", "ref, another seed", "ε = 0", "ε = 0.001", "ε = 100", "ε = 10000", "ε = 50000",
    ]  # fmt: skip
    assert numbers.loc["ε = 0", "SSIM"] == 1
    assert np.isinf(numbers.loc["ε = 0", "PSNR"])
    assert numbers["white"].dropna().tolist()[::4] == ["0.0%", "100.0%"]
    costs = pd.read_csv(report / "costs.csv")
    assert costs["method"].tolist()[0] == "ref"
    assert (costs[["with the bound", "without"]] > 0).all(axis=None)
    assert "byte for byte" in (report / "report.md").read_text(encoding="utf-8")
    assert (report / "epsilon.webp").exists()
