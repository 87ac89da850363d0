"""What a data set holds, to be looked at: all passes, all styles, every target in every style."""

import numpy as np
import pandas as pd
from tqdm import tqdm

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
        folder.mkdir(parents=True, exist_ok=True)
        sheets = ["passes", "styles"]
        _passes(manifest, folder)
        contact_sheet(
            folder / "styles.png",
            [[(s, read_uint8(manifest.path(f"source/styles/{s}.png"))) for s in manifest.styles]],
            tile=600,
        )
        if "house/motion" in manifest.pieces:
            sheets.append("house")
            _house(manifest, folder)
    except DataError as error:
        raise InputError(str(error)) from None
    frame = _stylize(manifest, folder, seed)
    made = manifest.recipe
    size = made["size"]
    versions = ", ".join(f"{name} {number}" for name, number in made["versions"].items())
    write_report(
        folder,
        f"Scenes and styles, {size}",
        [
            f"Rendered with {made['samples']} samples a pixel, seed {made['seed']}; {versions}.",
            *[f"![{sheet}]({sheet}.png)" for sheet in [*sheets, "stylized"]],
            table(formatted(frame)),
            DEFINITIONS,
        ],
    )
    return frame


def _targets(manifest):
    """The targets that are there, in the thesis' order, and one view of the house."""
    return [target for target in (*TARGETS, "house/source") if target in manifest.targets]


def _passes(manifest, folder):
    rows = []
    for place in ("source", *_targets(manifest)):
        images = [read_uint8(manifest.path(f"{place}/{name}.png")) for name in SHOWN]
        titles = [f"{place} {name}" for name in SHOWN]
        rows.append(list(zip(titles, images, strict=True)))
    contact_sheet(folder / "passes.png", rows, tile=240)


def _house(manifest, folder):
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
        row.append((f"motion {name}", np.floor(255 * shown + 0.5).astype(np.uint8)))
    contact_sheet(folder / "house.png", rows)


def _stylize(manifest, folder, seed):
    targets, styles = _targets(manifest), manifest.styles
    rows = []
    sheet = [
        [(place, read_uint8(manifest.path(f"{place}/FULL.png"))) for place in ("source", *targets)]
    ]
    with tqdm(total=len(styles) * len(targets), unit="scene", disable=None) as bar:
        for style in styles:
            sheet.append([(style, read_uint8(manifest.path(f"source/styles/{style}.png")))])
            for target in targets:
                bar.set_description(f"{target} in {style}")
                scene = load_scene(f"{target}/{style}", manifest.folder)
                rows.append({"scene": scene.name, **measure(scene, Params(), seed)})
                sheet[-1].append(("", run(scene, Params(), seed).image))
                bar.update()
    contact_sheet(folder / "stylized.png", sheet, tile=240)
    frame = pd.DataFrame(rows)
    frame.to_csv(folder / "scenes.csv", index=False)
    return frame
