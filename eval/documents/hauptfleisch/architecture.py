"""Sketches of buildings (2.4.1): the preset ``architecture``, and what each of its choices does."""

from dataclasses import replace
from functools import cache

import numpy as np
import pandas as pd

from data_gen.manifest import DataError, Manifest
from eval.methods.stylit_ref import StylitRef
from eval.metrics import NUMBERS, definitions
from eval.pages.claims import Claim, by_case, majority, verdict
from eval.pages.figures import comparison, detailed_window
from eval.read_frames import GUIDES
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.runs.store import numbers_of, stored
from eval.scenes import Scene
from stylit_ref import InputError, Params, read_uint8

METRICS = "sharpness", "straightness", "white_ground"

SHOWN = "noise", "specks", "crooked", "lost_lines", "sharpness", "richness"
"""Numbers of the table."""

SOURCE, TARGET = "sketched_house", "house/1_1"
"""The view that was drawn over, and one that lies 20 degrees to the right and 3 above."""

_PRESET = Params.preset("architecture")

RUNS = {
    "architecture": (GUIDES, _PRESET),
    "without the wireframe": (tuple(g for g in GUIDES if g != "WIREFRAME"), _PRESET),
    "without the share of 0.9": (GUIDES, replace(_PRESET, budget="hyperbola")),
    "without α": (GUIDES, replace(_PRESET, error_limit=None)),
    "without t": (GUIDES, replace(_PRESET, vote_outliers=0)),
    "with an ID guide": ((*GUIDES, "IDMASK"), _PRESET),
}
"""Guides and parameters: the preset, four runs that each switch one choice off, and a cure of paint
that spills onto what is lit alike."""

THESIS_CPU = 312.0
"""Seconds of one frame of 600x500 on one core of the thesis' processor (4.1.2)."""

GOAL_CPU = 150.0


@cache
def architecture_scene(data, style, guides=GUIDES):
    """A view of the house, to be drawn as a sketch of another one.

    Parameters
    ----------
    data : Path
        A data set with the scenes ``sketched_house`` and ``house``.
    style : str
        One of the sketches.
    guides : tuple of str

    Returns
    -------
    Scene

    Raises
    ------
    InputError
        If the data set lacks something, or a file differs from its manifest.
    """
    try:
        manifest = Manifest.read(data)
        style_image = read_uint8(manifest.path(f"{SOURCE}/sketches/{style}.png"))
        passes = {
            name: tuple(read_uint8(manifest.path(f"{v}/{name}.png")) for v in (SOURCE, TARGET))
            for name in (*GUIDES, "IDMASK")
        }
    except DataError as error:
        raise InputError(str(error)) from None
    return Scene(
        name=f"architecture_{style}",
        folder=manifest.folder,
        guide_names=guides,
        style=style_image,
        source_guides=tuple(passes[name][0] for name in guides),
        target_guides=tuple(passes[name][1] for name in guides),
        step=1,
        ids=passes["IDMASK"],
        buffers={name: passes[name] for name in GUIDES if name not in guides},
    )


def job(data, style, name):
    """The run of one of :data:`RUNS`."""
    guides, params = RUNS[name]
    return Job(architecture_scene(data, style, guides), StylitRef(params))


def tasks(data, styles):
    """Every run of some sketches, with the metrics to measure of it."""
    return [Task(job(data, style, name), METRICS) for style in styles for name in RUNS]


def table(data, styles):
    """What each choice does; the runs must be stored.

    Returns
    -------
    pandas.DataFrame
        ``style``, ``run``, the numbers of :data:`SHOWN` as far as a sketch has them, and ``cpu``.
    """
    rows = []
    for style in styles:
        for name in RUNS:
            run = job(data, style, name)
            numbers = numbers_of(run)
            shown = {number: numbers[number] for number in SHOWN if number in numbers}
            rows.append({"style": style, "run": name} | shown | {"cpu": stored(run).stages["cpu"]})
    return pd.DataFrame(rows)


def shown_table(numbers):
    """A table of :func:`table` as text."""
    text = numbers.copy()
    forms = {name: NUMBERS[name].form for name in SHOWN if name in numbers} | {"cpu": "{:.1f}"}
    for name, form in forms.items():
        text[name] = ["" if pd.isna(value) else form.format(value) for value in numbers[name]]
    titles = {name: NUMBERS[name].title for name in SHOWN} | {"cpu": "cpu [s]"}
    return text.rename(columns=titles)


def figure(data, style, file):
    """The sketch, the view, and the five runs, with the most detailed place of each below."""
    scene = architecture_scene(data, style)
    images = {"sketch": scene.style, "rendered": scene.shown_guide}
    images |= {name: stored(job(data, style, name)).image for name in RUNS}
    grey = scene.shown_guide.astype(float).mean(axis=2)
    place = detailed_window(np.abs(np.diff(grey, axis=1)), 0.3)
    row = list(images.items())
    comparison([row[:4], row[4:]], place, file)


def claims(numbers):
    """What the thesis says of its choices.

    Parameters
    ----------
    numbers : pandas.DataFrame
        Of :func:`table`.

    Returns
    -------
    list of Claim
    """
    return [
        _claim(numbers, "The wireframe keeps lines straight.", "without the wireframe", "crooked"),
        _claim(numbers, "The wireframe keeps lines whole.", "without the wireframe", "lost_lines"),
        _claim(numbers, "α reduces noise on white ground.", "without α", "noise"),
        _claim(
            numbers, "Votes without outliers are sharper.", "without t", "sharpness", least=False
        ),
    ]


def _claim(numbers, claim, other, number, least=True):
    """Held if the preset is better than a run without one choice in more than half the sketches."""
    pairs = {
        style: [runs.set_index("run")[number][name] for name in ("architecture", other)]
        for style, runs in numbers.dropna(subset=[number]).groupby("style", sort=False)
    }
    form = NUMBERS[number].form
    return Claim(
        claim,
        "2.4.1",
        majority([(ours < theirs) == least for ours, theirs in pairs.values()]),
        f"{NUMBERS[number].title} {'falls' if least else 'rises'} with it in most sketches",
        "with it and without it is "
        + by_case(
            {
                style: f"{form.format(ours)} and {form.format(theirs)}"
                for style, (ours, theirs) in pairs.items()
            }
        ),
    )


def claim_of_time(data, style):
    """Whether a frame of 600x500 takes at most :data:`GOAL_CPU` seconds of the processor.

    Parameters
    ----------
    data : Path
        A data set of that size; its run must be stored.
    style : str

    Returns
    -------
    Claim
    """
    cpu = stored(job(data, style, "architecture")).stages["cpu"]
    return Claim(
        f"A frame of 600x500 takes {THESIS_CPU:.0f} seconds on one core.",
        "4.1.2",
        verdict(cpu <= GOAL_CPU),
        f"ours takes at most {GOAL_CPU:.0f} seconds of the processor, six search-vote and six "
        "PatchMatch iterations a level",
        f"ours takes {cpu:.0f} seconds",
        of_time=True,
    )


def section(data, styles, report):
    """Blocks of the report: the table and a picture of each sketch.

    Parameters
    ----------
    data : Path
    styles : sequence of str
    report : eval.pages.page.Report

    Returns
    -------
    list of str
    """
    numbers = table(data, styles)
    scene = architecture_scene(data, styles[0])
    return [
        "## Sketches of buildings",
        f"`--preset architecture` (2.4.1, 4.1.2): StyLit with six guides ({', '.join(GUIDES)}), a "
        f"budget of {_PRESET.budget} of all errors, α = {_PRESET.error_limit:g}, t = "
        f"{_PRESET.vote_outliers}; runs that each switch one choice off; and one with a seventh "
        "guide that tells parts apart, for paint that spills where two of them are lit alike. "
        f"{scene.size}, seed 0, the house seen 20 degrees from where it was drawn.",
        report.table("architecture", numbers, shown_table(numbers)),
        *(
            report.figure(
                f"architecture_{style}",
                f"{style}: what each choice does",
                figure,
                data,
                style,
                committed=True,
            )
            for style in styles
        ),
        definitions(SHOWN),
    ]
