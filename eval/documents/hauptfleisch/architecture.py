"""Sketches of buildings (2.4.1): the preset ``architecture``, and what each of its choices does."""

from dataclasses import replace
from functools import cache

import numpy as np
import pandas as pd

from data_gen.manifest import DataError, Manifest
from eval.methods.stylit_ref import StylitRef
from eval.metrics import NUMBERS, definitions
from eval.pages.claims import OPEN, Claim, by_case, majority, verdict
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
    "unmodified StyLit": (GUIDES[:4], Params("stylit")),
    "without the wireframe": (tuple(g for g in GUIDES if g != "WIREFRAME"), _PRESET),
    "without the share of 0.9": (GUIDES, replace(_PRESET, budget="hyperbola")),
    "without α": (GUIDES, replace(_PRESET, error_limit=None)),
    "without t": (GUIDES, replace(_PRESET, vote_outliers=0)),
    "with an ID guide": ((*GUIDES, "IDMASK"), _PRESET),
}
"""Guides and parameters: the preset, StyLit as it was published, four runs that each switch one
choice off, and a cure of paint that spills onto what is lit alike."""

THESIS_CPU = 312.0
"""Seconds of one frame of 600x500 on one core of the thesis' processor (4.1.2)."""

GOAL_CPU = 150.0


@cache
def architecture_scene(data, style, guides=GUIDES, target=TARGET):
    """A view of the house, to be drawn as a sketch of another one.

    Parameters
    ----------
    data : Path
        A data set with the scenes ``sketched_house`` and ``house``.
    style : str
        One of the sketches.
    guides : tuple of str
    target : str
        The view, as the data set calls it.

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
            name: tuple(read_uint8(manifest.path(f"{v}/{name}.png")) for v in (SOURCE, target))
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
    """The sketch, the view, and the runs, with the most detailed place of each below."""
    scene = architecture_scene(data, style)
    images = {"sketch": scene.style, "rendered": scene.shown_guide}
    images |= {name: stored(job(data, style, name)).image for name in RUNS}
    grey = scene.shown_guide.astype(float).mean(axis=2)
    place = detailed_window(np.abs(np.diff(grey, axis=1)), 0.3)
    row = list(images.items())
    comparison([row[:3], row[3:6], row[6:]], place, file)


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
        _unmodified(numbers),
        _claim(numbers, "The wireframe keeps lines straight.", "without the wireframe", "crooked"),
        _claim(numbers, "The wireframe keeps lines whole.", "without the wireframe", "lost_lines"),
        _claim(numbers, "α reduces noise on white ground.", "without α", "noise"),
        _claim(
            numbers, "Votes without outliers are sharper.", "without t", "sharpness", least=False
        ),
        _bent(numbers),
    ]


def _unmodified(numbers):
    """Both what the thesis adds α for, and what it adds the wireframe for."""
    found = {
        style: runs.set_index("run").loc[["unmodified StyLit", "architecture"]]
        for style, runs in numbers.dropna(subset=["noise"]).groupby("style", sort=False)
    }
    worse = [
        rows[number].iloc[0] > rows[number].iloc[1]
        for rows in found.values()
        for number in ("noise", "lost_lines")
    ]
    told = {
        style: " and ".join(f"{rows[number].iloc[0]:{form}} to {rows[number].iloc[1]:{form}}"
                            for number, form in (("noise", ".1f"), ("lost_lines", ".1%")))
        for style, rows in found.items()
    }  # fmt: skip
    return Claim(
        "Unmodified StyLit leaves noise on white and loses lines",
        "Fig. 2.2",
        verdict(all(worse)) if found else OPEN,
        "in every sketch both are more than with `--preset architecture`",
        f"from it to the preset noise and lost lines go from {by_case(told)}"
        if found
        else "no sketch has white ground",
    )


def _bent(numbers):
    """Lines of the output over those of the painting."""
    crooked = numbers[numbers["run"] == "architecture"].dropna(subset=["crooked"])
    found = dict(zip(crooked["style"], crooked["crooked"], strict=True))
    return Claim(
        "Straight lines come out bent",
        "Fig. 5.20",
        verdict(min(found.values()) > 1) if found else OPEN,
        "in every sketch they lie farther off straight than those of the painting, although the "
        "wireframe guides",
        "they lie "
        + by_case({style: f"{ratio:.2f} times as far off" for style, ratio in found.items()})
        if found
        else "no sketch has straight lines",
    )


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
        majority([(ours < theirs) == least for ours, theirs in pairs.values()]) if pairs else OPEN,
        f"{NUMBERS[number].title} {'falls' if least else 'rises'} with it in most sketches",
        "with it and without it, it is "
        + by_case(
            {
                style: f"{form.format(ours)} and {form.format(theirs)}"
                for style, (ours, theirs) in pairs.items()
            }
        )
        if pairs
        else "no sketch shows it",
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
        f"{_PRESET.vote_outliers}; StyLit as it was published, with four; runs that each "
        "switch one choice off; and one with a seventh guide that tells parts apart, for paint "
        f"that spills where two of them are lit alike. {scene.size}, seed 0, the house seen 20 "
        "degrees from where it was drawn.",
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
