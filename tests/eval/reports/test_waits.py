"""The report waits on a tiny scene, this version beside itself."""

from pathlib import Path

import pandas as pd
import pytest

from eval.__main__ import main
from eval.reports import waits

ROOT = Path(waits.__file__).parents[2]


@pytest.mark.slow
def test_both_versions_are_measured(folder, monkeypatch, capsys):
    for name in ("SMALL", "BUSY", "HUGE"):
        monkeypatch.setattr(waits, name, (38, 44))
    monkeypatch.setattr(waits, "BESIDE", 1)
    monkeypatch.setattr(waits, "WAITS", tuple(wait._replace(runs=1) for wait in waits.WAITS))
    names = "fast", "busy", "huge", "memory", "small", "files"
    command = ["waits", "--scene", str(folder), "--before", str(ROOT), "--waits", ",".join(names)]
    assert main(command) == 0
    table = pd.read_csv(folder.parent / "build" / "reports" / "waits_small_44x38" / "waits.csv")
    assert list(table.columns) == ["wait", "before", "now", "goal"]
    assert (table[["before", "now"]] > 0).all(axis=None)
    assert (table["wait"] == [wait.told for wait in waits.WAITS if wait.name in names]).all()
    assert "| `--preset fast`, the whole process [s]" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--waits", "fast,lunch"], "--waits: there is no lunch"),
        (["--before", "."], "--before: . is no checkout: it has no stylit_ref"),
    ],
    ids=["waits", "before"],
)
def test_bad_input(folder, capsys, options, message):
    assert main(["waits", "--scene", str(folder), *options]) == 2
    assert message in capsys.readouterr().err
