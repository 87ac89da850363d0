"""Measure spilling without and with an ID guide, which cures it (thesis 5.2.4)."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
from tqdm import tqdm

from eval.methods.stylit_ref import StylitRef
from eval.metrics.spilling import spilling
from eval.pages import options as shared
from eval.pages.figures import comparison, detailed_window
from eval.pages.page import new_report, shown
from eval.provenance import provenance
from eval.runs.job import Job
from eval.runs.local import run
from eval.scenes import load_scene
from stylit_ref import InputError, Params

SCENES = "scorpion/watercolour,hand/watercolour,golem/oil,stego/crayon,teapot/oil"


def add_options(parser):
    """Declare what the report may be told."""
    parser.add_argument(
        "--scene", default=SCENES, metavar="TARGET/STYLE,...",
        help=f"scenes of the data set, commas between (default {SCENES.replace(',', ', ')})",
    )  # fmt: skip
    shared.add_data(parser)
    parser.add_argument(
        "--step", type=int, default=1, help="keep only every STEPth row and column (default 1)"
    )
    shared.add_seed(parser)
    shared.add_output(parser, "spilling_DATA")


def main(options):
    """Make the report; returns the exit code."""
    folder = shared.folder_of(options, f"spilling_{Path(options.data).resolve().name}")
    spilling_report(options.scene.split(","), options.data, folder, options.step, options.seed)
    return shown(folder)


def spilling_report(names, data, folder, step=1, seed=0):
    """Stylize scenes of a data set without and with their ID guide; write a figure and a page.

    Parameters
    ----------
    names : sequence of str
        ``TARGET/STYLE``.
    data : str or Path
        Folder of the data set.
    folder : Path
    step : int
    seed : int

    Returns
    -------
    pandas.DataFrame
    """
    rows, pictures, where = [], [], []
    for name in tqdm(names, unit="scene", disable=None):
        plain = load_scene(name, data, step)
        if plain.ids is None:
            raise InputError(f"{name}: has no IDMASK; name TARGET/STYLE of a data set")
        guided = replace(
            plain,
            guide_names=(*plain.guide_names, "IDMASK"),
            source_guides=(*plain.source_guides, plain.ids[0]),
            target_guides=(*plain.target_guides, plain.ids[1]),
        )
        results = [
            run(Job(scene, StylitRef(params), seed))
            for params in (Params(), Params("stylit"))
            for scene in (plain, guided)
        ]
        spilled = [spilling(result.nnf, plain.ids) for result in results]
        columns = ("ref", "ref with the ID guide", "StyLit", "StyLit with the ID guide")
        shares = (f"{where.mean():.2%}" for where in spilled)
        rows.append({"scene": plain.name, **dict(zip(columns, shares, strict=True))})
        where.append(spilled[0])
        pictures.append(
            [
                ("style", plain.style),
                ("ID guide", plain.ids[1]),
                (f"{name}: ref", results[0].image),
                ("with the ID guide", results[1].image),
                ("StyLit", results[2].image),
                ("with the ID guide", results[3].image),
                ("where ref spilled", np.uint8(255) * spilled[0][:, :, None]),
                ("with the ID guide", np.uint8(255) * spilled[1][:, :, None]),
            ]
        )
    frame = pd.DataFrame(rows)
    zoom = detailed_window(np.mean(where, axis=0))
    caption = "without and with the ID guide"
    with new_report(folder) as report:
        sections = [
            provenance(),
            report.figure("spilling", caption, comparison, pictures, zoom, committed=True),
            report.table("spilling", frame, frame),
            "Spilled: target patches whose source patch is centred on another of the three things "
            "(object, floor, wall) than they are. Light alone cannot tell the floor in shadow from "
            "the wall; three colours can (thesis 5.2.4). Thesis configuration, ref at λ = 10000, "
            f"seed {seed}; all guide channels weigh alike, so that the light passes weigh less "
            "where there is an ID guide.",
        ]
        report.page(f"Spilling and the ID guide, {plain.size}", sections)
    return frame
