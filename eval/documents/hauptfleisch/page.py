"""The page of the report on the thesis: coherence of grids and animations, and the claims."""

from functools import partial

import numpy as np

from eval.documents.hauptfleisch import (
    angles,
    architecture,
    between,
    failures,
    pictures,
    tables,
    turned,
)
from eval.documents.hauptfleisch.claims import claims
from eval.documents.hauptfleisch.claims_of_goals import TITLES
from eval.documents.hauptfleisch.plan import METRICS
from eval.metrics import METRICS as ALL_METRICS
from eval.metrics import definitions
from eval.pages.claims import claims_section, verdict_section
from eval.pages.document import Document, made_on
from eval.read_frames import GUIDES
from eval.runs.store import stored
from stylit_ref.machine.code_digest import code_digest

_CODE = code_digest(__file__)


def document(plan, missing):
    """The report on a plan.

    Parameters
    ----------
    plan : Plan
    missing : list of str
        Why a study is left out.

    Returns
    -------
    Document
    """
    title = f"Hauptfleisch 2020, preset {plan.name}"
    return Document(title, plan.tasks, partial(_sections, plan, missing), [_CODE, missing])


def _sections(plan, missing, report):
    found = claims(plan)
    return [
        _preface(plan, missing),
        *verdict_section(found),
        *_pictures(plan, report),
        *claims_section("What the thesis says, what ours must reach, and what we found",
                        found, report),
        *(block for study in plan.studies.values() for block in _study(study, report)),
        *_styles(plan, report),
        *(architecture.section(plan.data, plan.sketches, report) if plan.sketches else ()),
        *_turned(plan, report),
        *([] if plan.between is None else between.section(plan.between, report)),
        *(angles.section(plan.data, plan.of_angles, report) if plan.of_angles else ()),
        *(failures.section(plan.data, report) if plan.sketches else ()),
        *_costs(plan, report),
        *_long_shot(plan, report),
        "## What the numbers are",
        definitions([number for name in METRICS for number in ALL_METRICS[name].NUMBERS]),
        *made_on(plan.tasks),
    ]  # fmt: skip


def _pictures(plan, report):
    blocks = ["## Pictures"]
    for name, study in plan.studies.items():
        one, other = pictures.neighbours(study, "ref")
        blocks += [
            f"A point of {TITLES[name]} should look in a neighbour as it does here. The slider "
            "goes from a frame to its neighbour, moved back along its motion: first of frames "
            "alone, then of frames that pull at each other.",
            report.pair(f"{name}_alone", *one),
            report.pair(f"{name}_coherent", *other),
        ]
    return blocks if len(blocks) > 1 else []


def _preface(plan, missing):
    shown = "; ".join(
        f"{TITLES[name]}: {study.frames.frames} frames of {study.frames.size}, {study.frames.name}"
        for name, study in plan.studies.items()
    )
    left_out = " ".join(f"Left out: {reason}." for reason in missing)
    return (
        f"Our house and our stage ({shown}), seed 0. The house has the thesis' six guides "
        f"({', '.join(GUIDES)}), neighbouring views are 5 degrees apart, and the painted view is "
        "15 to 25 degrees away. The thesis' models and styles are not published, and it prints no "
        "number about coherence: its claims are judged by numbers of ours, and goals are ours. "
        "Every error stands between a floor, the renderings themselves, and a ceiling, frames "
        "stylized alone. "
        f"{_effort(plan.preset)} {left_out}".strip()
    )


def _effort(preset):
    params = preset.methods["ref"]
    votes = ", ".join(map(str, np.atleast_1d(params.votes)))
    return (
        f"Search-vote iterations (the finest level first): {votes}; PatchMatch iterations: "
        f"{params.patchmatch_iterations}; α of StyLit: {preset.methods['stylit'].error_limit:g}."
    )


def _study(study, report):
    table = tables.ways(study)
    blocks = [
        f"## {TITLES[study.name].capitalize()}",
        report.table(study.name, table, tables.shown(table)),
        "*of alone* is the warping error over that of frames alone. *of floor* is the error over "
        "that of the renderings, both for a gradient of 1: motion ends between pixels, so that "
        "even what moves exactly differs by up to half a pixel, the more the steeper it is. Paint "
        "can be below 1: it has no lights that wander, and may follow how shifts are rounded. "
        "Seconds of the processor are of all frames, each run once, state files included; below "
        "they are compared in turns.",
    ]
    for method in study.ways:
        for name, caption, draw in (
            ("views", "views side by side", pictures.views_figure),
            ("crops", "the same points in two views", pictures.crops_figure),
            ("changes", "what changes between two views", pictures.changes_figure),
            ("preview", "frames alone, and coherent ones", pictures.preview),
        ):
            blocks.append(
                report.figure(
                    f"{study.name}_{method}_{name}", f"{method}: {caption}", draw, study, method,
                    committed=name in ("crops", "changes"),
                )
            )  # fmt: skip
    return [
        *blocks,
        f"Changes are shown {pictures.STRENGTH} times larger; grey is what the neighbour does not "
        "show. Previews run forth and back, frames alone to the left.",
    ]


def _styles(plan, report):
    table = tables.styles(plan)
    if len(table) < 2:
        return []
    return [
        "## Every style of the house",
        report.table("styles", table, table.round(2).astype(str)),
        "With ref, at the setting that is judged. *alone* and *coherent* are warping errors; "
        "*floor* is what the renderings would have if they were as steep. Gradient, outlines and "
        "guides are over those of frames alone.",
        report.figure("styles", "every style", pictures.styles_figure, plan, committed=True),
    ]


def _turned(plan, report):
    if not plan.sketches:
        return []
    return turned.section(plan.data, plan.preset.methods["ref"], report)


def _costs(plan, report):
    table = tables.costs(plan)
    if table.empty:
        return []
    return [
        "## What coherence costs",
        report.table("costs", table, table.astype(str)),
        f"Seconds of the processor for all frames, the least of {plan.preset.rounds}, in turns "
        "with frames alone, kernels compiled; what states cost to write and read stands apart.",
    ]


def _long_shot(plan, report):
    if plan.long_shot is None:
        return []
    history = stored(plan.long_shot).history
    return [
        "## A long shot",
        report.table("long_shot", history, history.round(2).astype(str)),
        "100 frames of 960x544, `stylit-ref sequence --preset fast`, one after the other, with "
        f"{len(plan.turning.guides[0])} guides: seconds by the clock and of the processor, files "
        "and start included, kernels compiled; MiB of memory; MB of the work folder at the end; "
        "warping errors of the frames that were stylized without motion, too. The frames are those "
        "of a figure that turns, rendered at 500x500, stretched, forth and back.",
        report.figure("long_shot", "four of the frames", pictures.long_shot_figure, plan),
    ]
