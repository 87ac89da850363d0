"""Tables: every way to stylize the frames of a study, between a floor and a ceiling."""

import pandas as pd

from eval.documents.hauptfleisch.goals import GOALS
from eval.metrics import NUMBERS
from eval.runs.store import numbers_of, stored

SHOWN = (
    "warping", "strokes", "warping_2", "warping_5", "warping_10", "round", "flicker", "fast",
    "gradient", "crispness", "outlines", "guide_error", "kept",
)  # fmt: skip
"""Numbers of the tables, as far as a study has them."""


def ways(study):
    """All ways to stylize the frames of a study.

    Parameters
    ----------
    study : Study
        Its runs must be stored.

    Returns
    -------
    pandas.DataFrame
        ``method``, ``order``, ``weight``, ``form``, the numbers, ``of alone``: the warping error
        over that of the same method without coherence, and ``of floor``. The first row is of the
        renderings.
    """
    rows = [{"method": "renderings"} | numbers_of(study.floor)]
    for job in study.jobs:
        method, how = job.method.params.method, job.method.coherence
        numbers = numbers_of(job)
        alone = numbers_of(study.alone(method))["warping"]
        pulled = {"order": how.order, "weight": how.weight, "form": how.form}
        rows.append(
            {"method": method}
            | (pulled if how.weight else {"order": "alone"})
            | ({} if job.method.silhouettes else {"silhouettes": "no"})
            | {"of alone": numbers["warping"] / alone, "of floor": of_floor(study, job)}
            | numbers
            | {"cpu": stored(job).stages["cpu"]}
        )
    table = pd.DataFrame(rows)
    first = "method", "order", "weight", "form", "silhouettes", "of alone", "of floor"
    return table[[name for name in (*first, *SHOWN, "cpu") if name in table]]


def of_floor(study, job):
    """The warping error for a gradient of 1, over that of the renderings.

    Motion ends between pixels, and the nearest one is taken: even paint that moves exactly with its
    surface differs by up to half a pixel, the more the steeper it is.

    Parameters
    ----------
    study : Study
    job : Job
        One of its runs.

    Returns
    -------
    float
        1 for paint that moves as exactly as the renderings do.
    """
    ours, floor = numbers_of(job), numbers_of(study.floor)
    return (ours["warping"] / ours["gradient"]) / (floor["warping"] / floor["gradient"])


def styles(plan):
    """Every style of the house at the setting that is judged, with ref.

    Returns
    -------
    pandas.DataFrame
        Numbers over those of frames alone, but for ``alone``, ``coherent`` and ``floor``, which is
        the error that renderings would have if they were as steep.
    """
    rows = []
    coherence = GOALS["house"][0].coherence
    for style, study in plan.styles.items():
        job = study.job("ref", coherence)
        alone, ours = numbers_of(study.alone("ref")), numbers_of(job)
        ratios = {
            name: ours[name] / alone[name] for name in ("gradient", "outlines", "guide_error")
        }
        rows.append(
            {
                "style": style,
                "alone": alone["warping"],
                "coherent": ours["warping"],
                "floor": ours["warping"] / of_floor(study, job),
                "of alone": ours["warping"] / alone["warping"],
                **ratios,
            }
        )
    return pd.DataFrame(rows)


def shown(table):
    """A table of :func:`ways` as text."""
    text = table.copy()
    forms = {name: NUMBERS[name].form for name in SHOWN if name in table}
    forms |= {"weight": "{:g}", "of alone": "{:.2f}", "of floor": "{:.2f}", "cpu": "{:.1f}"}
    for name, form in forms.items():
        text[name] = ["" if pd.isna(value) else form.format(value) for value in table[name]]
    titles = {name: NUMBERS[name].title for name in SHOWN} | {"weight": "λ_c", "cpu": "cpu [s]"}
    return text.fillna("").rename(columns=titles)


def costs(plan):
    """What coherence costs at the settings that are judged.

    Returns
    -------
    pandas.DataFrame
        Seconds of the processor for all frames, and their ratio to frames alone.
    """
    rows = []
    for study, method in plan.costed:
        history = stored(plan.costs(study, method)).history
        alone, *others = history.itertuples()
        for goal, spent in zip(GOALS[study], others, strict=True):
            rows.append(
                {
                    "study": study,
                    "method": method,
                    "λ_c": goal.coherence.weight,
                    "alone [s]": round(alone.cpu, 1),
                    "coherent [s]": round(spent.cpu, 1),
                    "ratio": round(spent.cpu / alone.cpu, 2),
                    "state files [s]": round(spent.files, 1),
                }
            )
    return pd.DataFrame(rows)
