"""Compare StyLit and its options with the occurrence map (thesis 1.5, 4.2)."""

import pandas as pd
from tqdm import tqdm

from eval.methods.stylit_ref import StylitRef
from eval.metrics import definitions
from eval.metrics.sharpness import detail
from eval.pages import options as shared
from eval.pages.figures import comparison, detailed_window
from eval.pages.measured import COLUMNS, row
from eval.pages.page import new_report, shown
from eval.pages.tables import formatted, table
from eval.provenance import provenance
from eval.runs.job import Job
from eval.runs.local import run
from stylit_ref import Params

SETTINGS = {
    "StyLit": Params("stylit"),
    "ref, λ = 0": Params(uniformity=0),
    "ref, λ = 10000": Params(uniformity=10000),
    "StyLit, budget 0.9 of the sum": Params("stylit", budget=0.9),
    "StyLit, all patches fixed": Params("stylit", fixed_share=1.0),
    "StyLit, α = 5": Params("stylit", error_limit=5.0),
    "StyLit, 4 outliers left out": Params("stylit", vote_outliers=4),
}


SHOWN = [name for name in COLUMNS if name not in ("penalization", "phi")]


def add_options(parser):
    """Declare what the report may be told."""
    shared.add_scene(parser, "golem/oil")
    shared.add_seed(parser)
    shared.add_numbers(parser)
    shared.add_output(parser, "stylit_SCENE_SIZE")


def main(options):
    """Make the report; returns the exit code."""
    scene = shared.scene_of(options)
    folder = shared.folder_of(options, f"stylit_{scene.name}_{scene.size}")
    stylit_report(scene, folder, options.seed, not options.numbers)
    return shown(folder)


def stylit_report(scene, folder, seed=0, pictures=True):
    """Run StyLit, its options, and ref; write images, numbers and a page.

    Parameters
    ----------
    scene : Scene
    folder : Path
    seed : int
    pictures : bool
        False leaves out every image, for scenes that we may not show.

    Returns
    -------
    pandas.DataFrame
    """
    rows = []
    for name, params in tqdm(SETTINGS.items(), unit="run", disable=None):
        rows.append({"method": name, **row(Job(scene, StylitRef(params), seed))})
    frame = pd.DataFrame(rows)
    with new_report(folder) as report:
        sections = [
            provenance(),
            *([_figure(scene, seed, report)] if pictures else []),
            report.table("stylit", frame, formatted(frame[["method", *SHOWN, "seconds"]])),
            "Thesis configuration: 6 levels, 6 votes, 6 PatchMatch iterations a search; seed "
            f"{seed}. Image energy and usage are measured alike for all; δ of StyLit holds what "
            "its budget accepted.",
            "Source-to-target retrievals of StyLit by level (1 the coarsest) and vote, and the "
            "share of the target they fixed; the rest is from target to source:",
            table(_retrievals(run(Job(scene, StylitRef(SETTINGS["StyLit"]), seed)).history)),
            definitions(SHOWN),
        ]
        report.page(f"StyLit on {scene.name}, {scene.size}", sections)
    return frame


def _figure(scene, seed, report):
    guide = scene.shown_guide
    images = [
        (name, run(Job(scene, StylitRef(params), seed)).image) for name, params in SETTINGS.items()
    ]
    rows = [[("style", scene.style), ("target guide", guide), *images[:3]], images[3:]]
    caption = "StyLit, ref, and options of StyLit"
    zoom = detailed_window(detail(guide))
    return report.figure("stylit", caption, comparison, rows, zoom, committed=True)


def _retrievals(history):
    """Retrievals and share fixed, a row for each level and a column for each vote."""
    last = history.groupby(["level", "vote"]).last()
    cells = last["retrieval"].map("{:.0f}".format) + last["fixed"].map(" ({:.1%})".format)
    return cells.unstack().rename(columns="vote {}".format).reset_index()
