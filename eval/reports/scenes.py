"""Show a data set: all passes, all styles, and every target in every style."""

from functools import partial
from pathlib import Path

import numpy as np
import pandas as pd
from tqdm import tqdm

from data_gen.guides import to_uint8
from data_gen.manifest import DataError, Manifest
from data_gen.models import TARGETS
from data_gen.multilayer_exr import read_layers
from eval.methods.stylit_ref import StylitRef
from eval.metrics import definitions
from eval.pages import options as shared
from eval.pages.figures import contact_sheet
from eval.pages.measured import COLUMNS, row
from eval.pages.page import new_report, shown
from eval.pages.tables import formatted
from eval.provenance import provenance
from eval.runs.job import Job
from eval.runs.local import run
from eval.scenes import load_scene
from stylit_ref import InputError, read_uint8

SHOWN = (
    "FULL", "LDE", "LSE", "LDDE", "LD12E", "IDMASK", "LIGHTMASK", "FRESNEL", "NORMAL", "POSITION",
    "DEPTH", "WIREFRAME",
)  # fmt: skip


def add_options(parser):
    """Declare what the report may be told."""
    shared.add_data(parser)
    shared.add_seed(parser)
    shared.add_output(parser, "scenes_DATA")


def main(options):
    """Make the report; returns the exit code."""
    folder = shared.folder_of(options, f"scenes_{Path(options.data).resolve().name}")
    scenes_report(options.data, folder, options.seed)
    return shown(folder)


def scenes_report(data, folder, seed=0):
    """Write contact sheets, numbers and a page.

    Parameters
    ----------
    data : str or Path
        Folder of a data set.
    folder : Path
    seed : int

    Returns
    -------
    pandas.DataFrame
    """
    try:
        manifest = Manifest.read(data)
        targets = [target for target in TARGETS if target in manifest.targets]
        house = ["house/source"] if "house/source" in manifest.targets else []
        passes = _passes(manifest, ["source", *targets, *house])
        styles = _styles(manifest)
        house_sheet = _house(manifest) if house else None
    except DataError as error:
        raise InputError(str(error)) from None
    rows, stylized = _stylize(manifest, targets, seed)
    rows_of_house, stylized_house = _stylize(manifest, house, seed)
    frame = pd.DataFrame(rows + rows_of_house)
    made = manifest.recipe
    versions = ", ".join(f"{name} {number}" for name, number in made["versions"].items())
    with new_report(folder) as report:
        sections = [
            provenance(),
            f"Rendered with {made['samples']} samples a pixel, seed {made['seed']}; {versions}.",
            report.figure("passes", "passes", _sheet(240), passes),
            report.figure("styles", "styles", _sheet(600), [styles]),
            report.figure("stylized", "stylized", _sheet(240), stylized, committed=True),
        ]
        if house:
            in_styles = "house in the sphere's styles"
            sections += [
                report.figure("house", "house", _sheet(300), house_sheet, committed=True),
                _HOUSE,
                report.figure(
                    "stylized_house", in_styles, _sheet(240), stylized_house, committed=True
                ),
            ]
        sections += [
            report.table("scenes", frame, formatted(frame[["scene", *COLUMNS, "seconds"]])),
            definitions(COLUMNS),
        ]
        report.page(f"Scenes and styles, {made['size']}", sections)
    return frame


_HOUSE = """\
The house shares neither colours nor light with the red object on the white stage, so in the
sphere's styles its patches find no counterpart: a style for it has to be painted over its own
source view."""


def _sheet(tile):
    """A function that draws a contact sheet with images of this width."""
    return partial(contact_sheet, tile=tile)


def _styles(manifest):
    return [(s, read_uint8(manifest.path(f"source/styles/{s}.png"))) for s in manifest.styles]


def _passes(manifest, places):
    rows = []
    for place in places:
        images = [read_uint8(manifest.path(f"{place}/{name}.png")) for name in SHOWN]
        titles = [f"{place} {name}" for name in SHOWN]
        rows.append(list(zip(titles, images, strict=True)))
    return rows


def _house(manifest):
    """The grid, some passes of the source view, and the middle view's motion fields."""
    rows = [
        [
            (f"source {name}", read_uint8(manifest.path(f"house/source/{name}.png")))
            for name in ("FULL", "IDMASK", "WIREFRAME", "LDDE")
        ]
    ]
    rows += [
        [(f"view {y}_{x}", read_uint8(manifest.path(f"house/{y}_{x}/FULL.png"))) for x in range(3)]
        for y in range(3)
    ]
    middle = 1, 1
    for shown_row, other in zip(rows[1:], ((1, 2), (0, 1), (1, 0)), strict=True):
        name = "{}_{}_to_{}_{}".format(*middle, *other)
        layers = read_layers(manifest.path(f"house/motion/{name}.exr"))
        motion = np.concatenate([layers["MOTION"], np.zeros_like(layers["VISIBLE"])], axis=2)
        shown = (0.5 + 0.5 * motion / np.abs(motion).max()) * layers["VISIBLE"]
        shown_row.append((f"motion {name}", to_uint8(shown)))
    return rows


def _stylize(manifest, targets, seed):
    """Stylize every target in every style: a row of numbers for each, and a sheet of the images."""
    renders = [(t, read_uint8(manifest.path(f"{t}/FULL.png"))) for t in ["source", *targets]]
    rows, sheet = [], [renders]
    with tqdm(total=len(manifest.styles) * len(targets), unit="scene", disable=None) as bar:
        for style in _styles(manifest):
            sheet.append([style])
            for target in targets:
                bar.set_description(f"{target} in {style[0]}")
                scene = load_scene(f"{target}/{style[0]}", manifest.folder)
                job = Job(scene, StylitRef(), seed)
                rows.append({"scene": scene.name, **row(job)})
                sheet[-1].append(("", run(job).image))
                bar.update()
    return rows, sheet
