"""Claims of a publication, tested on our numbers: each has a rule, a verdict and figures."""

from typing import NamedTuple

import pandas as pd

HELD, NOT_HELD, OPEN = "held", "not held", "cannot be judged here"


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
        Our figures.
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


def claims_section(title, claims, report):
    """List claims with their verdicts, and write them as CSV.

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
            f"- **{each.claim}** ({each.section}): **{each.verdict}**. {each.evidence}. "
            f"*Held if {each.rule}.*"
            for each in claims
        ),
        report.csv("claims", pd.DataFrame(claims).drop(columns="of_time")),
    ]
