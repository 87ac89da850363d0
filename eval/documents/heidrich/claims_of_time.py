"""The thesis' claims about time: milliseconds on the processor of one thread, median of many."""

import numpy as np

from eval.documents.heidrich.plan import LEFT_OUT, THESIS
from eval.documents.heidrich.printed import INTERACTIVE, REAL_TIME, milliseconds
from eval.documents.heidrich.tables import frame_times
from eval.pages.claims import OPEN, Claim, by_case, listed, verdict


def claims_of_time(plan):
    """These claims, in the order of the thesis.

    Parameters
    ----------
    plan : Plan
        Its runs must be stored, and it must have both sides of table 1.

    Returns
    -------
    list of Claim
    """
    return [
        _halves(plan),
        *(_saves(plan, saving) for saving in ("packing", "scale space")),
        _faster(plan),
        _real_time(plan),
        _interactive(plan),
        _resolution(plan),
        _scales(plan),
        _square(plan),
        _linear(plan),
    ]


def _cpu(plan, side, method):
    return frame_times(plan.times(side)).loc[method, "cpu"]


def _lacking(plan, side, savings):
    return frame_times(plan.times_of_savings(side))["cpu"].iloc[LEFT_OUT.index(savings)]


def _halves(plan):
    """μ = 0 and μ = 1 on four of six levels."""
    ratios = {}
    for side in plan.sides:
        ratios[f"optimized {side}²"] = _lacking(plan, side, ()) / _lacking(
            plan, side, ("unread terms",)
        )
        ratios[f"simple {side}²"] = _lacking(plan, side, ("scale space",)) / _lacking(
            plan, side, ("scale space", "unread terms")
        )
    return Claim(
        "Leaving unread terms out halves the cost",
        "4.2.4",
        verdict(max(ratios.values()) <= 0.6),
        "a frame takes at most 0.6 of the time that it takes with both terms read, with both "
        "methods and at both sizes",
        f"it takes {by_case({name: f'{ratio:.2f}' for name, ratio in ratios.items()})}",
        of_time=True,
    )


def _saves(plan, saving):
    ratios = {
        side: _lacking(plan, side, (saving,)) / _lacking(plan, side, ()) for side in plan.sides
    }
    of = {"packing": ("4.2.2", "Packing"), "scale space": ("4.2.3", "The scale space")}
    section, subject = of[saving]
    return Claim(
        f"{subject} saves time",
        section,
        verdict(min(ratios.values()) > 1.05),
        "without it the optimized method takes at least 5 % longer at both sizes",
        "it takes "
        + listed([f"{ratio:.2f} times as long at {side}²" for side, ratio in ratios.items()]),
        of_time=True,
    )


def _faster(plan):
    ratios = {
        side: _cpu(plan, side, "simple") / _cpu(plan, side, "optimized") for side in plan.sides
    }
    printed = {
        side: milliseconds("simple", side) / milliseconds("optimized", side) for side in ratios
    }
    return Claim(
        "The optimized method is superior in time",
        "6.1",
        verdict(min(ratios.values()) > 1.05),
        "the simple method takes at least 5 % longer at both sizes",
        "it takes "
        + listed(
            [
                f"{ratio:.2f} times as long at {side}², where the thesis has {printed[side]:.2f}"
                for side, ratio in ratios.items()
            ]
        ),
        of_time=True,
    )


def _real_time(plan):
    rates = {side: 1000 / _cpu(plan, side, "optimized") for side in plan.sides}
    return Claim(
        "The optimized method runs in real time at both sizes",
        "6.1",
        verdict(min(rates.values()) > REAL_TIME),
        f"more than {REAL_TIME:g} frames a second, here on one core",
        "it makes " + listed([f"{rate:.1f} at {side}²" for side, rate in rates.items()]),
        of_time=True,
    )


def _interactive(plan):
    side = plan.sides[-1]
    rate = 1000 / _cpu(plan, side, "simple")
    return Claim(
        "The simple method is interactive, not real time, at the larger size",
        "6.1",
        verdict(INTERACTIVE <= rate <= REAL_TIME),
        f"{INTERACTIVE:g} to {REAL_TIME:g} frames a second, here on one core",
        f"it makes {rate:.1f} at {side}²",
        of_time=True,
    )


def _growth(times, sizes):
    """The exponent with which times grow with sizes, least squares."""
    return float(np.polyfit(np.log(sizes), np.log(times), 1)[0])


def _of_width(plan, side):
    times = frame_times(plan.times_of_widths(side))["cpu"].to_numpy()
    return _growth(times, np.square(plan.preset.widths))


def _of_depth(plan, side):
    times = frame_times(plan.times_of_depths(side))["cpu"].to_numpy()
    return _growth(times, plan.preset.depths)


def _of_resolution(plan, method):
    return _growth(
        [_cpu(plan, side, method) for side in plan.sides], [side**2 for side in plan.sides]
    )


def _resolution(plan):
    pixels = {method: _of_resolution(plan, method) for method in THESIS}
    width = max(_of_width(plan, side) for side in plan.sides)
    depth = max(_of_depth(plan, side) for side in plan.sides)
    return Claim(
        "Resolution costs most with both methods",
        "6.1",
        verdict(pixels["simple"] > width and pixels["optimized"] > depth),
        "time grows with a higher power of the number of pixels than of w² (simple) and of D "
        "(optimized)",
        f"the simple method's grows as pixels^{pixels['simple']:.2f} and (w²)^{width:.2f}, the "
        f"optimized one's as pixels^{pixels['optimized']:.2f} and D^{depth:.2f}",
        of_time=True,
    )


def _scales(plan):
    small, large = plan.sides[0], plan.sides[-1]
    growth = {m: _cpu(plan, large, m) / _cpu(plan, small, m) for m in THESIS}
    printed = {m: milliseconds(m, large) / milliseconds(m, small) for m in THESIS}
    return Claim(
        "The simple method scales worse with resolution than the optimized one",
        "6.1",
        verdict(growth["simple"] > 1.05 * growth["optimized"]),
        "from the smaller to the larger size its time grows by a factor at least 5 % larger",
        "it grows "
        + listed([f"{growth[m]:.2f} times with {m} (printed: {printed[m]:.2f})" for m in THESIS]),
        of_time=True,
    )


def _square(plan):
    exponents = {side: _of_width(plan, side) for side in plan.sides}
    return Claim(
        "w² follows in its effect on time",
        "6.1",
        verdict(min(exponents.values()) >= 0.5),
        "the simple method's time grows at least with the root of w² at both sizes",
        "it grows as "
        + listed([f"(w²)^{value:.2f} at {side}²" for side, value in exponents.items()])
        + "; the grid thins as w grows: its entries lie (w + 1) / 2 apart, so that w² pixels are "
        "compared at 4 / (w + 1)² of all places",
        of_time=True,
    )


def _linear(plan):
    exponents = {side: _of_depth(plan, side) for side in plan.sides}
    return Claim(
        "The optimized method scales linearly rather",
        "6.1",
        verdict(max(exponents.values()) <= 1.1) if exponents else OPEN,
        "its time grows at most with the power 1.1 of D at both sizes",
        "it grows as " + listed([f"D^{value:.2f} at {side}²" for side, value in exponents.items()]),
        of_time=True,
    )
