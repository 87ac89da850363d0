"""The claims of the thesis, tested on our numbers; if styles disagree, most of them decide."""

from eval.documents.heidrich.claims_of_ours import claims_of_ours
from eval.documents.heidrich.claims_of_quality import claims_of_quality
from eval.documents.heidrich.claims_of_time import claims_of_time
from eval.documents.heidrich.outlook import TOLERATED
from eval.documents.heidrich.plan import THESIS
from eval.documents.heidrich.tables import energy, fewest, frame_times
from eval.pages.claims import Claim, by_case, listed, verdict


def claims(plan, required):
    """All claims: about time, about pictures, of the outlook, and of our presets.

    Parameters
    ----------
    plan : Plan
        Its runs must be stored.
    required : pandas.DataFrame
        From :func:`eval.documents.heidrich.requirements.requirements`.

    Returns
    -------
    list of Claim
    """
    return [
        *claims_of_time(plan),
        *claims_of_quality(plan),
        _light(required),
        _all_met(required),
        _fewer_buffers(plan),
        _compromise(plan),
        *claims_of_ours(plan),
        *(claim for aside in plan.asides for claim in aside.claims()),
    ]


def _light(required):
    light = required.set_index("method")["light"]
    return Claim(
        "Light is more global than with Lit Sphere",
        "6.3",
        verdict(all(light[method] > light["Lit Sphere"] for method in THESIS)),
        "both methods keep more of the contrast of highlight and cast shadow (requirement 3)",
        "the share kept is "
        + by_case({method: f"{light[method]:.2f}" for method in ("Lit Sphere", *THESIS)}),
    )


def _all_met(required):
    rows = required.set_index("method")
    names = [name for name in rows if name[0].isdigit()]
    missed = {method: [name for name in names if not rows.loc[method, name]] for method in THESIS}
    return Claim(
        "Every requirement of 1.1 is met to a minimum degree",
        "1.1, 6",
        verdict(not any(missed.values())),
        "both methods pass all four thresholds, of which only the first is printed",
        "missed are "
        + by_case({method: listed(m) if m else "none" for method, m in missed.items()}),
    )


def _fewer_buffers(plan):
    table = fewest(plan)
    good = table[table["over all"] <= TOLERATED]
    most = {
        style: min(
            zip(-rows["left out"].map(_count), rows["energy"], rows["left out"], strict=True)
        )
        for style, rows in good.groupby("style")
    }
    return Claim(
        "Buffers can be reduced further",
        "6.3, 7",
        verdict(all(names for *_, names in most.values())),
        f"the simple method's energy stays within {TOLERATED - 1:.0%} with a buffer left out, in "
        "every style that is studied",
        "it does so without "
        + by_case({style: names or "none" for style, (*_, names) in most.items()}),
    )


def _count(names):
    return len(names.split(", ")) if names else 0


def _compromise(plan):
    styles = plan.preset.studied
    hybrid = energy([plan.hybrid(style) for style in styles])
    ours = [energy([plan.picture(style, method) for style in styles]) for method in THESIS]
    side = plan.sides[0]
    times = frame_times(plan.times_of_few(side))["cpu"]
    simple = frame_times(plan.times(side)).loc["simple", "cpu"]
    return Claim(
        "There may be a compromise between both methods",
        "7",
        verdict(hybrid <= min(ours) and times["hybrid"] <= simple),
        "with patches at the finest level and scales elsewhere energy is at most that of either "
        "method, and time at most that of the simple one",
        f"its energy is {hybrid:.0f}, where simple has {ours[0]:.0f} and optimized {ours[1]:.0f}; "
        f"it takes {times['hybrid']:.1f} ms at {side}², where simple takes {simple:.1f} ms and "
        f"optimized {times['optimized']:.1f} ms",
        of_time=True,
    )
