"""The report stylit on a tiny scene."""

import re

import pandas as pd
import pytest

from eval.__main__ import main


@pytest.mark.slow
def test_stylit_report(folder):
    assert main(["stylit", "--scene", str(folder), "--numbers"]) == 0
    report = folder.parent / "build" / "reports" / "stylit_small_44x38"
    numbers = pd.read_csv(report / "stylit.csv").set_index("method")
    assert numbers.loc["StyLit", "distinct"] > numbers.loc["ref, λ = 0", "distinct"]
    page = (report / "report.md").read_text(encoding="utf-8")
    assert re.search(r"\| 3 +\|( \d+ \(\d+\.\d%\) +\|){6}", page)
    assert not (report / "stylit.webp").exists()
