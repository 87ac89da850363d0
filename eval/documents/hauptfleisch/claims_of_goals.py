"""What coherence must reach, tested on our numbers."""

from eval.documents.hauptfleisch.goals import (
    GOALS,
    LEAST_GRADIENT,
    LEAST_OUTLINES,
    MOST_GUIDES,
)
from eval.documents.hauptfleisch.tables import costs, of_floor, styles
from eval.pages.claims import OPEN, Claim, by_case, listed, verdict
from eval.runs.store import numbers_of

TITLES = {
    "house": "the house",
    "large": "the house at 600x456",
    "animation": "the animation",
    "sintel": "two frames of Sintel",
}
"""What the studies are called."""

WITHOUT_DATA = "its frames are not rendered: see the preface"


def claims_of_goals(plan):
    """These claims.

    Parameters
    ----------
    plan : Plan
        Its runs must be stored.

    Returns
    -------
    list of Claim
    """
    return [
        *(
            claim
            for study, goals in GOALS.items()
            for goal in goals
            for claim in _bounds(plan, study, goal)
        ),
        _every_style(plan),
        _silhouettes(plan),
        *(_cost(plan, study) for study in ("house", "large")),
    ]


def of(plan, study, number, method, coherence):
    """A number of a run over that of frames alone.

    Parameters
    ----------
    plan : Plan
    study, number, method : str
    coherence : Coherence

    Returns
    -------
    float or None
        None if the run is not part of the preset.
    """
    if study not in plan.studies or coherence not in plan.studies[study].ways.get(method, ()):
        return None
    study = plan.studies[study]
    found = numbers_of(study.job(method, coherence)), numbers_of(study.alone(method))
    return found[0][number] / found[1][number]


def said(ratios):
    """Ratios by name, as a sentence."""
    told = {name: f"{ratio:.2f}" for name, ratio in ratios.items()}
    return f"it is {by_case(told)}" if told else ""


def _bounds(plan, study, goal):
    """The four bounds of a setting, for every method that was run with it."""
    bounds = (
        ("warping", "warping error", "at most", 1 / goal.calmer),
        ("gradient", "mean gradient", "at least", LEAST_GRADIENT),
        ("outlines", "dark share of the outline band", "at least", LEAST_OUTLINES),
        ("guide_error", "error of guides", "at most", MOST_GUIDES),
    )
    how = f"{goal.coherence.order}, λ_c = {goal.coherence.weight:g}"
    for number, title, side, bound in bounds:
        found = {
            method: of(plan, study, number, method, goal.coherence) for method in ("ref", "stylit")
        }
        found = {method: ratio for method, ratio in found.items() if ratio is not None}
        held = all((ratio <= bound) == (side == "at most") or ratio == bound
                   for ratio in found.values())  # fmt: skip
        yield Claim(
            f"{title.capitalize()} {side} {bound:.2f} of independent frames', {TITLES[study]}, "
            f"{how}",
            "ours",
            verdict(held) if found else OPEN,
            "it is so with every method of the preset",
            ". ".join(
                [said(found), *_elsewhere(plan, study, number, goal), *_floor(plan, study, number)]
            )
            if found
            else WITHOUT_DATA,
        )


def _elsewhere(plan, study, number, goal):
    """The same number with ref at the other weights."""
    found = {
        way.weight: of(plan, study, number, "ref", way)
        for way in plan.studies[study].ways["ref"]
        if (way.form, way.order) == ("norm", goal.coherence.order) and way != goal.coherence
    }
    others = [f"{ratio:.2f} at λ_c = {weight:g}" for weight, ratio in sorted(found.items())]
    return [f"Ref has {listed(others)}"] if others else []


def _floor(plan, study, number):
    """What the error of renderings would be if they were as steep as frames alone."""
    if number != "warping":
        return []
    study = plan.studies[study]
    shares = {method: f"{1 / of_floor(study, study.alone(method)):.2f}" for method in study.ways}
    return [f"Renderings as steep as these frames would have {by_case(shares)}"]


def _every_style(plan):
    goal = GOALS["house"][0]
    rows = styles(plan).to_dict("records")
    held = all(
        row["of alone"] <= 1 / goal.calmer
        and row["gradient"] >= LEAST_GRADIENT
        and row["outlines"] >= LEAST_OUTLINES
        and row["guide_error"] <= MOST_GUIDES
        for row in rows
    )
    return Claim(
        "All this holds in every style of the house",
        "ours",
        verdict(held) if len(rows) > 1 else OPEN,
        "with ref all four bounds are kept in every style of the preset",
        "error, gradient, outlines and guides are "
        + by_case(
            {
                row["style"]: listed(
                    [f"{row[n]:.2f}" for n in ("of alone", "gradient", "outlines", "guide_error")]
                )
                for row in rows
            }
        )
        if rows
        else WITHOUT_DATA,
    )


def _silhouettes(plan):
    """Of the house alone: in oil everything beside a silhouette is dark."""
    found = {}
    for job in plan.studies["house"].without_silhouettes if "house" in plan.studies else ():
        study, how = plan.studies["house"], job.method.coherence
        runs = study.job("ref", how), job, study.alone("ref")
        ours, without, alone = (numbers_of(run)["outlines"] for run in runs)
        found[how.order] = ours / alone, without / alone
    return Claim(
        "Pixels beside something nearer take its motion, and outlines are kept",
        "ours",
        verdict(all(ours >= max(without, LEAST_OUTLINES) for ours, without in found.values()))
        if found
        else OPEN,
        "with ref at the setting that is judged the dark share of the house's outline band is at "
        f"least {LEAST_OUTLINES} of that of frames alone, and not less than without the rule",
        "; ".join(
            f"it is {ours:.2f}, and {without:.2f} without" for ours, without in found.values()
        )
        or WITHOUT_DATA,
    )


def _cost(plan, study):
    most = GOALS[study][0].cost
    rows = [row for row in costs(plan).to_dict("records") if row["study"] == study]
    return Claim(
        f"Coherence costs at most {most} times the time, {TITLES[study]}",
        "ours",
        verdict(all(row["ratio"] <= most for row in rows)) if rows else OPEN,
        "so many seconds of the processor, in turns with frames alone, without state files, with "
        "every method that is timed",
        "; ".join(
            f"{row['method']} takes {row['ratio']:.2f} times as long, and "
            f"{row['state files [s]']:g} seconds for state files"
            for row in rows
        )
        or "it is not timed in this preset",
        of_time=True,
    )
