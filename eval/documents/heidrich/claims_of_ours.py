"""What we ask of our own presets, which the thesis does not have."""

from eval.documents.heidrich.tables import frame_times, hand_times
from eval.flicker import LARGEST_RISE
from eval.pages.claims import OPEN, Claim, listed, verdict
from eval.runs.store import stored

GOALS = {
    ("quick", "cold"): (8.0, 28.0),
    ("best", "cold"): (14.0, 44.0),
    ("quick", "warm"): (6.0, 22.0),
    ("best", "warm"): (6.0, 22.0),
    ("best", "stroke"): (12.0, 42.0),
}
"""Milliseconds of a preset and what is waited for, at most, by the sides of table 1."""

OPTIMIZED_GOAL = 43.0
"""Milliseconds of the thesis' optimized method at 1000x1000: those of its graphics card."""


def claims_of_ours(plan):
    """These claims.

    Parameters
    ----------
    plan : Plan

    Returns
    -------
    list of Claim
    """
    return [_waits(plan), _optimized(plan), _calm(plan)]


def _waits(plan):
    times = hand_times(plan).set_index(["preset", "waited for"])
    found = {
        (*key, side): (times.loc[key, f"{side}², median [ms]"], goal)
        for key, goals in GOALS.items()
        for side, goal in zip(plan.sides, goals, strict=True)
    }
    return Claim(
        "A hand waits for no more than a few hundredths of a second",
        "ours",
        verdict(all(median <= goal for median, goal in found.values())),
        "the median of every wait is at most its goal, on all threads of two or more processors",
        "it is "
        + listed(
            [
                f"{median:.1f} of {goal:g} ms for {preset} {kind} at {side}²"
                for (preset, kind, side), (median, goal) in found.items()
            ]
        ),
        of_time=True,
    )


def _optimized(plan):
    side = plan.sides[-1]
    wall = frame_times(plan.times(side)).loc["optimized", "wall"]
    return Claim(
        "The thesis' optimized method is as fast on a processor as it was on its graphics card",
        "ours",
        verdict(wall < OPTIMIZED_GOAL),
        f"a frame of the larger size takes less than {OPTIMIZED_GOAL:g} ms, on all threads of two "
        "or more processors",
        f"it takes {wall:.1f} ms at {side}²",
        of_time=True,
    )


def _calm(plan):
    claim = "Warm frames of a turning target stay calm and still show what they should"
    rule = (
        "with every preset warm frames flicker less than cold ones, the last one's energy is at "
        f"most {LARGEST_RISE:g} times that of a cold one, and a first frame that is kept fails"
    )
    if plan.turning is None:
        return Claim(claim, "ours", OPEN, rule, "the turning target is not rendered")
    history = stored(plan.turning).history
    evidence, held = [], True
    for preset, rows in history.groupby("preset", sort=False):
        rows = rows.set_index("frames")
        cold, warm, kept = (rows.loc[way] for way in ("cold", "warm", "the first, kept"))
        held &= warm["flicker"] < cold["flicker"] and warm["holds"] and not kept["holds"]
        evidence.append(
            f"With {preset} warm frames flicker by {warm['flicker']:.2f} and cold ones by "
            f"{cold['flicker']:.2f}; the energy is {warm['rise']:.3f} times a cold frame's, and "
            f"{kept['rise']:.3f} times if the first frame is kept"
        )
    return Claim(claim, "ours", verdict(bool(held)), rule, ". ".join(evidence))
