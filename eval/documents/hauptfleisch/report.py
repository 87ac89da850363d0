"""Measure coherent views and animations: chapters 2.4, 3.1 and 3.2 of Hauptfleisch (2020)."""

from pathlib import Path

from data_gen.guides import LIGHT_PASSES
from eval.documents.hauptfleisch.architecture import architecture_scene
from eval.documents.hauptfleisch.goals import GOALS
from eval.documents.hauptfleisch.long_shot import read_turning
from eval.documents.hauptfleisch.page import document
from eval.documents.hauptfleisch.plan import Plan, Study
from eval.documents.hauptfleisch.presets import PRESETS
from eval.documents.hauptfleisch.sintel import FLOW, FRAMES, HIDDEN, read_sintel
from eval.pages.document import make_documents
from eval.pages.options import add_output, folder_of
from eval.read_frames import GUIDES, read_frames
from stylit_ref import InputError

SIZES = {"house": "300x228", "large": "600x456", "animation": "300x228"}
"""Folder in the data, by study."""

SCENES = {"house": "house", "large": "house", "animation": "animation"}
"""Scene of the data set, by study."""

STYLES = {"house": "inked", "large": "inked", "animation": "oil"}
"""What was painted over its source: ink strokes leave the building."""


def add_options(parser):
    """Declare what the report may be told."""
    parser.add_argument(
        "--preset", choices=PRESETS, default="quick",
        help="quick: a few minutes on two idle cores; full: more settings with StyLit, longer "
        "shots, times in turns (default quick)",
    )  # fmt: skip
    parser.add_argument(
        "--data", type=Path, default=Path("build/data"),
        help="folder whose folders 300x228, 600x456 and, for the preset full, 500x500 and 600x500 "
        "are data sets of make data (default build/data)",
    )  # fmt: skip
    parser.add_argument(
        "--sintel", type=Path, metavar="FOLDER",
        help="folder with frames 2 and 3 of alley_1 of MPI Sintel, their flow and occlusions "
        f"({', '.join((*FRAMES, FLOW, HIDDEN))})",
    )  # fmt: skip
    add_output(parser, "hauptfleisch_PRESET")


def main(options):
    """Do the runs and make the report; returns the exit code."""
    return make_documents(prepared(options))


def prepared(options):
    """The document by the folder of its report, for :func:`eval.pages.document.make_documents`."""
    preset, data = PRESETS[options.preset], options.data
    missing = []
    studies = {
        name: Study(name, frames, ways, preset.methods)
        for name, ways in preset.ways.items()
        if (frames := _found(missing, name, _frames, options, name, STYLES.get(name)))
    }
    if not studies:
        raise InputError(f"--data: {'; '.join(missing)}")
    styles, turning, thesis_size = {}, None, None
    if "house" in studies:
        judged = {"ref": tuple(goal.coherence for goal in GOALS["house"])}
        styles = {STYLES["house"]: studies["house"]} | {
            style: Study("house", _frames(options, "house", style), judged, preset.methods)
            for style in preset.styles
        }
    if preset.with_large_times:
        turning = _found(
            missing, "the long shot", read_turning, data / "500x500", STYLES["animation"]
        )
        size = data / "600x500"
        sketch = _found(missing, "the thesis' size", architecture_scene, size, STYLES["house"])
        thesis_size = size if sketch and styles else None
    plan = Plan(
        options.preset, preset, studies, styles, data / SIZES["house"], turning, thesis_size
    )  # fmt: skip
    return {folder_of(options, f"hauptfleisch_{plan.name}"): document(plan, missing)}


def _frames(options, name, style):
    if name == "sintel":
        return read_sintel(options.sintel)
    is_shot = name == "animation"
    return read_frames(
        SCENES[name], style, options.data / SIZES[name],
        LIGHT_PASSES if is_shot else GUIDES,
        PRESETS[options.preset].frames if is_shot else None,
    )  # fmt: skip


def _found(missing, title, read, *arguments):
    """What is read, or None; then it is noted as missing, and why."""
    try:
        return read(*arguments)
    except InputError as error:
        missing.append(f"{title} ({error})")
        return None
