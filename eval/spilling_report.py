"""Spilling and its cure by an ID guide (thesis 5.2.4)."""

from dataclasses import replace

import numpy as np
import pandas as pd
from tqdm import tqdm

from eval.circumstances import circumstances
from eval.figures import comparison, detailed_window
from eval.report import new_report
from eval.runs import run
from eval.scenes import load_scene
from eval.spilling import spilling
from stylit_ref import InputError, Params


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
            raise InputError(f"{name}: is no scene of a data set, and has no IDMASK")
        guided = replace(
            plain,
            guide_names=(*plain.guide_names, "IDMASK"),
            source_guides=(*plain.source_guides, plain.ids[0]),
            target_guides=(*plain.target_guides, plain.ids[1]),
        )
        results = [
            run(scene, params, seed)
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
            circumstances(),
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
