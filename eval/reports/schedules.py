"""Compare the default schedule with sequential PatchMatch (Ω live), at every λ of the thesis."""

import numpy as np
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

UNIFORMITIES = (0, 5000, 10000, 15000, 50000, 100000)
SCHEDULES = ("scanline", "propose_commit")
MOST_ABOVE = 1.02
"""Most that φ and δ may be, as a multiple of those of ``scanline``."""


def add_options(parser):
    """Declare what the report may be told."""
    shared.add_scene(parser, "golem/crayon")
    parser.add_argument(
        "--seeds", type=int, nargs="+", default=[0], help="seeds to average over (default 0)"
    )
    parser.add_argument(
        "--uniformities", type=float, nargs="+", default=UNIFORMITIES, metavar="λ",
        help="values of λ (default: those of the thesis)",
    )  # fmt: skip
    shared.add_numbers(parser)
    shared.add_output(parser, "schedules_SCENE_SIZE")


def main(options):
    """Make the report; returns the exit code."""
    scene = shared.scene_of(options)
    folder = shared.folder_of(options, f"schedules_{scene.name}_{scene.size}")
    schedules_report(scene, folder, options.seeds, options.uniformities, not options.numbers)
    return shown(folder)


def schedules_report(scene, folder, seeds=(0,), uniformities=UNIFORMITIES, pictures=True):
    """Run both schedules at every λ and write images, numbers and a page.

    Parameters
    ----------
    scene : Scene
    folder : Path
    seeds : sequence of int
        Numbers are means over them; pictures show the first.
    uniformities : sequence of float
    pictures : bool
        False leaves out the image, for scenes that we may not show.

    Returns
    -------
    pandas.DataFrame
        A row for each λ and schedule.
    """
    rows, images = [], {schedule: [] for schedule in SCHEDULES}
    tasks = [(uniformity, schedule) for uniformity in uniformities for schedule in SCHEDULES]
    for uniformity, schedule in tqdm(tasks, unit="setting", disable=None):
        method = StylitRef(Params(uniformity=uniformity, schedule=schedule))
        jobs = [Job(scene, method, seed) for seed in seeds]
        measured = pd.DataFrame([row(job) for job in jobs]).mean()
        rows.append({"λ": f"{uniformity:g}", "schedule": schedule, **measured})
        images[schedule].append((f"{schedule}, λ = {uniformity:g}", run(jobs[0]).image))
    frame = pd.DataFrame(rows)
    seed_text = ", ".join(map(str, seeds))
    with new_report(folder) as report:
        sections = [
            provenance(),
            *([_figure(scene, list(images.values()), report)] if pictures else []),
            report.table("schedules", frame, formatted(frame[["λ", "schedule", *COLUMNS]])),
            "propose_commit over scanline; it counts as right where φ and δ are at most "
            f"{MOST_ABOVE} and usage and sharpness not below 1:",
            table(schedule_ratios(frame)),
            f"Thesis configuration, means over seeds {seed_text}.",
            definitions(COLUMNS),
        ]
        report.page(f"Schedules on {scene.name}, {scene.size}", sections)
    return frame


def _figure(scene, rows, report):
    caption = "scanline above, propose_commit below"
    zoom = detailed_window(detail(scene.shown_guide))
    return report.figure("schedules", caption, comparison, rows, zoom, committed=True)


def schedule_ratios(frame):
    """propose_commit over scanline for each λ."""
    by_schedule = {
        name: part.set_index("λ") for name, part in frame.groupby("schedule", sort=False)
    }
    columns = [
        "phi",
        "delta",
        "image_energy",
        "distinct",
        "distinct_in_image",
        "sharpness",
        "richness",
    ]
    ratio = by_schedule["propose_commit"][columns] / by_schedule["scanline"][columns]
    limits = np.all(ratio[["phi", "delta"]] <= MOST_ABOVE, axis=1)
    kept = np.all(ratio[["distinct", "sharpness"]] >= 1, axis=1)
    ratio = ratio.map("{:.3f}".format)
    ratio["φ, δ within"] = np.where(limits, "yes", "no")
    ratio["usage, sharpness kept"] = np.where(kept, "yes", "no")
    return ratio.reset_index()
