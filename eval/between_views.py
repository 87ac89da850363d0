"""Measure views between those of a grid, in every mode of chapter 3.3 of Hauptfleisch (2020)."""

from itertools import pairwise
from time import process_time

import numpy as np
from tqdm import tqdm

from eval.view_paths import Truth, WithoutSilhouettes
from stylit_ref.views.interpolation.axis import Axis
from stylit_ref.views.interpolation.grid import Grid
from stylit_ref.views.interpolation.view_interpolator import MODES, ViewInterpolator

STEP = 0.25
"""Degrees from frame to frame of a path."""

ROUNDS = 3
"""A busy machine disturbs the least of several times least."""

THESIS = "limited, thesis' masks"
"""What the mode is called whose masks know nothing of strokes that leave their thing."""


def along_a_path(views, alone):
    """Every mode along the middle row.

    Parameters
    ----------
    views : ViewInterpolator
        Of at least 3x3 views, with a mesh.
    alone : ViewInterpolator, optional
        The same views, each stylized by itself.

    Yields
    ------
    dict of str to str or float
        ``mode``; ``change`` and ``switch``, the median change of a step and the largest at a
        switch; ``ratio``, the latter over the median of ``limited``; ``sharpness`` and its least
        share of that of ``limited``, ``least``; and ``cpu``, milliseconds of a picture.
    """
    path = _path(views.grid)
    jobs = [(views, mode, mode) for mode in MODES]
    if alone:
        jobs += [(alone, mode, f"{mode}, views stylized alone") for mode in ("limited", "fade")]
    truth, base = Truth(views.geometry), None
    switches = _steps_at_switches(views.grid, path)
    jobs.sort(key=lambda job: job[2] != "limited")
    for each, mode, name in tqdm(jobs, unit="path", disable=None):
        changes, looks = _seen(truth, each, path, mode)
        sharpness = np.array([each.sharpness for each in looks])
        base = base or (np.median(changes), sharpness)
        worst = changes[switches].max()
        yield {
            "mode": name,
            "change": np.median(changes),
            "switch": worst,
            "ratio": worst / base[0],
            "sharpness": sharpness.mean(),
            "least": (sharpness / base[1]).min(),
            "cpu": _cpu(each, path, mode),
        }


def in_the_middle(views):
    """Outlines and ghosts in the middle of the cells around the middle view.

    Parameters
    ----------
    views : ViewInterpolator

    Yields
    ------
    dict of str to str or float
        ``mode``, and the fields of :class:`eval.view_paths.Looks`.
    """
    truth = Truth(views.geometry)
    places = [middle_of_cell(views.grid, row, column) for row in (0, 1) for column in (0, 1)]
    thesis = ViewInterpolator(
        views.grid, WithoutSilhouettes(views.geometry), views.stylized, views.band
    )
    own = [
        truth.looks(views.stylized.pictures[views.grid.frames[r][c]], place_of(views.grid, r, c))
        for r in range(3)
        for c in range(3)
    ]
    yield {"mode": "the views themselves", **_mean(own)}
    for each, mode, name in (
        *((views, mode, mode) for mode in MODES), (thesis, "limited", THESIS),
    ):  # fmt: skip
        yield {
            "mode": name,
            **_mean([truth.looks(each.picture(place, mode), place) for place in places]),
        }


def at_distance(views):
    """Modes along the middle of the middle row, as far as the finest of our grids reaches.

    Parameters
    ----------
    views : ViewInterpolator

    Yields
    ------
    dict of str to str or float
        As :func:`along_a_path` and :func:`in_the_middle`, with the ``degrees`` between views.
    """
    truth, degrees = Truth(views.geometry), views.grid.columns.gaps[0]
    reach = 2.5  # what the finest of our grids covers
    path = [(x, 0.0) for x in np.arange(-reach, reach + STEP / 2, STEP).tolist()]
    for mode in ("image", "nnf", "limited", "fade"):
        changes, looks = _seen(truth, views, path, mode)
        yield {
            "mode": mode,
            "degrees": degrees,
            "change": np.median(changes),
            "switch": changes.max(),
            **_mean(looks),
        }


def left_out(views):
    """The middle view, shown from the corners of the grid, beside what was stylized there.

    Parameters
    ----------
    views : ViewInterpolator

    Yields
    ------
    dict of str to str or float
        ``mode``, ``degrees``, the mean difference ``error``, the share of the gradient that is
        ``kept``, and the outlines, also ``of_views``.
    """
    truth, coarse = Truth(views.geometry), corners_of(views)
    place, frame = place_of(views.grid, 1, 1), views.grid.frames[1][1]
    own = views.stylized.pictures[frame]
    looks = truth.looks(own, place)
    for mode in ("linear", "image", "blend", "nnf", "limited"):
        picture = coarse.picture(place, mode)
        found = truth.looks(picture, place)
        yield {
            "mode": mode,
            "degrees": 2 * views.grid.columns.gaps[0],
            "error": np.abs(picture.astype(int) - own).mean(),
            "kept": found.sharpness / looks.sharpness,
            "outlines": found.outlines,
            "of_views": looks.outlines,
        }


def corners_of(views):
    """The same 3x3 views without those between the corners."""
    grid = views.grid
    columns, rows = (
        Axis((axis.positions[0], axis.positions[2]), axis.unit)
        for axis in (grid.columns, grid.rows)
    )
    frames = tuple(tuple(row[0:3:2]) for row in grid.frames[0:3:2])
    return ViewInterpolator(Grid(columns, rows, frames), views.geometry, views.stylized, views.band)


def _path(grid):
    """From the first to the last view of the middle row."""
    low, high = grid.columns.reach
    y = grid.rows.positions[1] - grid.rows.middle
    return [(x, y) for x in np.arange(low, high + STEP / 2, STEP).clip(low, high).tolist()]


def _steps_at_switches(grid, path):
    """The steps that lie within a fifth of a cell of the middle between two views."""
    found = []
    for step, (here, there) in enumerate(pairwise(path)):
        between = grid.columns.around((here[0] + there[0]) / 2)
        middle = (between.low_at + between.high_at) / 2
        if abs(between.at - middle) <= 0.2 * (between.high_at - between.low_at):
            found.append(step)
    return found


def _seen(truth, views, path, mode):
    """The change of each step along a path, and the looks of each of its pictures."""
    pictures = [views.picture(place, mode) for place in path]
    steps = zip(pairwise(pictures), pairwise(path), strict=True)
    changes = np.array([truth.change(*pair, *places) for pair, places in steps])
    return changes, [truth.looks(*pair) for pair in zip(pictures, path, strict=True)]


def _cpu(views, path, mode):
    """The median over a path of the processor time of a picture, in ms; the least of some runs."""

    def spent(place):
        start = process_time()
        views.picture(place, mode)
        return process_time() - start

    return 1000 * np.median([min(spent(place) for _ in range(ROUNDS)) for place in path[::4]])


def middle_of_cell(grid, row=0, column=0):
    """The place in the middle of a cell of a grid."""
    return tuple(
        (axis.positions[k] + axis.positions[k + 1]) / 2 - axis.middle
        for axis, k in ((grid.columns, column), (grid.rows, row))
    )


def place_of(grid, row, column):
    """The place of a view of a grid."""
    return (
        grid.columns.positions[column] - grid.columns.middle,
        grid.rows.positions[row] - grid.rows.middle,
    )


def _mean(looks):
    return {
        name: np.mean([getattr(each, name) for each in looks])
        for name in ("sharpness", "outlines", "ghosts")
    }
