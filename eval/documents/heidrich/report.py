"""Repeat chapters 4 to 7 of Heidrich (2017) on our stage: tables, figures, claims and outlook."""

from functools import cache, partial

from eval.documents.heidrich import stage
from eval.documents.heidrich.beside import Beside
from eval.documents.heidrich.busy import Busy
from eval.documents.heidrich.faults import Faults
from eval.documents.heidrich.house import House, house
from eval.documents.heidrich.page import document
from eval.documents.heidrich.plan import PRESETS, PRODUCTS, SIDES, Plan
from eval.documents.heidrich.prototype import prototype_of
from eval.documents.heidrich.turning import turning
from eval.pages.document import make_documents
from eval.pages.options import add_output, folder_of
from stylit_ref import InputError


def add_options(parser):
    """Declare what the report may be told."""
    parser.add_argument(
        "--preset", choices=PRESETS, default="quick",
        help="quick: pictures of 300x228, one style studied; full: 500x500, all styles, and "
        "renders what is not there yet (default quick)",
    )  # fmt: skip
    parser.add_argument(
        "--prototype", metavar="PATH",
        help="a Python file with another implementation, to compare its times and energies with "
        "ours where the scene is rendered; eval/documents/heidrich/prototype.py says what it must "
        "have",
    )  # fmt: skip
    add_output(parser, "heidrich_PRESET")


def main(options):
    """Do the runs and make the report; returns the exit code."""
    return make_documents(prepared(options))


def prepared(options):
    """The document by the folder of its report, for :func:`eval.pages.document.make_documents`."""
    if options.preset == "full":
        shown = partial(stage.rendered, side=SIDES[0])
        timed, large = partial(stage.rendered, "oil"), None
    else:
        shown, timed = stage.bundled, stage.for_times
        large = partial(stage.rendered, side=SIDES[0]) if stage.is_rendered(SIDES[0]) else None
    turn = None
    if stage.is_rendered(SIDES[0], "turning/00"):
        turn = turning(stage.RENDERED / f"{SIDES[0]}x{SIDES[0]}", "oil", PRODUCTS)
    plan = Plan(
        options.preset, PRESETS[options.preset], shown, timed, large=large, turning=turn,
        asides=tuple(_asides(options)),
    )  # fmt: skip
    return {folder_of(options, f"heidrich_{plan.name}"): document(plan)}


def _asides(options):
    """Sections on what is there: rendered scenes, the house, and a prototype."""
    yield Busy(stage.for_times(SIDES[0]))
    sides = tuple(side for side in SIDES if stage.is_rendered(side))
    preset = PRESETS[options.preset]
    scene_of = cache(stage.rendered)
    if sides:  # at the larger size the dense method takes minutes
        yield Faults(scene_of, sides if options.preset == "full" else sides[:1], preset.rounds)
    drawn = house(stage.RENDERED / "600x456")  # as the report on views has it
    if drawn:
        yield House(drawn, preset.seeds)
    if options.prototype:
        prototype_of(options.prototype)  # one that does not fit is named before anything is done
        if not sides:
            raise InputError(
                "--prototype: there are no scenes of its size; render them with "
                f"'make data SIZE={SIDES[0]}x{SIDES[0]} SCENES=golem ARGS=--guides-only'"
            )
        yield Beside(options.prototype, scene_of, sides)
