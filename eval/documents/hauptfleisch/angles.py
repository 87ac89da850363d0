"""How far a view may lie from the painted one (2.11, 5.4, 5.10, 5.16): from itself to behind it."""

from dataclasses import replace

import numpy as np
import pandas as pd

from eval.documents.hauptfleisch.architecture import METRICS, architecture_scene
from eval.methods.stylit_ref import StylitRef
from eval.metrics import NUMBERS
from eval.metrics.guide_fidelity import guide_error
from eval.pages.claims import OPEN, Claim, by_case, verdict
from eval.pages.figures import contact_sheet
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.runs.store import numbers_of, stored
from stylit_ref import InputError, Params

SCENE = "house_around"

VIEWS = {
    "0": 0, "plus_10": 10, "minus_10": 10, "plus_20": 20, "minus_20": 20,
    "plus_30": 30, "minus_30": 30, "behind": 180,
}  # fmt: skip
"""Degrees from the painted view."""

MOST_APART = 5.0
"""8-bit steps between the painting and its own view, as it comes out."""

_NOT_RENDERED = (
    f"the views are not rendered: `make data SIZE=300x228 SCENES={SCENE}` would render them"
)


def is_rendered(data, style):
    """Whether a data set has these views, and a sketch over the house."""
    try:
        return all(_scene(data, style, view) for view in VIEWS)
    except InputError:
        return False


def _scene(data, style, view):
    scene = architecture_scene(data, style, target=f"{SCENE}/{view}")
    return replace(scene, name=f"angle_{style}_{view}")


def job(data, style, view):
    """The run of one of :data:`VIEWS`, with ``--preset architecture``."""
    return Job(_scene(data, style, view), StylitRef(Params.preset("architecture")))


def tasks(data, style):
    """All of them."""
    return [Task(job(data, style, view), METRICS) for view in VIEWS]


def table(data, style):
    """What is lost with the angle; the runs must be stored.

    Parameters
    ----------
    data : Path
    style : str

    Returns
    -------
    pandas.DataFrame
        ``view``, ``degrees``, ``apart`` from the painting, for its own view alone, and numbers.
    """
    rows = []
    for view, degrees in VIEWS.items():
        run = job(data, style, view)
        outcome, numbers = stored(run), numbers_of(run)
        scene = run.scene
        apart = np.abs(outcome.image.astype(int) - scene.style).mean() if view == "0" else np.nan
        rows.append(
            {
                "view": view,
                "degrees": degrees,
                "apart": apart,
                "guide_error": guide_error(outcome.nnf, scene.source_guides, scene.target_guides),
                **{name: numbers[name] for name in ("crooked", "lost_lines", "sharpness")},
            }
        )
    return pd.DataFrame(rows)


def section(data, style, report):
    """Blocks of the report: the painting beside its own view, all views, and the numbers."""
    numbers = table(data, style)
    own = job(data, style, "0")
    text = numbers.drop(columns="apart")
    for name in ("guide_error", "crooked", "lost_lines", "sharpness"):
        text[name] = text[name].map(NUMBERS[name].form.format)
        text = text.rename(columns={name: NUMBERS[name].title})
    return [
        "## From the painted view to the opposite side",
        "`--preset architecture` from the height of the painting. The painting, and its own view "
        "as it comes out (5.4, 5.10, 5.16):",
        report.pair("own_view", ("painted", own.scene.style), ("stylized", stored(own).image)),
        report.figure(
            "angles", f"{style}: from the painted view to behind it", _figure, data, style,
            committed=True,
        ),
        report.table("angles", numbers, text.astype(str)),
    ]  # fmt: skip


def _figure(data, style, file):
    sheet = [(f"{view}: {degrees}°", stored(job(data, style, view)).image)
             for view, degrees in VIEWS.items()]  # fmt: skip
    contact_sheet([sheet[:4], sheet[4:]], file, tile=240)


def claims(data, style):
    """What the thesis says of angles.

    Parameters
    ----------
    data : Path
    style : str or None
        None if the views are not rendered.

    Returns
    -------
    list of Claim
    """
    if style is None:
        return [Claim(*told, OPEN, rule, _NOT_RENDERED) for told, rule in _RULES]
    numbers = table(data, style)
    means = numbers.groupby("degrees")[["guide_error", "lost_lines"]].mean()
    near, behind = means.loc[:30], means.loc[180]
    apart = numbers["apart"].iloc[0]
    errors = {f"{degrees}°": f"{error:.2f}" for degrees, error in means["guide_error"].items()}
    lost = {f"{degrees}°": f"{share:.1%}" for degrees, share in means["lost_lines"].items()}
    held = (
        apart <= MOST_APART,
        near["guide_error"].is_monotonic_increasing,
        behind["guide_error"] > near["guide_error"].max()
        and behind["lost_lines"] > near["lost_lines"].max(),
    )
    evidence = (
        f"it differs by {apart:.1f} steps",
        f"the error of guides is {by_case(errors)}",
        f"the error of guides is {by_case(errors)}, and lines lost are {by_case(lost)}",
    )
    return [
        Claim(*told, verdict(bool(each)), rule, text)
        for (told, rule), each, text in zip(_RULES, held, evidence, strict=True)
    ]


_RULES = (
    (
        ("The painted view itself comes out as it was painted", "Figs. 5.4, 5.10, 5.16"),
        f"it differs from the painting by at most {MOST_APART:g} of 255 steps on the mean",
    ),
    (
        ("The farther a view lies from the painted one, the less fits it", "Fig. 2.11"),
        "the error of guides, the mean of both sides, rises from 0 to 10, to 20 and to 30 degrees",
    ),
    (
        ("For the opposite side the painting has too little", "Fig. 2.11"),
        "behind the house the error of guides and the share of lost lines are both larger than at "
        "any angle up to 30 degrees",
    ),
)
"""Claim and section, and the rule."""
