"""Hatching that turns with its surface: the thesis' first future work, tried with turned copies."""

from functools import cache

import numpy as np
import pandas as pd

from data_gen.camera import GRID, HOUSE_SOURCE
from data_gen.manifest import DataError, Manifest
from eval.documents.hauptfleisch.architecture import SOURCE
from eval.documents.hauptfleisch.goals import LEAST_GRADIENT
from eval.documents.hauptfleisch.turned_copies import Turned, projected_direction
from eval.methods.stylit_ref import StylitRef
from eval.metrics import NUMBERS, definitions
from eval.metrics.guide_fidelity import guide_error
from eval.metrics.off_surface import DIRECTION, FACE
from eval.pages.claims import HELD, Claim, listed, verdict
from eval.pages.figures import comparison
from eval.read_frames import GUIDES
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.runs.store import numbers_of, stored
from eval.scenes import Scene
from stylit_ref import InputError, read_uint8

STYLE = "hatched"

METRICS = "off_surface", "straightness", "sharpness"

SHOWN = "off_surface", "crooked", "lost_lines", "guide_error", "sharpness", "richness"
"""Numbers of the table."""

VIEWS = tuple((row, column) for row in (0, 2) for column in (0, 2))
"""The corners of the house's grid: its front roof turns by 12 to 22 degrees."""

IN_FIGURE = VIEWS[1::2]
"""Those that are farthest from the sketch."""

ANGLES = (-20.0, -10.0, 0.0, 10.0, 20.0)

_WEIGHT = 1.0

ALONE, TOLD, TURNED = "as drawn", "direction told", "turned copies"

MOST_CROOKED, MOST_LOST, MOST_GUIDES = 1.05, 0.01, 1.05
"""By how much lines and guides may be worse: two factors, and a share of the lines."""

LEAST_SHARP = LEAST_GRADIENT**2
"""Sharpness is an energy: what coherence must keep of gradients, squared."""

_ROOF = (0.18, 0.14, 0.36, 0.46)
"""What is shown larger."""


def runs(params):
    """The ways to stylize a view, by name.

    Parameters
    ----------
    params : Params

    Returns
    -------
    dict of str to StylitRef
    """
    return {
        ALONE: StylitRef(params),
        TOLD: Turned(params, weight=_WEIGHT),
        "copies, not told": Turned(params, angles=ANGLES, weight=0.0),
        TURNED: Turned(params, angles=ANGLES, weight=_WEIGHT),
    }


@cache
def turned_scene(data, view):
    """A view of the house whose surfaces' directions are known, to be hatched as its sketch is.

    Parameters
    ----------
    data : Path
        A data set with the scenes ``sketched_house`` and ``house``.
    view : (int, int)
        Row and column of the grid.

    Returns
    -------
    Scene

    Raises
    ------
    InputError
        If the data set lacks something, or a file differs from its manifest.
    """
    places = SOURCE, f"house/{view[0]}_{view[1]}"
    try:
        manifest = Manifest.read(data)
        style = read_uint8(manifest.path(f"{SOURCE}/sketches/{STYLE}.png"))
        passes = {
            name: tuple(read_uint8(manifest.path(f"{place}/{name}.png")) for place in places)
            for name in (*GUIDES, "IDMASK", "NORMAL")
        }
    except DataError as error:
        raise InputError(str(error)) from None
    faces = zip(passes["IDMASK"], passes["NORMAL"], passes["LIGHTMASK"], strict=True)
    return Scene(
        name=f"turned_{STYLE}_{view[0]}_{view[1]}",
        folder=manifest.folder,
        guide_names=GUIDES,
        style=style,
        source_guides=tuple(passes[name][0] for name in GUIDES),
        target_guides=tuple(passes[name][1] for name in GUIDES),
        step=1,
        ids=passes["IDMASK"],
        buffers={
            DIRECTION: tuple(
                projected_direction(normals, camera)
                for normals, camera in zip(
                    passes["NORMAL"], (HOUSE_SOURCE, GRID[view]), strict=True
                )
            ),
            # The planes of a face have the very same normal in every view.
            FACE: tuple(
                np.dstack([part, normal, light[..., 2:] // 128]) for part, normal, light in faces
            ),
        },
    )  # fmt: skip


def tasks(data, params):
    """Every run of every view, with the metrics to measure of it."""
    return [
        Task(Job(turned_scene(data, view), method), METRICS)
        for view in VIEWS
        for method in runs(params).values()
    ]


def table(data, params):
    """What each way gives; the runs must be stored.

    Returns
    -------
    pandas.DataFrame
        ``view``, ``run``, the numbers of :data:`SHOWN`, ``turned``, the share of the pixels that
        was taken from turned copies, and ``cpu``.
    """
    rows = []
    for view in VIEWS:
        scene = turned_scene(data, view)
        for name, method in runs(params).items():
            job = Job(scene, method)
            run, numbers = stored(job), numbers_of(job)
            numbers["guide_error"] = guide_error(run.nnf, scene.source_guides, scene.target_guides)
            shares = (
                run.history[run.history["angle"] != 0]["share"] if "share" in run.history else ()
            )
            rows.append(
                {"view": f"{view[0]}_{view[1]}", "run": name}
                | {number: numbers[number] for number in SHOWN}
                | {"turned": float(sum(shares)), "cpu": run.stages["cpu"]}
            )
    return pd.DataFrame(rows)


def figure(data, params, file):
    """Two views in every way, with the roof below each."""
    rows = []
    for view in IN_FIGURE:
        scene = turned_scene(data, view)
        images = {"sketch": scene.style, "rendered": scene.shown_guide}
        images |= {name: stored(Job(scene, way)).image for name, way in runs(params).items()}
        rows.append(list(images.items()))
    comparison(rows, _ROOF, file)


def claim(numbers):
    """Whether lines improve.

    Parameters
    ----------
    numbers : pandas.DataFrame
        Of :func:`table`.

    Returns
    -------
    Claim
    """
    by_view = numbers.pivot(index="view", columns="run", values="off_surface")
    mean = numbers.drop(columns="view").groupby("run").mean()
    before = mean.loc[[ALONE, TOLD]].min()
    ours = mean.loc[TURNED]
    improve = (
        (by_view[TURNED] < by_view[[ALONE, TOLD]].min(axis=1)).all()
        and ours["crooked"] <= MOST_CROOKED * before["crooked"]
        and ours["lost_lines"] <= before["lost_lines"] + MOST_LOST
        and ours["guide_error"] <= MOST_GUIDES * before["guide_error"]
        and ours["sharpness"] >= LEAST_SHARP * mean.loc[[ALONE, TOLD], "sharpness"].max()
    )
    told = [
        f"{NUMBERS[name].title} of "
        + listed([NUMBERS[name].form.format(mean.loc[run, name]) for run in (ALONE, TOLD, TURNED)])
        for name in ("off_surface", "crooked", "lost_lines", "guide_error", "sharpness")
    ]
    return Claim(
        "Patches turned by the projected direction improve the lines of hatching.",
        "future work",
        verdict(improve),
        f"in every view strokes are nearer to the direction of their surface with turned copies "
        f"than without, told or not, while in the mean lines are at most {MOST_CROOKED:g} times as "
        f"far off straight, at most {100 * MOST_LOST:g} in 100 more are lost, the error of guides "
        f"is at most {MOST_GUIDES:g} times and the sharpness at least {LEAST_SHARP:.2f} times "
        "that of the better of these two",
        f"in the mean of {len(by_view)} views, {ALONE}, {TOLD} and {TURNED} have " + listed(told),
    )


def section(data, params, report):
    """Blocks of the report: what was tried, the table, the figure and what follows.

    Parameters
    ----------
    data : Path
    params : Params
    report : eval.pages.page.Report

    Returns
    -------
    list of str
    """
    numbers = table(data, params)
    held = claim(numbers).verdict == HELD
    return [
        "## Hatching that turns with its surface",
        "Patches keep the angle that they have in the painting, also where the surface turns: the "
        "thesis' first future work. Here no search knows of angles. The sketch stands beside "
        f"copies of itself that are turned by {_listed(ANGLES)} degrees, λ divided by their "
        "number, and a guide of two channels tells in which direction the surface descends as it "
        "is seen (cosine and sine of twice the angle; the x axis on level ground), so that it "
        f"turns with a copy. {params.method}, {turned_scene(data, VIEWS[0]).size}, seed 0, views "
        f"of the house's grid by row and column. *{ALONE}* has neither; *{TOLD}* has the guide and "
        "no copies; *copies, not told* has no guide. *turned* is the share of the pixels that "
        "turned copies gave. Guides are compared with those of the sketch itself; seconds are of "
        "the processor, each run once, without the turning of copies.",
        report.table("turned", numbers, shown_table(numbers)),
        report.figure(
            "turned", "a sketch, and hatching that turns", figure, data, params, committed=True
        ),
        (
            "By the rule above lines improve. It needs no option: `stylit-ref sequence` takes the "
            "copies as several painted frames, and the direction as one more guide."
            if held
            else "By the rule above lines do not improve, and the program has no option for it."
        ),
        definitions(["off_surface"]),
    ]


def shown_table(numbers):
    """A table of :func:`table` as text."""
    text = numbers.copy()
    forms = {name: NUMBERS[name].form for name in SHOWN} | {"turned": "{:.0%}", "cpu": "{:.1f}"}
    for name, form in forms.items():
        text[name] = [form.format(value) for value in numbers[name]]
    return text.rename(columns={name: NUMBERS[name].title for name in SHOWN} | {"cpu": "cpu [s]"})


def _listed(angles):
    return ", ".join(f"{angle:g}" for angle in angles)
