"""Repeat section 8 of Lasram and Lefebvre (2012) on our exemplars: tables, figures and claims."""

from eval.documents.lasram.page import document
from eval.documents.lasram.plan import Plan
from eval.documents.lasram.presets import PRESETS
from eval.methods.texture_program import embark, gmic, img2texture
from eval.pages.document import make_documents
from eval.pages.options import add_output, folder_of
from eval.textures import NINE

RIVALS = {"gmic": gmic, "img2texture": img2texture, "embark": embark}


def add_options(parser):
    """Declare what the report may be told."""
    parser.add_argument(
        "--preset", choices=PRESETS, default="quick",
        help="quick: one seed, 300 cuts, S up to 1024x1024; full: five seeds, 3000 cuts, up to "
        "2048x2048, completion at 1600x1200 and memory at 8192x8192 (default quick)",
    )  # fmt: skip
    for name in RIVALS:
        parser.add_argument(
            f"--{name}", metavar="PATH", help="the program, to compare its textures with ours"
        )
    add_output(parser, "lasram_PRESET")


def main(options):
    """Do the runs and make the report; returns the exit code."""
    return make_documents(prepared(options))


def prepared(options):
    """The document by the folder of its report, for :func:`eval.pages.document.make_documents`."""
    rivals = [
        make(getattr(options, name)) for name, make in RIVALS.items() if getattr(options, name)
    ]
    for rival in rivals:
        rival.binary  # noqa: B018  one that is not there is named before anything is done
    plan = Plan(options.preset, PRESETS[options.preset], NINE, tuple(rivals))
    return {folder_of(options, f"lasram_{plan.name}"): document(plan)}
