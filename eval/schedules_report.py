"""The default schedule against sequential PatchMatch with Ω live, at every λ of the thesis."""

from dataclasses import replace

import numpy as np
import pandas as pd
from tqdm import tqdm

from eval.circumstances import circumstances
from eval.figures import comparison, detailed_window
from eval.measures import DEFINITIONS, formatted, measure
from eval.report import new_report, table
from eval.runs import run
from eval.sharpness import detail
from stylit_ref import Params

UNIFORMITIES = (0, 5000, 10000, 15000, 50000, 100000)
SCHEDULES = ("scanline", "propose_commit")
MOST_ABOVE = 1.02
"""φ and δ may exceed those of ``scanline`` by this factor."""


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
        False leaves out the image, for scenes that are not ours to show.

    Returns
    -------
    pandas.DataFrame
        A row for each λ and schedule.
    """
    rows, images = [], {schedule: [] for schedule in SCHEDULES}
    tasks = [(uniformity, schedule) for uniformity in uniformities for schedule in SCHEDULES]
    for uniformity, schedule in tqdm(tasks, unit="setting", disable=None):
        params = replace(Params(), uniformity=uniformity, schedule=schedule)
        measured = pd.DataFrame([measure(scene, params, seed) for seed in seeds]).mean()
        rows.append({"λ": f"{uniformity:g}", "schedule": schedule, **measured})
        image = run(scene, params, seeds[0]).image
        images[schedule].append((f"{schedule}, λ = {uniformity:g}", image))
    frame = pd.DataFrame(rows)
    seed_text = ", ".join(map(str, seeds))
    with new_report(folder) as report:
        sections = [
            circumstances(),
            *([_figure(scene, list(images.values()), report)] if pictures else []),
            report.table("schedules", frame, formatted(frame.drop(columns="seconds"))),
            "propose_commit over scanline; it counts as right where φ and δ are at most "
            f"{MOST_ABOVE} and usage and sharpness not below 1:",
            table(schedule_ratios(frame)),
            f"Thesis configuration, means over seeds {seed_text}.",
            DEFINITIONS,
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
