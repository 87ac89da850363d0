"""The claims of the thesis, and what ours must reach, tested on our numbers."""

from eval.documents.hauptfleisch import (
    angles,
    architecture,
    between,
    failures,
    long_shot,
    turned,
)
from eval.documents.hauptfleisch.claims_of_goals import (
    TITLES,
    WITHOUT_DATA,
    claims_of_goals,
    of,
    said,
)
from eval.documents.hauptfleisch.goals import MOST_GUIDES
from eval.pages.claims import OPEN, Claim, by_case, verdict
from eval.runs.store import numbers_of
from stylit_ref.views.params import PARALLEL, PLAIN, SEQUENTIAL, SWEEPS, Coherence


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
    of_sketches = architecture.claims(architecture.table(plan.data, sketches)) if sketches else []
    if plan.thesis_size is not None:
        of_sketches.append(architecture.claim_of_time(plan.thesis_size, sketches[0]))
    return [
        *of_sketches,
        _alone(plan),
        _promoted(plan),
        _all_at_once(plan),
        _one_after_the_other(plan),
        *(_printed_form(plan, method) for method in ("ref", "stylit")),
        *between.claims(plan.between),
        *angles.claims(plan.data, plan.of_angles),
        *failures.claims(bool(sketches)),
        *([turned.claim(turned.table(plan.data, plan.preset.methods["ref"]))] if sketches else []),
        *claims_of_goals(plan),
        *long_shot.claims(plan.long_shot),
    ]


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
        "the error, and that of the renderings, are "
        + by_case({name: f"{alone:.1f} and {floor:.1f}" for name, (alone, floor) in found.items()})
        if found else WITHOUT_DATA,
    )  # fmt: skip


def _promoted(plan):
    ratios = [
        of(plan, name, "warping", method, way)
        for name, study in plan.studies.items()
        for method, ways in study.ways.items()
        for way in ways
    ]
    return Claim(
        "Taking the difference to the shifted pictures promotes coherence",
        "3.2.1",
        verdict(max(ratios) < 1) if ratios else OPEN,
        "the warping error is smaller than without it at every λ_c, in every order, everywhere",
        f"it is {min(ratios):.2f} to {max(ratios):.2f} times that without it in {len(ratios)} runs"
        if ratios else WITHOUT_DATA,
    )  # fmt: skip


def _orders(plan, study, method="ref"):
    """The share of the warping error that each order leaves at λ_c = 1, as far as they are run."""
    found = {
        order: of(plan, study, "warping", method, Coherence(1.0, order=order))
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
        said(found) or WITHOUT_DATA,
    )


def _one_after_the_other(plan):
    found = _orders(plan, "animation")
    return Claim(
        "In an animation frames are stylized one after the other",
        "3.2.1",
        verdict(found[SEQUENTIAL] <= min(found.values())) if len(found) == 3 else OPEN,
        "`sequential` leaves no more of the warping error than the others, with ref at λ_c = 1",
        said(found) or WITHOUT_DATA,
    )


def _printed_form(plan, method):
    """Weights that add up leave less for the guides."""
    norm, plain = (
        [
            of(plan, "house", number, method, Coherence(0.5, form))
            for number in ("guide_error", "warping")
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
        f"with `plain` it is {plain[0]:.3f} of it and the warping error {plain[1]:.2f}; with "
        f"`norm` they are {norm[0]:.3f} and {norm[1]:.2f}"
        if known else "it is not part of this preset",
    )  # fmt: skip
