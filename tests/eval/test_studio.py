"""What measures the studio."""

import os
import subprocess
import sys

import numpy as np
import pandas as pd
import pytest
from chromium_browser import chromium_browser

from eval.__main__ import main
from eval.reports.studio import latency_summary
from eval.studio.browser import Browser
from eval.studio.hand import curve
from eval.studio.memory import PARTS, growth, memory
from eval.studio.resident import children, mebibytes
from eval.studio.server import Server, serve
from stylit_ref import InputError

MINUTES = float(os.environ.get("STYLIT_STUDIO_MINUTES", 1 / 3))


def test_memory_of_a_process_is_what_it_holds():
    held = 64 * 2**20
    hold = f"pixels = b'x' * {held}; print(flush=True); input()"
    with subprocess.Popen(
        [sys.executable, "-c", hold], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as process:
        process.stdout.readline()
        assert process.pid in children(os.getpid())
        assert 64 < mebibytes(process.pid) < 128
        process.communicate(b"\n")
    assert mebibytes(process.pid) == 0
    assert children(process.pid) == []


def test_a_studio_that_has_ended_is_no_studio_without_memory():
    with subprocess.Popen([sys.executable, "-c", "raise SystemExit(7)"]) as ended:
        ended.wait()
    with pytest.raises(InputError, match="has ended by itself, with the code 7"):
        Server(ended, "http://127.0.0.1:1/").mebibytes()


def test_strokes_stay_in_their_box_and_go_somewhere():
    rng = np.random.default_rng(0)
    for _ in range(50):
        places = np.array(curve(rng, (100, 20, 300, 620), 12))
        assert places.shape == (12, 2)
        assert (places >= (120, 80)).all()
        assert (places <= (280, 560)).all()
        assert np.ptp(places, axis=0).max() > 2


def test_growth_is_that_between_two_minutes():
    frame = pd.DataFrame({"minute": [1.0, 10.2, 59.9], "page": [50.0, 200.0, 210.0]})
    assert growth(frame, "page") == pytest.approx(0.05)
    assert growth(frame, "page", 1, 10) == pytest.approx(3)


def test_latencies_are_summarized_by_picture():
    frame = pd.DataFrame(
        {"which": ["replay"] * 101 + ["coherent"], "milliseconds": [*range(101), 7.0]}
    )
    summary = latency_summary(frame).set_index("picture")
    assert list(summary.loc["replay"]) == [101, 50, 95, 100]
    assert list(summary.loc["coherent"]) == [1, 7, 7, 7]


def test_without_a_browser_one_sentence_says_so(tmp_path, monkeypatch, capsys):
    pytest.importorskip("playwright.sync_api")
    monkeypatch.setenv("PATH", str(tmp_path))
    processors = os.sched_getaffinity(0)
    assert main(["studio", "--output", str(tmp_path / "report")]) == 2
    assert capsys.readouterr().err == (
        "eval: there is no Chromium; install it (Debian: apt install chromium)\n"
    )
    assert os.sched_getaffinity(0) == processors
    assert not (tmp_path / "report").exists()


@pytest.mark.slow
def test_memory_stays_while_somebody_paints(tmp_path):
    """A picture that were kept for each stroke would double it in this time."""
    with (
        chromium_browser() as chromium,
        serve(tmp_path / "painting") as server,
        Browser(chromium).page(server.address) as page,
    ):
        browser = Browser(chromium)
        frame = memory(browser, server, page, MINUTES, np.random.default_rng(0))
    first, last = frame["minute"].iloc[[0, -1]]
    grown = {part: growth(frame, part, first, last) for part in (*PARTS, "heap")}
    assert len(frame) >= 3
    assert frame["deeds"].min() > 0
    assert grown["heap"] < 0.5
    assert grown["page"] < 0.25
    assert grown["server"] < 0.5
