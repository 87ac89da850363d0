"""What a data set holds, to be looked at: all passes, all styles, every target in every style."""

import numpy as np
import pandas as pd
from tqdm import tqdm

from data_gen.guides import to_uint8
from data_gen.manifest import DataError, Manifest
from data_gen.models import TARGETS
from data_gen.multilayer_exr import read_layers
from eval.figures import contact_sheet
from eval.measures import DEFINITIONS, formatted, measure
from eval.report import table, write_report
from eval.runs import run
from eval.scenes import load_scene
from stylit_ref import InputError, Params, read_uint8

SHOWN = (
    "FULL", "LDE", "LSE", "LDDE", "LD12E", "IDMASK", "LIGHTMASK", "FRESNEL", "NORMAL", "POSITION",
    "DEPTH", "WIREFRAME",
)  # fmt: skip


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
        folder.mkdir(parents=True, exist_ok=True)
        _passes(manifest, ["source", *targets, *house], folder / "passes.png")
        contact_sheet(folder / "styles.png", [_styles(manifest)], tile=600)
        if house:
            _house(manifest, folder / "house.png")
    except DataError as error:
        raise InputError(str(error)) from None
    rows = _stylize(manifest, targets, seed, folder / "stylized.png")
    if house:
        rows += _stylize(manifest, house, seed, folder / "stylized_house.png")
    frame = pd.DataFrame(rows)
    frame.to_csv(folder / "scenes.csv", index=False)
    made = manifest.recipe
    versions = ", ".join(f"{name} {number}" for name, number in made["versions"].items())
    write_report(
        folder,
        f"Scenes and styles, {made['size']}",
        [
            f"Rendered with {made['samples']} samples a pixel, seed {made['seed']}; {versions}.",
            *[f"![{sheet}]({sheet}.png)" for sheet in ("passes", "styles", "stylized")],
            *[_HOUSE] * bool(house),
            table(formatted(frame)),
            DEFINITIONS,
        ],
    )
    return frame


_HOUSE = """\
![house](house.png)

The house shares neither colours nor light with the red object on the white stage, so in the
sphere's styles its patches find no counterpart: a style for it has to be painted over its own
source view.

![house in the sphere's styles](stylized_house.png)"""


def _styles(manifest):
    return [(s, read_uint8(manifest.path(f"source/styles/{s}.png"))) for s in manifest.styles]


def _passes(manifest, places, file):
    rows = []
    for place in places:
        images = [read_uint8(manifest.path(f"{place}/{name}.png")) for name in SHOWN]
        titles = [f"{place} {name}" for name in SHOWN]
        rows.append(list(zip(titles, images, strict=True)))
    contact_sheet(file, rows, tile=240)


def _house(manifest, file):
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
    for row, other in zip(rows[1:], ((1, 2), (0, 1), (1, 0)), strict=True):
        name = "{}_{}_to_{}_{}".format(*middle, *other)
        layers = read_layers(manifest.path(f"house/motion/{name}.exr"))
        motion = np.concatenate([layers["MOTION"], np.zeros_like(layers["VISIBLE"])], axis=2)
        shown = (0.5 + 0.5 * motion / np.abs(motion).max()) * layers["VISIBLE"]
        row.append((f"motion {name}", to_uint8(shown)))
    contact_sheet(file, rows)


def _stylize(manifest, targets, seed, file):
    """Every target in every style: a row of numbers each, and a sheet of the images."""
    renders = [(t, read_uint8(manifest.path(f"{t}/FULL.png"))) for t in ["source", *targets]]
    rows, sheet = [], [renders]
    with tqdm(total=len(manifest.styles) * len(targets), unit="scene", disable=None) as bar:
        for style in _styles(manifest):
            sheet.append([style])
            for target in targets:
                bar.set_description(f"{target} in {style[0]}")
                scene = load_scene(f"{target}/{style[0]}", manifest.folder)
                rows.append({"scene": scene.name, **measure(scene, Params(), seed)})
                sheet[-1].append(("", run(scene, Params(), seed).image))
                bar.update()
    contact_sheet(file, sheet, tile=240)
    return rows
