"""What this implementation sets itself, in the form of claims."""

import pandas as pd

from eval.documents.lasram.cut_quality import cut_quality
from eval.documents.lasram.tables import BORDERS, beside_quilting
from eval.pages.claims import OPEN, Claim, by_case, listed, verdict
from eval.runs.store import numbers_of

_FLOWERS = {"seam_cost": 0.005, "sw": 1.7, "largest_piece": 4000}
"""What our defaults are to reach on flowers at 512x512."""


def goals(plan, quality):
    """All of them.

    Parameters
    ----------
    plan : Plan
        Its runs must be stored.
    quality : pandas.DataFrame
        From :func:`eval.documents.lasram.tables.quality`.

    Returns
    -------
    list of Claim
    """
    return [
        _second_pass(plan),
        _first_pass(plan),
        _flowers(plan),
        _tiles(quality),
        _beside_quilting(quality),
    ]


def _second_pass(plan):
    rows = _cuts(plan)
    two = rows[rows["passes"] == "two"]
    worst = (two["mean of ratios"] - 1).abs().max()
    return Claim(
        "With a second pass the cut is the best one, but for 1.2 %",
        "4, ours",
        verdict(worst <= 0.012 and (two["ranked first"] >= 0.95).all()),
        "wherever patches are laid and however cuts are weighed, it is on the mean within 1.2 % of "
        "the optimum and first in 95 %",
        f"at worst it is {worst:.2%} off the optimum, and first in {two['ranked first'].min():.1%}",
    )


def _first_pass(plan):
    rows = _cuts(plan)
    one = rows[(rows["passes"] == "one") & (rows["laid over"] == "E zero")]
    return Claim(
        "One pass is within 3 % of the best cut, but for the worst 5 %",
        "4, ours",
        verdict((one["best 95 %, mean"] <= 1.03).all()),
        "the best 95 % of the cuts of one pass cost on the mean at most 1.03 times the optimum, "
        "with E zero",
        f"they cost {one['best 95 %, mean'].max():.3f} times the optimum",
    )


def _cuts(plan):
    return cut_quality(plan).iloc[1:]


def _flowers(plan):
    claim = Claim(
        "Flowers at 512x512 are done well with our defaults",
        "ours",
        OPEN,
        "with every seed, " + ", ".join(f"{name} is at most {m}" for name, m in _FLOWERS.items()),
        "they are not among the exemplars",
    )
    if "flowers" not in plan.exemplars:
        return claim
    jobs = [plan.default("flowers", seed) for seed in plan.preset.seeds]
    worst = pd.DataFrame([numbers_of(job) for job in jobs])[list(_FLOWERS)].max()
    return claim._replace(
        verdict=verdict(all(worst[name] <= most for name, most in _FLOWERS.items())),
        evidence="at worst " + listed([f"{name} is {worst[name]:.4g}" for name in _FLOWERS]),
    )


def _tiles(quality):
    ours = quality[quality["method"] == "default"].set_index("exemplar")["border"]
    return Claim(
        "The texture is toroidal",
        "3",
        verdict(ours.between(*BORDERS).all()),
        "with our defaults the border is between 0.5 and 1.5 on all exemplars",
        f"the border is {by_case({name: f'{value:.2f}' for name, value in ours.items()})}",
    )


def _beside_quilting(quality):
    table = beside_quilting(quality)
    ratios = table["sw over quilting's"]
    wins = int((ratios <= 1).sum())
    return Claim(
        "The quality is that of patch-based synthesis",
        "1",
        verdict(wins >= len(table) * 2 / 3 and ratios.max() <= 1.5),
        "with our defaults sw is at most image quilting's on two thirds of the exemplars and at "
        "most 1.5 times it elsewhere",
        f"it is at most quilting's on {wins} of {len(table)}, and {ratios.max():.2f} times it at "
        "worst",
    )
