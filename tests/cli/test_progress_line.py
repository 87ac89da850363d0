"""The line that shows how far a run is."""

import re

from cli.calls import run


def test_progress_shows_the_energy(scene, monkeypatch, capfd):
    folder = scene[0]
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    assert run(folder) == 0
    last = capfd.readouterr().err.strip().split("\r")[-1]
    assert re.search(r"100%.*level 2/2  φ \d+ = δ \d+ \+ λρ \d+", last)


def test_progress_shows_the_share_that_is_fixed(scene, monkeypatch, capfd):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    assert run(scene[0], "--method", "stylit") == 0
    last = capfd.readouterr().err.strip().split("\r")[-1]
    assert re.search(r"100%.*level 2/2  δ \d+  retrieval \d+: \d+% fixed", last)
