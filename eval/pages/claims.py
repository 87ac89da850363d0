"""Claims of a publication, tested on our numbers: each has a rule, a verdict and figures."""

from typing import NamedTuple

import pandas as pd

from eval.pages.tables import table

HELD, NOT_HELD, OPEN = "held", "not held", "cannot be judged here"

VERDICTS = HELD, NOT_HELD, OPEN


class Claim(NamedTuple):
    """A claim and its verdict.

    Attributes
    ----------
    claim, section : str
        The claim, and the section of the publication where it stands.
    verdict : {"held", "not held", "cannot be judged here"}
    rule : str
        When the claim counts as held.
    evidence : str
        Our figures, or why it cannot be judged; sentences without the last full stop.
    of_time : bool
        Whether the claim is about times.
    """

    claim: str
    section: str
    verdict: str
    rule: str
    evidence: str
    of_time: bool = False


def verdict(held):
    """Held, or not."""
    return HELD if held else NOT_HELD


def majority(votes):
    """Held if more than half of some cases say so."""
    return verdict(sum(votes) > len(votes) / 2)


def by_case(figures):
    """Figures of several cases as a clause: ``3 for bricks, and 4 for canes and glyphs``.

    Parameters
    ----------
    figures : dict of str to str
        What was found, by the case; equal figures are told once.

    Returns
    -------
    str
    """
    cases = {}
    for case, figure in figures.items():
        cases.setdefault(figure, []).append(case)
    *others, last = (f"{figure} for {listed(names)}" for figure, names in cases.items())
    return f"{'; '.join(others)}, and {last}" if others else last


def listed(names):
    """Several things as a sentence lists them.

    Parameters
    ----------
    names : sequence of str

    Returns
    -------
    str
    """
    *others, last = names
    return f"{', '.join(others)} and {last}" if others else last


def verdict_section(claims):
    """The verdicts at a glance, for the head of a page.

    Parameters
    ----------
    claims : list of Claim

    Returns
    -------
    list of str
        Markdown blocks.
    """
    count = {each: sum(claim.verdict == each for claim in claims) for each in VERDICTS}
    rows = [
        {
            "": str(number),
            "claim": claim.claim.removesuffix("."),
            "verdict": claim.verdict,
            "section": claim.section,
        }
        for number, claim in enumerate(claims, 1)
    ]
    return [
        "## Verdicts",
        f"Of {len(claims)} claims {count[HELD]} held and {count[NOT_HELD]} did not; "
        f"{count[OPEN]} cannot be judged here. Further down the same numbers lead to the rule and "
        "the figures of each claim.",
        table(pd.DataFrame(rows)),
    ]


def claims_section(title, claims, report):
    """List claims with their verdicts, rules and figures, and write them as CSV.

    Parameters
    ----------
    title : str
        Heading of the section.
    claims : list of Claim
    report : Report

    Returns
    -------
    list of str
        Markdown blocks.
    """
    return [
        f"## {title}",
        *(
            f"{number}. **{claim.claim.removesuffix('.')}** ({claim.section}): "
            f"**{claim.verdict}**. {claim.evidence[:1].upper()}{claim.evidence[1:]}. *It counts as "
            f"held if {claim.rule}.*"
            for number, claim in enumerate(claims, 1)
        ),
        report.csv("claims", pd.DataFrame(claims).drop(columns="of_time")),
    ]
