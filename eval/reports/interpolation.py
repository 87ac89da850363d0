"""Measure views between those of a grid (Hauptfleisch 2020, 3.3): every mode along a path."""

from pathlib import Path

import numpy as np
import pandas as pd

from eval.between_views import (
    STEP,
    THESIS,
    along_a_path,
    at_distance,
    corners_of,
    in_the_middle,
    left_out,
    middle_of_cell,
    place_of,
)
from eval.number import Number
from eval.pages import options as shared
from eval.pages.figures import comparison, contact_sheet
from eval.pages.page import new_report, shown
from eval.pages.tables import formatted, table
from eval.provenance import provenance
from eval.view_paths import DARK
from stylit_ref import InputError
from stylit_ref.views.interpolation.mesh_geometry import MeshGeometry
from stylit_ref.views.interpolation.of_run import views_of_run
from stylit_ref.views.interpolation.view_interpolator import MODES
from stylit_ref.views.run_folder import Run

NUMBERS = {
    "change": Number("change", "{:.2f}"),
    "switch": Number("at a switch", "{:.2f}"),
    "ratio": Number("of the median of limited", "{:.2f}"),
    "sharpness": Number("gradient", "{:.2f}"),
    "least": Number("least of limited's", "{:.3f}"),
    "kept": Number("of its gradient", "{:.3f}"),
    "outlines": Number("outlines", "{:.3f}"),
    "of_views": Number("of the views", "{:.3f}"),
    "ghosts": Number("ghosts", "{:.4f}"),
    "error": Number("error", "{:.2f}"),
    "cpu": Number("processor time [ms]", "{:.0f}"),
}


def add_options(parser):
    """Declare what the report may be told."""
    parser.add_argument(
        "--run", required=True, type=Path, metavar="RUN",
        help="what stylit-ref views --run wrote: at least 3x3 views, with a mesh",
    )  # fmt: skip
    parser.add_argument(
        "--alone", type=Path, metavar="RUN", help="the same views, each stylized by itself"
    )
    parser.add_argument(
        "--others", type=Path, nargs=1, action="extend", default=[], metavar="RUN",
        help="the same with views at other distances; may be given more than once",
    )  # fmt: skip
    shared.add_output(parser, "interpolation")


def main(options):
    """Make the report; returns the exit code."""
    folder = shared.folder_of(options, "interpolation")
    views = _opened(options.run)
    alone = _opened(options.alone) if options.alone else None
    others = [_opened(run) for run in options.others]
    with new_report(folder) as report:
        report.page("Views between views", _sections(report, views, alone, others, options.run))
    return shown(folder)


def _opened(run):
    views = views_of_run(run)
    rows, columns = np.shape(views.grid.frames)
    if min(rows, columns) < 3 or not isinstance(views.geometry, MeshGeometry):
        raise InputError(f"{run}: is no grid of at least 3x3 views that holds a mesh")
    return views


def _sections(report, views, alone, others, run):
    yield provenance()
    yield _TEXT
    yield "## Along a row of views"
    path = pd.DataFrame(along_a_path(views, alone))
    yield report.table("path", path, formatted(path, NUMBERS))
    yield "## In the middle between four views"
    middle = pd.DataFrame(in_the_middle(views))
    yield report.table("middle", middle, formatted(middle, NUMBERS))
    yield "## Goals"
    yield table(pd.DataFrame(_goals(path.set_index("mode"), middle.set_index("mode"))))
    yield "## The same path on coarser and finer grids"
    rows = pd.DataFrame(row for each in (*others, views) for row in at_distance(each))
    rows = rows.sort_values(["mode", "degrees"])
    yield report.table("distance", rows, formatted(rows, NUMBERS))
    yield "## Left out"
    yield _LEFT_OUT
    rows = pd.DataFrame(row for each in (*others, views) for row in left_out(each))
    rows = rows.sort_values(["mode", "degrees"])
    yield report.table("left_out", rows, formatted(rows, NUMBERS))
    yield "## Figures"
    place = middle_of_cell(views.grid)
    sheets = [(mode, views.picture(place, mode)) for mode in MODES]
    yield report.figure(
        "modes", "Figure 3.5: every mode in the middle between four views",
        contact_sheet, [sheets[:3], sheets[3:]], committed=True,
    )  # fmt: skip
    pair = [(mode, views.picture(place, mode)) for mode in ("nnf", "limited")]
    yield report.figure(
        "limited", "Figure 3.6: without and with the limited search",
        comparison, [pair], (0.25, 0.3, 0.35, 0.35), committed=True,
    )  # fmt: skip
    if alone:
        sheets = [_at_switch(each, name) for each, name in ((views, "coherent"), (alone, "alone"))]
        yield report.figure(
            "coherence", "Figure 3.7: beside a switch, and where that changes more than 32",
            contact_sheet, sheets, committed=True,
        )  # fmt: skip
    frame = views.grid.frames[1][1]
    stylized = Run(run).picture(frame)
    between = corners_of(views).picture(place_of(views.grid, 1, 1), "limited")
    yield report.figure(
        "stylized", "Figure 3.8: stylized, and shown from views twice as far apart",
        comparison, [[("stylized", stylized), ("between", between)]], (0.25, 0.3, 0.35, 0.35),
        committed=True,
    )  # fmt: skip


def _goals(path, middle):
    """What is asked of a fade and of outlines, and whether it holds."""
    outlines = middle["outlines"] / middle.loc["the views themselves", "outlines"]
    for goal, most, found, holds in (
        ("change at a switch of a fade, of limited's median", "at most 1.2",
         path.loc["fade", "ratio"], path.loc["fade", "ratio"] <= 1.2),
        ("least sharpness of a fade, of limited's", "at least 0.92",
         path.loc["fade", "least"], path.loc["fade", "least"] >= 0.92),
        ("outlines in the middle, of those of the views", "at least 0.52",
         outlines["limited"], outlines["limited"] >= 0.15 / 0.29),
        ("the same with the thesis' masks", "", outlines[THESIS], None),
    ):  # fmt: skip
        verdict = "" if holds is None else "holds" if holds else "does not hold"
        yield {"goal": goal, "asked": most, "found": f"{found:.3f}", "": verdict}


def _at_switch(views, name):
    """Pictures before and after a switch, and where they differ much."""
    across = views.grid.columns
    middle = (across.positions[0] + across.positions[1]) / 2 - across.middle
    one, other = (views.picture((middle + side * 1e-6, 0.0), "limited") for side in (-1, 1))
    differs = np.abs(one.astype(int) - other).max(axis=2) > 32
    marked = np.where(differs[..., None], np.uint8([220, 0, 0]), other)
    return [(f"{name}, before", one), ("after", other), ("changed", marked)]


_TEXT = f"""\
Every mode of `stylit-ref view`, on a finished grid of views.

- **change**: the mean difference of points that two neighbouring frames of a path show, along the
  motion that the mesh tells, in 8-bit steps; the median of all steps, {STEP:g} degrees each
- **at a switch**: the largest within a fifth of the way around the middle between two views
- **gradient**: the mean gradient of luma, down plus across; **least of limited's**: the least
  share of what `limited` has at the same place, over all steps
- **outlines**: the share of pixels that are dark (luma below {DARK}) in a band beside what stands
  on the ground; **ghosts**: their share on the ground farther away
- **processor time**: of a picture on the machine above, the median over the path"""

_LEFT_OUT = """\
The view in the middle of 3x3 is shown from the four corners alone, and compared with what was
stylized there. **error**: the mean absolute difference in 8-bit steps; **of its gradient**: the
share of that view's own; **of the views**: its own outlines."""
