"""Chapters 4 and 5 of the thesis again, on our scenes: every table, figure and claim."""

import sys
from pathlib import Path

from eval.documents.dzurenko.page import write_page
from eval.documents.dzurenko.plan import PRESETS, own_scene, preset
from eval.pages.options import add_output, folder_of
from eval.runs.complete import complete
from stylit_ref import InputError
from stylit_ref.stylization.backends import BACKENDS


def add_options(parser):
    """Declare what the report may be told."""
    parser.add_argument(
        "--preset", choices=PRESETS,
        help="bundled scenes, or all of 'make data' at 1200x912 (default quick)",
    )  # fmt: skip
    parser.add_argument("--data", help="folder of another data set than the preset's")
    parser.add_argument("--targets", help="of the preset, commas between (default: all seven)")
    parser.add_argument("--step", type=int, help="keep every STEPth pixel of the preset")
    parser.add_argument("--scene", help="a folder of yours, in the place of a preset")
    parser.add_argument(
        "--style", type=Path, help="painting in the place of the folder's source_style"
    )
    parser.add_argument(
        "--seeds", type=int, nargs="+", help="default: 0, and 1 and 2 of one target"
    )
    parser.add_argument(
        "--backend",
        choices=[name for name in BACKENDS if name != "auto"],
        default="cpu",
        help="results are kept by the device they are of, so there is no auto (default cpu)",
    )
    parser.add_argument("--scheduler", help="address of a Dask cluster")
    add_output(parser, "PRESET")


def main(options):
    """Do the runs and make the report; returns the exit code."""
    plan = _plan(options)
    folder = folder_of(options, plan.name)
    failures = complete(plan.tasks, plan.scheduler)
    for title, reason in failures.items():
        print(f"eval: failed: {title}: {reason}", file=sys.stderr)
    if failures:
        count = len(plan.tasks) - len(failures)
        print(f"eval: {count} runs are kept; no report without the others", file=sys.stderr)
        return 1
    if not write_page(plan, folder):
        print(f"eval: {folder} is up to date", file=sys.stderr)
    print(f"Written: {folder / 'report.html'}")
    return 0


def _plan(options):
    """The plan that is asked for."""
    where = {"backend": options.backend, "scheduler": options.scheduler}
    if options.scene:
        of_preset = ("preset", "data", "targets", "step")
        for name in of_preset:
            if getattr(options, name) is not None:
                raise InputError(f"--{name} is for a preset; leave it out, or --scene")
        return own_scene(options.scene, options.style, options.seeds, **where)
    if options.style:
        raise InputError("--style is for a scene of yours; give its folder with --scene")
    targets = options.targets.split(",") if options.targets else None
    step = 1 if options.step is None else options.step
    return preset(options.preset or "quick", options.data, targets, step, options.seeds, **where)
