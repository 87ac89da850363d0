"""Measure how many pyramid levels serve at each size, against pictures whose truth is known."""

from collections import defaultdict
from dataclasses import replace

import numpy as np
import pandas as pd
from tqdm import tqdm

from data_gen.manifest import DataError, Manifest
from data_gen.models import TARGETS
from eval.methods.ebsynth import Ebsynth
from eval.methods.stylit_ref import StylitRef
from eval.metrics.spilling import spilling
from eval.number import Number
from eval.pages import options as shared
from eval.pages.figures import contact_sheet
from eval.pages.page import new_report, shown
from eval.pages.tables import table
from eval.provenance import provenance
from eval.runs.job import Job
from eval.runs.local import run
from eval.similarity import SMOOTHED, psnr, smooth_psnr
from eval.truth import load_truth
from stylit_ref import InputError, Params
from stylit_ref.stylization.checks import most_levels

DATA = "build/data/300x228,build/data/450x342,build/data/600x456,build/data/1200x912"
SHOWN = "golem/oil", "golem/watercolour"
"""Scenes with pictures. The first, its wall like the ground, also has the effort of the thesis and
is shown beside ebsynth."""

FEWER = 2
"""How many levels fewer than fit are tried."""

GUIDES = {
    "light": {},
    "light, ID": {"guided": True},
    "alike": {"alike": True},
    "alike, ID": {"alike": True, "guided": True},
}
NUMBERS = {
    "colours": Number("colours [dB]", "{:.2f}"),
    "PSNR": Number("PSNR [dB]", "{:.2f}"),
    "spilled": Number("spilled", "{:.2%}"),
}


def add_options(parser):
    """Declare what the report may be told."""
    parser.add_argument(
        "--scene", metavar="TARGET/STYLE,...",
        help="scenes on the stage, commas between (default: all that a data set holds)",
    )  # fmt: skip
    parser.add_argument(
        "--data", default=DATA, metavar="DIR,...",
        help=f"folders that make data wrote, commas between (default {DATA.replace(',', ', ')})",
    )  # fmt: skip
    parser.add_argument("--ebsynth", help="path of ebsynth, to run it on the scenes with pictures")
    shared.add_seed(parser)
    shared.add_output(parser, "levels")


def main(options):
    """Make the report; returns the exit code."""
    folder = shared.folder_of(options, "levels")
    names = options.scene.split(",") if options.scene else None
    levels_report(options.data.split(","), folder, names, options.ebsynth, options.seed)
    return shown(folder)


def levels_report(data, folder, names=None, ebsynth=None, seed=0):
    """Stylize scenes with several numbers of levels; write pictures, numbers and a page.

    Parameters
    ----------
    data : sequence of str or Path
        Folders of data sets with layers.
    folder : Path
    names : sequence of str, optional
        ``TARGET/STYLE``; by default all on the stage.
    ebsynth : str, optional
        Path of the program.
    seed : int

    Returns
    -------
    pandas.DataFrame
        A row for each run.
    """
    rows, pictures = [], defaultdict(list)
    jobs = [(place, name) for place in data for name in names or _scenes(place)]
    with tqdm(jobs, unit="scene", disable=None) as bar:
        for place, name in bar:
            bar.set_description(f"{name} of {place}")
            for guides, how in GUIDES.items():
                truth = load_truth(name, place, **how)
                guide = f"{name}, {guides}", truth.scene.shown_guide
                sheet = [guide, ("truth", truth.picture)]
                is_shown = name in SHOWN and "guided" not in how
                deeper = is_shown and name == SHOWN[0] and "alike" in how
                for effort, method in _methods(truth.scene, deeper, ebsynth):
                    found, image = _row(truth, method, seed)
                    rows.append({"scene": name, "guides": guides, "effort": effort, **found})
                    if effort != "thesis":
                        sheet.append((_title(rows[-1]), image))
                if is_shown:
                    pictures[truth.scene.size].append(sheet)
    frame = pd.DataFrame(rows)
    with new_report(folder) as report:
        sections = [provenance(), _TEXT]
        for size, sheets in pictures.items():
            name, is_last = f"levels_{size}", size == list(pictures)[-1]
            sections.append(report.figure(name, size, contact_sheet, sheets, committed=is_last))
        fast = frame[frame["effort"] == "fast"]
        sections += [
            "## Means over all scenes, effort of the preset fast",
            table(_shown(_means(fast, ["size", "guides", "levels"]))),
            "## What the last level gives",
            _GAINS,
            table(_gains(fast)),
        ]
        others = frame[frame["effort"] != "fast"]
        if len(others):
            sections += [
                "## One scene, effort of the thesis"
                + (", and ebsynth at its defaults" if ebsynth else ""),
                table(_shown(_means(others, ["size", "guides", "scene", "effort", "levels"]))),
            ]
        sections.append(report.csv("levels", frame))
        report.page("Levels of the pyramid", sections)
    return frame


_TEXT = f"""\
The truth is the program of a style, painted over the target itself.

- **colours**: PSNR of the result to it after both are smoothed by a Gaussian of a {SMOOTHED}th of
  the width, so that single strokes do not count
- **PSNR**: the same without smoothing
- **spilled**: target patches whose source patch is centred on another of the three things (object,
  ground, wall) than they are

Guides:

- **light**: the five light passes
- **alike**: the same passes, but the wall reflects more, so that it is as bright as the ground (by
  the medians of their light); in the lightest places both are one white. Style and truth stay the
  same, since painters look at the light of each thing alone.
- **ID**: the ID guide beside them

The highest number of levels at a size is all that fit: the coarsest still holds a patch."""

_GAINS = """\
Colours with all levels that fit, less those with one level fewer, and less those with the thesis'
6: mean over the scenes, and the scene that loses most or gains least."""


def _scenes(data):
    """All targets of the stage in all styles."""
    try:
        manifest = Manifest.read(data)
    except DataError as error:
        raise InputError(str(error)) from None
    return [
        f"{target}/{style}"
        for target in TARGETS
        if target in manifest.targets
        for style in manifest.styles
    ]


def _methods(scene, deeper, ebsynth):
    """Efforts and methods to run on a scene: ``fast`` alone, or all."""
    sizes = scene.style.shape[:2], scene.target_guides[0].shape[:2]
    most = most_levels(Params().patch_width, *sizes)
    numbers = range(max(most - FEWER, 1), most + 1)
    fast = [("fast", replace(Params.preset("fast"), levels=number)) for number in numbers]
    thesis = [("thesis", Params(levels=number)) for number in numbers if deeper]
    methods = [(effort, StylitRef(params)) for effort, params in fast + thesis]
    if deeper and ebsynth:
        methods.append(("ebsynth", Ebsynth(ebsynth)))
    return methods


def _row(truth, method, seed):
    """Numbers of a run, and its image."""
    result = run(Job(truth.scene, method, seed))
    spilled = np.nan if result.nnf is None else spilling(result.nnf, truth.scene.ids).mean()
    numbers = {
        "size": truth.scene.size,
        "levels": len(result.levels),
        "colours": smooth_psnr(result.image, truth.picture),
        "PSNR": psnr(result.image, truth.picture),
        "spilled": spilled,
    }
    return numbers, result.image


def _title(row):
    what = f"{row['levels']} levels" if row["levels"] else row["effort"]
    return f"{what}: {row['colours']:.1f} dB"


def _means(frame, by):
    """Means of the numbers, in the order in which sizes and guides came."""
    return frame.groupby(by, sort=False)[list(NUMBERS)].mean().reset_index()


def _shown(frame):
    text = frame.astype({"levels": str}).replace({"levels": {"0": ""}})
    for name, (title, form) in NUMBERS.items():
        text[name] = ["" if pd.isna(value) else form.format(value) for value in frame[name]]
        text = text.rename(columns={name: title})
    return text


def _gains(frame):
    """Gains of all levels that fit over fewer, by size and guides."""
    rows = []
    for (size, guides), part in frame.groupby(["size", "guides"], sort=False):
        by_levels = part.pivot(index="scene", columns="levels", values="colours")
        most = max(by_levels)
        row = {"size": size, "guides": guides, "levels": str(most)}
        for title, fewer in (("over one fewer", most - 1), ("over 6", 6)):
            if fewer not in by_levels:
                continue
            gain = by_levels[most] - by_levels[fewer]
            row[f"{title} [dB]"] = f"{gain.mean():+.2f}"
            row[f"{title}, least"] = f"{gain.min():+.2f}, {gain.idxmin()}"
        rows.append(row)
    return pd.DataFrame(rows)
