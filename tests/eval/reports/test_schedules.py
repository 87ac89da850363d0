"""The report schedules on a tiny scene."""

import pandas as pd
import pytest

from eval.__main__ import main
from eval.reports.schedules import schedule_ratios


@pytest.mark.slow
def test_schedules_report(folder):
    arguments = ["--uniformities", "0", "50000", "--seeds", "0", "1"]
    assert main(["schedules", "--scene", str(folder), *arguments]) == 0
    report = folder.parent / "build" / "reports" / "schedules_small_44x38"
    numbers = pd.read_csv(report / "schedules.csv")
    assert list(numbers["λ"]) == [0, 0, 50000, 50000]
    assert list(numbers["schedule"]) == ["scanline", "propose_commit"] * 2
    assert (report / "schedules.webp").exists()


def test_ratios_judge_each_bar():
    columns = ["phi", "delta", "image_energy", "distinct", "distinct_in_image"]
    columns += ["sharpness", "richness"]
    rows = []
    for uniformity, phi, distinct in (("0", 1.019, 1.0), ("1", 1.021, 1.1), ("2", 0.9, 0.99)):
        rows.append({"λ": uniformity, "schedule": "scanline"} | dict.fromkeys(columns, 1.0))
        rows.append({**rows[-1], "schedule": "propose_commit", "phi": phi, "distinct": distinct})
    ratios = schedule_ratios(pd.DataFrame(rows))
    assert list(ratios["φ, δ within"]) == ["yes", "no", "yes"]
    assert list(ratios["usage, sharpness kept"]) == ["yes", "yes", "no"]
