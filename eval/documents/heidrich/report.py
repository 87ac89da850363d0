"""Repeat chapters 4 to 7 of Heidrich (2017) on our stage: tables, figures, claims and outlook."""

from functools import partial

from eval.documents.heidrich import stage
from eval.documents.heidrich.page import document
from eval.documents.heidrich.plan import PRESETS, PRODUCTS, SIDES, Plan
from eval.documents.heidrich.turning import turning
from eval.pages.document import make_document
from eval.pages.options import add_output, folder_of


def add_options(parser):
    """Declare what the report may be told."""
    parser.add_argument(
        "--preset", choices=PRESETS, default="quick",
        help="quick: pictures of 300x228, one style studied; full: 500x500, all styles, and "
        "renders what is not there yet (default quick)",
    )  # fmt: skip
    add_output(parser, "heidrich_PRESET")


def main(options):
    """Do the runs and make the report; returns the exit code."""
    if options.preset == "full":
        shown = partial(stage.rendered, side=SIDES[0])
        timed, large = partial(stage.rendered, "oil"), None
    else:
        shown, timed = stage.bundled, stage.for_times
        large = partial(stage.rendered, side=SIDES[0]) if stage.is_rendered(SIDES[0]) else None
    turn = None
    if stage.is_rendered(SIDES[0], "turning/00"):
        turn = turning(stage.RENDERED / f"{SIDES[0]}x{SIDES[0]}", "oil", PRODUCTS)
    plan = Plan(options.preset, PRESETS[options.preset], shown, timed, large=large, turning=turn)
    return make_document(document(plan), folder_of(options, f"heidrich_{plan.name}"))
