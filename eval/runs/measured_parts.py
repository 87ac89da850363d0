"""Time a part of a run in a process of its own, so that any version of the library can be timed.

Usage: ``measured_parts.py PART TASK``; prints seconds. ``TASK`` is JSON: the files ``style`` and
``pairs``, and the ``params`` of the run. Kernels are compiled before.
"""

import json
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

from stylit_ref import Params, read_uint8, stylize, write_image
from stylit_ref.passes.pyramid import downsample

HALVINGS = 12


def synthesis(style, sources, targets, params):
    """Style and guides in memory to a picture."""
    stylize(style, sources, targets, params)
    start = perf_counter()
    stylize(style, sources, targets, params)
    return perf_counter() - start


def halving(style, *_):
    """As many halvings of a picture as a run with seven guides makes at most."""
    downsample(style)
    start = perf_counter()
    for _ in range(HALVINGS):
        downsample(style)
    return perf_counter() - start


def writing(style, *_):
    """A PNG."""
    with TemporaryDirectory() as folder:
        start = perf_counter()
        write_image(Path(folder) / "style.png", style)
        return perf_counter() - start


def main(part, task):
    """Read, and time what is asked for."""
    task = json.loads(task)
    style = read_uint8(task["style"])
    start = perf_counter()
    sources, targets = zip(*[map(read_uint8, pair) for pair in task["pairs"]], strict=True)
    if part == "reading":
        return (perf_counter() - start) / 2  # of one side's
    return {"synthesis": synthesis, "halving": halving, "writing": writing}[part](
        style, sources, targets, Params(**task["params"])
    )


if __name__ == "__main__":
    print(main(*sys.argv[1:]))
