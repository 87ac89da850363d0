"""The claims of the thesis about coherence, and what ours must reach, tested on our numbers."""

from eval.documents.hauptfleisch import architecture
from eval.documents.hauptfleisch.goals import (
    GOALS,
    LEAST_GRADIENT,
    LEAST_OUTLINES,
    MOST_GUIDES,
)
from eval.documents.hauptfleisch.tables import costs, of_floor, styles
from eval.pages.claims import OPEN, Claim, verdict
from eval.runs.store import numbers_of
from stylit_ref.views.params import PARALLEL, PLAIN, SEQUENTIAL, SWEEPS, Coherence

TITLES = {
    "house": "the house",
    "large": "the house at 600x456",
    "animation": "the animation",
    "sintel": "two frames of Sintel",
}
"""What the studies are called."""

_WITHOUT_DATA = "its frames are not rendered: see the preface"


def claims(plan):
    """All claims: those of the thesis first.

    Parameters
    ----------
    plan : Plan
        Its runs must be stored.

    Returns
    -------
    list of Claim
    """
    sketches = plan.sketches
    of_sketches = architecture.claims(architecture.table(plan.data, sketches)) if sketches else ()
    return [
        *of_sketches,
        _alone(plan),
        _promoted(plan),
        _all_at_once(plan),
        _one_after_the_other(plan),
        *(_printed_form(plan, method) for method in ("ref", "stylit")),
        *(
            claim
            for study, goals in GOALS.items()
            for goal in goals
            for claim in _goals(plan, study, goal)
        ),
        _every_style(plan),
        _silhouettes(plan),
        *(_cost(plan, study) for study in ("house", "large")),
    ]


def _of(plan, study, number, method, coherence):
    """A number over that of frames alone; None if the run is not part of the preset."""
    if study not in plan.studies or coherence not in plan.studies[study].ways.get(method, ()):
        return None
    study = plan.studies[study]
    found = numbers_of(study.job(method, coherence)), numbers_of(study.alone(method))
    return found[0][number] / found[1][number]


def _alone(plan):
    found = {}
    for name, study in plan.studies.items():
        floor = numbers_of(study.floor)["warping"]
        for method in study.ways:
            found[f"{TITLES[name]}, {method}"] = (
                numbers_of(study.alone(method))["warping"], floor,
            )  # fmt: skip
    return Claim(
        "Frames that are stylized independently change abruptly",
        "3.2.1",
        verdict(all(alone >= 3 * floor for alone, floor in found.values())) if found else OPEN,
        "their warping error is at least three times that of the renderings, everywhere",
        "; ".join(f"{name}: {alone:.1f}, renderings {floor:.1f}"
                  for name, (alone, floor) in found.items()) or _WITHOUT_DATA,
    )  # fmt: skip


def _promoted(plan):
    ratios = [
        _of(plan, name, "warping", method, way)
        for name, study in plan.studies.items()
        for method, ways in study.ways.items()
        for way in ways
    ]
    return Claim(
        "Taking the difference to the shifted pictures promotes coherence",
        "3.2.1",
        verdict(max(ratios) < 1) if ratios else OPEN,
        "the warping error is smaller than without it at every λ_c, in every order, everywhere",
        f"{min(ratios):.2f} to {max(ratios):.2f} of that without it in {len(ratios)} runs"
        if ratios else _WITHOUT_DATA,
    )  # fmt: skip


def _orders(plan, study, method="ref"):
    """The share of the warping error that each order leaves at λ_c = 1, as far as they are run."""
    found = {
        order: _of(plan, study, "warping", method, Coherence(1.0, order=order))
        for order in (PARALLEL, SWEEPS, SEQUENTIAL)
    }
    return {order: ratio for order, ratio in found.items() if ratio is not None}


def _all_at_once(plan):
    found = _orders(plan, "house")
    return Claim(
        "On a grid all frames should be stylized at the same time",
        "3.2.2",
        verdict(found[PARALLEL] <= min(found.values())) if len(found) == 3 else OPEN,
        "`parallel` leaves no more of the warping error than `sequential` (row by row) and "
        "`sweeps`, with ref at λ_c = 1",
        _said(found) or _WITHOUT_DATA,
    )


def _one_after_the_other(plan):
    found = _orders(plan, "animation")
    return Claim(
        "In an animation frames are stylized one after the other",
        "3.2.1",
        verdict(found[SEQUENTIAL] <= min(found.values())) if len(found) == 3 else OPEN,
        "`sequential` leaves no more of the warping error than the others, with ref at λ_c = 1",
        _said(found) or _WITHOUT_DATA,
    )


def _said(ratios):
    return ", ".join(f"{name} {ratio:.2f}" for name, ratio in ratios.items())


def _printed_form(plan, method):
    """Weights that add up leave less for the guides."""
    norm, plain = (
        [
            _of(plan, "house", number, method, Coherence(0.5, form))
            for number in ("guides", "warping")
        ]
        for form in ("norm", PLAIN)
    )
    known = None not in (*norm, *plain)
    return Claim(
        f"Weights that add up, as printed, cost fidelity to the guides, with {method}",
        "3.1 (ours)",
        verdict(plain[0] > MOST_GUIDES >= norm[0]) if known else OPEN,
        f"at λ_c = 0.5 on the house the error of guides is more than {MOST_GUIDES} of that of "
        "frames alone with `plain`, and not with `norm`",
        f"plain {plain[0]:.3f} (warping error {plain[1]:.2f}), norm {norm[0]:.3f} ({norm[1]:.2f})"
        if known else "not part of this preset",
    )  # fmt: skip


def _goals(plan, study, goal):
    """The five bounds of a setting, for every method that was run with it."""
    bounds = (
        ("warping", "warping error", "at most", 1 / goal.calmer),
        ("gradient", "mean gradient", "at least", LEAST_GRADIENT),
        ("outlines", "dark share of the outline band", "at least", LEAST_OUTLINES),
        ("guides", "error of guides", "at most", MOST_GUIDES),
    )
    how = f"{goal.coherence.order}, λ_c = {goal.coherence.weight:g}"
    for number, title, side, bound in bounds:
        found = {
            method: _of(plan, study, number, method, goal.coherence) for method in ("ref", "stylit")
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
            "; ".join(
                [_said(found), *_elsewhere(plan, study, number, goal), *_floor(plan, study, number)]
            )
            if found
            else _WITHOUT_DATA,
        )


def _elsewhere(plan, study, number, goal):
    """The same number with ref at the other weights."""
    found = {
        way.weight: _of(plan, study, number, "ref", way)
        for way in plan.studies[study].ways["ref"]
        if (way.form, way.order) == ("norm", goal.coherence.order) and way != goal.coherence
    }
    others = ", ".join(f"{ratio:.2f} at {weight:g}" for weight, ratio in sorted(found.items()))
    return [f"ref elsewhere {others}"] if others else []


def _floor(plan, study, number):
    """What the error of renderings would be if they were as steep as frames alone."""
    if number != "warping":
        return []
    study = plan.studies[study]
    shares = ", ".join(
        f"{method} {1 / of_floor(study, study.alone(method)):.2f}" for method in study.ways
    )
    return [f"renderings as steep as these frames would have {shares}"]


def _every_style(plan):
    goal = GOALS["house"][0]
    rows = styles(plan).to_dict("records")
    held = all(
        row["of alone"] <= 1 / goal.calmer
        and row["gradient"] >= LEAST_GRADIENT
        and row["outlines"] >= LEAST_OUTLINES
        and row["guides"] <= MOST_GUIDES
        for row in rows
    )
    return Claim(
        "All this holds in every style of the house",
        "ours",
        verdict(held) if len(rows) > 1 else OPEN,
        "with ref all four bounds are kept in every style of the preset",
        "; ".join(
            f"{row['style']}: error {row['of alone']:.2f}, gradient {row['gradient']:.2f}, "
            f"outlines {row['outlines']:.2f}, guides {row['guides']:.2f}"
            for row in rows
        )
        or _WITHOUT_DATA,
    )


def _silhouettes(plan):
    found = {}
    for name, study in plan.studies.items():
        for job in study.without_silhouettes:
            how = job.method.coherence
            runs = study.job("ref", how), job, study.alone("ref")
            ours, without, alone = (numbers_of(run)["outlines"] for run in runs)
            found[f"{TITLES[name]}, {how.order}"] = ours / alone, without / alone
    return Claim(
        "Pixels beside something nearer take its motion, and outlines are kept",
        "ours",
        verdict(all(ours >= max(without, LEAST_OUTLINES) for ours, without in found.values()))
        if found else OPEN,
        f"with ref at the settings that are judged the dark share of the outline band is at least "
        f"{LEAST_OUTLINES} of that of frames alone, and not less than without the rule",
        "; ".join(f"{name}: {ours:.2f}, without {without:.2f}"
                  for name, (ours, without) in found.items()) or _WITHOUT_DATA,
    )  # fmt: skip


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
            f"{row['method']}: {row['ratio']:.2f}, and state files {row['state files [s]']:g} s"
            for row in rows
        )
        or "not timed in this preset",
        of_time=True,
    )
