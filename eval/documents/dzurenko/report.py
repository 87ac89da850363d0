"""Repeat chapters 4 and 5 of the thesis on our scenes: every table, figure and claim."""

from pathlib import Path

from eval.documents.dzurenko.page import document
from eval.documents.dzurenko.plan import PRESETS, own_scene, preset
from eval.pages.document import make_documents
from eval.pages.options import add_output, folder_of
from stylit_ref import InputError
from stylit_ref.stylization.backends import BACKENDS


def add_options(parser):
    """Declare what the report may be told."""
    parser.add_argument(
        "--preset", choices=PRESETS,
        help="quick: the bundled scenes; thesis: those of 'make data' at 1200x912 (default quick)",
    )  # fmt: skip
    parser.add_argument("--data", help="folder of the data set, in place of the preset's")
    parser.add_argument(
        "--targets", help="targets of the preset, commas between (default: all seven)"
    )
    parser.add_argument("--step", type=int, help="keep only every STEPth row and column")
    parser.add_argument("--scene", help="folder of your own scene, in place of a preset")
    parser.add_argument(
        "--style", type=Path, help="with --scene: a painting in place of its source_style"
    )
    parser.add_argument(
        "--seeds", type=int, nargs="+",
        help="seeds of every target (default: 0, and for one target also 1 and 2)",
    )  # fmt: skip
    parser.add_argument(
        "--backend",
        choices=[name for name in BACKENDS if name != "auto"],
        default="cpu",
        help="where to run; there is no auto, since results are stored by device (default cpu)",
    )
    parser.add_argument(
        "--scheduler", metavar="ADDRESS", help="Dask scheduler whose cluster does the runs"
    )
    add_output(parser, "PRESET")


def main(options):
    """Do the runs and make the report; returns the exit code."""
    return make_documents(prepared(options), options.scheduler)


def prepared(options):
    """The document by the folder of its report, for :func:`eval.pages.document.make_documents`."""
    plan = _plan(options)
    return {folder_of(options, plan.name): document(plan)}


def _plan(options):
    """The plan that the options describe."""
    where = {"backend": options.backend, "scheduler": options.scheduler}
    if options.scene:
        of_preset = ("preset", "data", "targets", "step")
        for name in of_preset:
            if getattr(options, name) is not None:
                raise InputError(f"--{name} cannot be used with --scene; leave one of them out")
        return own_scene(options.scene, options.style, options.seeds, **where)
    if options.style:
        raise InputError("--style needs --scene; name the folder of your scene with it")
    targets = options.targets.split(",") if options.targets else None
    step = 1 if options.step is None else options.step
    return preset(options.preset or "quick", options.data, targets, step, options.seeds, **where)
