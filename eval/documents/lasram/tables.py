"""The tables of section 8, the published numbers beside ours, and the study of quality."""

import numpy as np
import pandas as pd

from eval.documents.lasram.patch_costs import SHARED
from eval.documents.lasram.printed import STAGES, TIMES
from eval.metrics import NUMBERS
from eval.runs.store import numbers_of, stored

PIECE_BOUND = 2.0
"""Pieces of ours may be so many times as large as those of image quilting."""

REPETITION_BOUND = 0.05
"""By so much ours may repeat itself more than image quilting."""

BORDERS = 0.5, 1.5
"""A texture whose border lies between them tiles."""

SHOWN = (
    "seam_cost", "sw", "novelty", "omission", "piece", "largest_piece", "repetition", "border",
)  # fmt: skip


def times(plan):
    """The table of performance: an iteration of the paper's settings, and its memory.

    Returns
    -------
    pandas.DataFrame
    """
    rows = []
    for size in plan.preset.sizes:
        milliseconds = 1000 * stored(plan.timed(size)).history["seconds"].to_numpy()
        rows.append(
            {
                "size of S": size,
                "ours [MB]": round(stored(plan.patch_costs(size)).history["megabytes"][0], 1),
                "ours, iterations 1 to 16 [ms]": round(milliseconds.mean(), 1),
                "ours, 11 to 16 [ms]": round(milliseconds[10:].mean(), 1),
            }
        )
    return TIMES.merge(pd.DataFrame(rows), on="size of S")


def stages(plan):
    """The shares of the paper's four stages in the time of one patch, late in the synthesis.

    Returns
    -------
    pandas.DataFrame
    """
    rows = []
    for size in plan.preset.sizes:
        (shares,) = stored(plan.patch_costs(size)).history[list(SHARED)].to_dict("records")
        ours = {f"ours, {stage}": round(share, 2) for stage, share in shares.items()}
        rows.append({"size of S": size} | ours)
    return STAGES.merge(pd.DataFrame(rows), on="size of S")


def radii(plan):
    """Figure 15: processor milliseconds of a late iteration as R grows, a column for each size."""
    return pd.DataFrame(
        {
            "R": plan.timed_radii,
            **{
                f"{size}²": [
                    1000
                    * stored(plan.timed_radius(size, radius))
                    .history["processor_seconds"][10:]
                    .mean()
                    for radius in plan.timed_radii
                ]
                for size in plan.preset.sizes[:2]
            },
        }
    ).round(2)


def quality(plan):
    """Mean numbers of every method on every exemplar, by the names of the metrics.

    Returns
    -------
    pandas.DataFrame
    """
    rows = []
    for exemplar in plan.exemplars:
        ours = [
            ("default", plan.default), ("one R", plan.of_one_radius),
            ("paper", lambda name, seed: plan.paper(name, seed=seed)),
            ("image quilting", plan.quilting),
        ]  # fmt: skip
        jobs = {name: [make(exemplar, seed) for seed in plan.preset.seeds] for name, make in ours}
        jobs |= {program.name: [plan.rival(exemplar, program)] for program in plan.rivals}
        for method, runs in jobs.items():
            numbers = pd.DataFrame([numbers_of(job) for job in runs]).mean().to_dict()
            seconds = np.mean([stored(job).processor_seconds for job in runs])
            rows.append({"exemplar": exemplar, "method": method, **numbers, "seconds": seconds})
    return pd.DataFrame(rows)


def formatted(table):
    """The table of quality with titles and formats."""
    text = table[["exemplar", "method"]].copy()
    for name in SHOWN:
        title, form = NUMBERS[name]
        text[title] = [
            "" if pd.isna(value) else form.format(value) for value in table.get(name, np.nan)
        ]
    text["processor time [s]"] = table["seconds"].map("{:.2f}".format)
    return text


def beside_quilting(table, method="default"):
    """A method of ours over image quilting, and whether the bounds hold.

    Parameters
    ----------
    table : pandas.DataFrame
        From :func:`quality`.
    method : str
        Its name in the table.

    Returns
    -------
    pandas.DataFrame
        A row for each exemplar.
    """
    ours, theirs = (
        table[table["method"] == name].set_index("exemplar") for name in (method, "image quilting")
    )
    found = pd.DataFrame(
        {
            "sw over quilting's": ours["sw"] / theirs["sw"],
            "piece over quilting's": ours["piece"] / theirs["piece"],
            "repetition less quilting's": ours["repetition"] - theirs["repetition"],
            "border": ours["border"],
        }
    )
    found["bounds"] = [
        "held" if held else "not held"
        for held in (found["piece over quilting's"] <= PIECE_BOUND)
        & (found["repetition less quilting's"] <= REPETITION_BOUND)
        & found["border"].between(*BORDERS)
        & (found["sw over quilting's"] <= 1.5)
    ]
    return found.round(3).reset_index()
