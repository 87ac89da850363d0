"""How well holes are filled, and what each cure is for (section 8, "Texture completion")."""

import pandas as pd

from eval.documents.lasram.plan import LARGEST_HOLE
from eval.methods.hole_filling import CURES, HOLES
from eval.runs.store import stored

MOST_COST = 0.3
"""M a pixel of the hole, at most, where a hole is filled well."""


def filled(plan):
    """Every hole in every exemplar.

    Returns
    -------
    pandas.DataFrame
        Columns exemplar, hole, share, changed, left, cost and iterations.
    """
    rows = []
    for exemplar in plan.with_holes:
        for hole in HOLES:
            job = plan.filled(exemplar, hole)
            found = _facts(job)
            share = found.pop("hole") / job.scene.pixels
            rows.append({"exemplar": exemplar, "hole": hole, "share": share, **found})
    return pd.DataFrame(rows).astype(dict.fromkeys(("changed", "left", "iterations"), int))


def without_cures(plan):
    """What a pixel of the largest hole costs with all cures, and without each.

    Returns
    -------
    pandas.DataFrame
        A row for each exemplar.
    """
    rows = []
    for exemplar in plan.with_holes:
        row = {"exemplar": exemplar, "all": _facts(plan.filled(exemplar, LARGEST_HOLE))["cost"]}
        for cure in CURES:
            found = _facts(plan.filled(exemplar, LARGEST_HOLE, cure))
            row |= {f"without {cure}": found["cost"], f"left without {cure}": found["left"]}
        rows.append(row)
    return pd.DataFrame(rows)


def shown_without_cures(table):
    """The table of :func:`without_cures` as text: costs, and how much is left where anything is.

    Parameters
    ----------
    table : pandas.DataFrame

    Returns
    -------
    pandas.DataFrame
    """
    text = table[["exemplar"]].copy()
    text["all"] = table["all"].map("{:.3f}".format)
    for name in (f"without {cure}" for cure in CURES):
        left = table[f"left {name}"]
        text[name] = [
            f"{cost:.3f}" + (f", {count:.0f} px left" if count else "")
            for cost, count in zip(table[name], left, strict=True)
        ]
    return text


def _facts(job):
    return stored(job).history.iloc[0].to_dict()
