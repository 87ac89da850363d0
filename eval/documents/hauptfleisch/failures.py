"""Failures that the thesis shows, provoked on purpose, and claims that no number here can judge."""

from eval.documents.hauptfleisch import architecture
from eval.pages.claims import OPEN, Claim
from eval.pages.figures import contact_sheet
from eval.runs.complete import Task
from eval.runs.store import stored

SKETCHES = "two_walls", "unshadowed"
"""Sketches over the house that must go wrong."""


def tasks(data):
    """Their runs with ``--preset architecture``."""
    return [Task(architecture.job(data, style, "architecture"), ()) for style in SKETCHES]


def section(data, report):
    """Blocks of the report: each sketch, the view, and what comes out.

    Parameters
    ----------
    data : Path
    report : Report

    Returns
    -------
    list of str
    """
    return [
        "## Failures, provoked",
        "Above, two walls that all guides see alike, one drawn in brick and one in boards (5.12). "
        "Below, a sketch without a shadow on the ground: what was drawn over little ground has to "
        "fill more of it (5.18).",
        report.figure(
            "failures", "sketch, view, and what comes out", _figure, data, committed=True
        ),
    ]


def _figure(data, file):
    rows = []
    for style in SKETCHES:
        run = architecture.job(data, style, "architecture")
        row = run.scene.style, run.scene.shown_guide, stored(run).image
        rows.append(list(zip((style, "rendered", "stylized"), row, strict=True)))
    contact_sheet(rows, file)


def claims(has_pictures):
    """Claims without a verdict, and why.

    Parameters
    ----------
    has_pictures : bool
        Whether the sketches of :data:`SKETCHES` could be read.

    Returns
    -------
    list of Claim
    """
    seen = (
        "the picture of provoked failures shows it, and no number here tells"
        if has_pictures
        else "the house is not rendered, and no number here tells"
    )
    return [
        Claim(
            "Thin things and their shadow are lost, as crosses on a roof", "Fig. 5.3", OPEN,
            "fewer of the cross' pixels than of other parts are taken from a cross",
            "the chapel that has one is not part of this report; `make data SCENES=chapel` renders "
            "it",
        ),
        Claim(
            "Two walls that look alike to the guides and are drawn differently are mixed",
            "Fig. 5.12", OPEN, "a wall has pixels of both drawings", f"{seen} brick from boards",
        ),
        Claim(
            "A shadow that was drawn small blurs where it covers more", "Fig. 5.18", OPEN,
            "it is less sharp than the painting's",
            f"{seen} a shadow's sharpness from that of its edge",
        ),
        Claim(
            "Six cores make a frame in a fifth of the time of one (312 and 61 seconds)", "4.1.2",
            OPEN, "the ratio of both times is at least 5.1 on six cores",
            "frames would have to be timed alone on a machine of six cores",
            of_time=True,
        ),
        Claim(
            "Neural networks do not keep the artist's strokes", "Fig. 1.1", OPEN,
            "their pictures are farther from the painting by a number that sees strokes",
            "this project has no neural network to compare with",
        ),
    ]  # fmt: skip
