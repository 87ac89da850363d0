"""Measure the studio in a browser: how soon paint is shown, how soon it starts, its memory.

A hand that is led by a seed paints on the page in Chromium, as a person would with a mouse; the
server is the command's. It needs Chromium, and Playwright of the extra "test".
"""

import os
import tempfile
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from tqdm import tqdm

from eval.pages import options as shared
from eval.pages.claims import OPEN, verdict
from eval.pages.page import new_report, shown
from eval.pages.tables import table
from eval.provenance import provenance
from eval.studio.browser import open_browser
from eval.studio.latency import latencies
from eval.studio.memory import EARLY, LATE, PARTS, growth, memory
from eval.studio.server import serve
from eval.studio.start import start_times
from stylit_ref import InputError

STROKES = 200
STARTS = 5
PROCESSORS = 2
"""All programs together may use so many."""

_MOST_GROWTH = 0.05
_ASKED = {"replay": 50, "coherent": 100}
"""Milliseconds that 95 of 100 may take."""


def add_options(parser):
    """Declare what the report may be told."""
    parser.add_argument(
        "--parts", nargs="+", choices=_PARTS, default=list(_PARTS), metavar="PART",
        help=f"what to measure, of {', '.join(_PARTS)} (default: all)",
    )  # fmt: skip
    parser.add_argument(
        "--minutes", type=float, default=3,
        help="how long to paint for the memory; an hour is asked (default 3)",
    )  # fmt: skip
    parser.add_argument(
        "--strokes", type=int, default=STROKES,
        help=f"strokes that are timed (default {STROKES})",
    )  # fmt: skip
    parser.add_argument(
        "--starts", type=int, default=STARTS,
        help=f"starts with either kind of kernels, whose medians count (default {STARTS})",
    )  # fmt: skip
    shared.add_seed(parser)
    shared.add_output(parser, "studio")


def main(options):
    """Make the report; returns the exit code."""
    if not hasattr(os, "sched_setaffinity"):
        raise InputError("the studio's processes can only be measured on Linux")
    if options.minutes <= 0 or min(options.strokes, options.starts) < 1:
        raise InputError("--minutes must be above 0, --strokes and --starts at least 1")
    folder = shared.folder_of(options, "studio")
    with (
        _few_processors() as processors,
        open_browser() as browser,
        tempfile.TemporaryDirectory() as workplace,
    ):
        parts = [
            _PARTS[part](browser, Path(workplace) / part, options)
            for part in _PARTS
            if part in options.parts
        ]
        name = browser.name
    with new_report(folder) as report:
        verdicts = pd.concat([verdicts for verdicts, _ in parts])
        sections = [
            provenance(),
            f"{name}, a window of 1280x800 without a screen; browser, server and the program that "
            f"leads the hand share {processors} processors. "
            f"Scene: the bundled turntable, 500x500.",
            report.table("verdicts", verdicts, verdicts),
        ]
        for _, write in parts:
            sections += write(report)
        report.page("The studio, measured", sections)
    return shown(folder)


@contextmanager
def _few_processors():
    """Use so many at most, and have all programs that are started do so; yields how many."""
    processors = os.sched_getaffinity(0)
    used = sorted(processors)[:PROCESSORS]
    os.sched_setaffinity(0, used)
    try:
        yield len(used)
    finally:
        os.sched_setaffinity(0, processors)


def _latency(browser, folder, options):
    rng = np.random.default_rng(options.seed)
    with (
        serve(folder) as server,
        browser.page(server.address) as page,
        tqdm(total=options.strokes, unit="stroke", disable=None) as bar,
    ):
        frame = latencies(page, options.strokes, rng, bar.update)
    summary = latency_summary(frame)
    verdicts = _verdicts(
        (
            f"{row.picture}: 95 of 100 within",
            f"{_ASKED[row.picture]} ms",
            f"{row._4:.0f} ms",
            verdict(row._4 <= _ASKED[row.picture]),
        )
        for row in summary.itertuples()
    )

    def write(report):
        return [
            "## From the hand to the frame",
            f"{options.strokes} strokes with brushes of all kinds, 60 places of the mouse a "
            "second. Each begins while `fast` is being made, which it cancels. *replay*: from the "
            "event of the pointer to the first frame that is painted with a picture that shows it. "
            "*coherent*: from the end of the pause of 80 ms, or from lifting the brush, to the "
            "frame with the picture that is searched anew. The page takes these times itself.",
            table(_rounded(summary, "{:.1f}")),
            report.csv("latency", frame),
            report.figure("latency", "Times from the hand to the frame", _draw_latency, frame),
        ]

    return verdicts, write


def latency_summary(frame):
    """Median, 95th percentile and worst of each kind of picture.

    Parameters
    ----------
    frame : pandas.DataFrame
        As :func:`eval.studio.latency.latencies` gives it.

    Returns
    -------
    pandas.DataFrame
    """
    rows = [
        {
            "picture": which,
            "times": len(times),
            "median [ms]": times.median(),
            "95 of 100 [ms]": times.quantile(0.95),
            "worst [ms]": times.max(),
        }
        for which in _ASKED
        if len(times := frame.loc[frame["which"] == which, "milliseconds"])
    ]
    return pd.DataFrame(rows)


def _start(browser, folder, options):
    folder.mkdir()
    rows, last = [], options.starts - 1
    for kind in ("cold", "warm"):
        for number in tqdm(
            range(options.starts), desc=f"{kind} kernels", unit="start", disable=None
        ):
            kernels = folder / f"kernels_{number if kind == 'cold' else last}"
            fills = kind == "cold" and number == last
            painting = folder / f"{kind}_{number}"
            rows.append((kind, *start_times(browser, painting, kernels, fills=fills)))
    frame = pd.DataFrame(rows, columns=["kernels", "page [s]", "picture [s]"])
    middle = frame.groupby("kernels").median()
    page, cold, warm = (
        frame["page [s]"].median(), middle["picture [s]"]["cold"], middle["picture [s]"]["warm"],
    )  # fmt: skip
    verdicts = _verdicts(
        (what, f"{asked} s", f"{seconds:.1f} s", verdict(seconds <= asked))
        for what, asked, seconds in (
            ("a page to paint on", 2, page),
            ("the first picture, cold kernels", 12, cold),
            ("the first picture, warm kernels", 3, warm),
        )
    )

    def write(report):
        return [
            "## The start",
            f"Seconds from the command's start, with a browser that is open already; medians of "
            f"{options.starts} for either kind of kernels. Cold: each start compiles into an empty "
            "folder. Warm: all start with what the last of those has compiled.",
            report.table("start", frame, _rounded(frame, "{:.2f}")),
        ]

    return verdicts, write


def _memory(browser, folder, options):
    rng = np.random.default_rng(options.seed)
    with serve(folder) as server, browser.page(server.address) as page:
        frame = memory(browser, server, page, options.minutes, rng, tell=tqdm.write)
    is_whole = frame["minute"].iloc[-1] >= LATE
    early, late = (EARLY, LATE) if is_whole else frame["minute"].iloc[[0, -1]]
    grown = {part: growth(frame, part, early, late) for part in PARTS}
    when = f"minute {late:.3g} over minute {early:.3g}"
    verdicts = _verdicts(
        (
            f"memory of {PARTS[part]}, {when}",
            f"{_MOST_GROWTH:+.0%}" + " in an hour" * (not is_whole),
            f"{grown[part]:+.1%}",
            verdict(grown[part] <= _MOST_GROWTH) if is_whole else OPEN,
        )
        for part in PARTS
    )

    def write(report):
        return [
            "## Memory",
            "Strokes of all tools, undo and redo, turns, other scenes, looks, sliders, the full "
            "method, pauses. At the end of each minute the first scene is chosen again; when all "
            "rests, resident memory is read (MiB). The page: all processes of Chromium that show "
            "pages; of these the heap of the page's program after a forced collection of garbage. "
            "What needs kernels of its own, such as another patch width, is not touched: compiled "
            "kernels stay in memory, each once.",
            report.table("memory", frame, _rounded(frame, "{:.1f}")),
            report.figure("memory", "Resident memory by minute", _draw_memory, frame),
        ]

    return verdicts, write


_PARTS = {"latency": _latency, "start": _start, "memory": _memory}


def _verdicts(rows):
    return pd.DataFrame(rows, columns=["what", "asked", "measured", "verdict"])


def _rounded(frame, form):
    text = frame.copy()
    for column in frame.select_dtypes("float"):
        text[column] = frame[column].map(form.format)
    return text


def _draw_latency(frame, file):
    figure = Figure(figsize=(9, 3.2), layout="constrained")
    for axes, (which, asked) in zip(figure.subplots(1, 2), _ASKED.items(), strict=True):
        axes.hist(frame.loc[frame["which"] == which, "milliseconds"], bins=60)
        axes.axvline(asked, color="black", linestyle="--", label=f"asked: {asked} ms")
        axes.set(title=which, xlabel="ms", ylabel="times", xlim=(0, None))
        axes.legend()
    figure.savefig(file, dpi=100)


def _draw_memory(frame, file):
    figure = Figure(figsize=(9, 3.6), layout="constrained")
    axes = figure.subplots()
    for part, words in PARTS.items():
        axes.plot(frame["minute"], frame[part], label=words)
    axes.set(xlabel="minutes of painting", ylabel="MiB", xlim=(0, None), ylim=(0, None))
    axes.legend()
    figure.savefig(file, dpi=100)
