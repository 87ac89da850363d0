"""Views between those of a grid (3.3, 4.2): every mode, what it hides and what it blurs."""

import hashlib
import sys
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pandas as pd

from eval.between_views import (
    ROUNDS,
    THESIS,
    along_a_path,
    in_the_middle,
    left_out,
    middle_of_cell,
)
from eval.device import processor
from eval.number import Number
from eval.outcome import Outcome
from eval.pages.claims import OPEN, Claim, by_case, verdict
from eval.pages.tables import formatted
from eval.runs.process_cost import process_cost
from eval.runs.store import stored
from stylit_ref.cli import views
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.views.interpolation.of_run import views_of_run

MANIFEST = Path("manifests/house/views.json")
"""In the data set of the house."""

SHOWN = "linear", "image", "blend", "limited"
"""Modes of the pictures that are kept."""

PUBLISHED_RATIO = 2.0
"""60 frames a second of image shifting over 30 of NNF shifting (4.2)."""

NUMBERS = {
    "change": Number("change", "{:.2f}"),
    "switch": Number("at a switch", "{:.2f}"),
    "middle": Number("gradient in the middle", "{:.2f}"),
    "outlines": Number("outlines", "{:.3f}"),
    "ghosts": Number("ghosts", "{:.4f}"),
    "error": Number("beside stylized", "{:.2f}"),
    "kept": Number("of its gradient", "{:.2f}"),
    "cpu": Number("cpu [ms]", "{:.0f}"),
}

_CODE = code_digest(__file__, views, without=("gpu_cuda",))


@dataclass(frozen=True)
class Between:
    """``stylit-ref views`` on the house, with coherence and without, and views between its views.

    Attributes
    ----------
    manifest : str
        Its file.
    digest : str
        Of the manifest and of the mesh.
    """

    manifest: str
    digest: str

    name = "views between"
    cost = 30.0
    alone = True  # it starts a program

    @property
    def code(self):
        """Digest of the command, and of what is measured."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, scene, seed, progress=None):
        """Stylize the grid in both ways, and measure every mode.

        Parameters
        ----------
        scene : FrameSet
            The house, which the manifest names, too.
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The middle of a cell in the modes of :data:`SHOWN`. The history has a row for each
            ``mode``, and the numbers of :data:`NUMBERS`, as far as it has them.
        """
        with TemporaryDirectory() as name:
            folder = Path(name)
            coherent, alone = (
                self._stylized(folder / way, seed, options)
                for way, options in (("coherent", ()), ("alone", ("--coherence", "0")))
            )
            path = pd.DataFrame(along_a_path(coherent, alone)).set_index("mode")
            path = path.rename(columns={"sharpness": "gradient"})
            middle = pd.DataFrame(in_the_middle(coherent)).set_index("mode")
            middle = middle.rename(columns={"sharpness": "middle"})
            beside = pd.DataFrame(left_out(coherent)).set_index("mode")[["error", "kept"]]
            table = path.join(middle, how="outer").join(beside, how="outer")
            place = middle_of_cell(coherent.grid)
            pictures = np.stack([coherent.picture(place, mode) for mode in SHOWN])
        return Outcome(pictures, 0.0, history=table.reset_index(names="mode"))

    def _stylized(self, folder, seed, options):
        command = [sys.executable, "-m", "stylit_ref", "views", "--preset", "fast", "--quiet"]
        command += ["--manifest", self.manifest, "--seed", seed, *options]
        command += ["--run", folder / "run", "--output", folder / "{view}.png"]
        folder.mkdir()
        process_cost(list(map(str, command)))
        return views_of_run(folder / "run")


def method(data):
    """The run of a data set of the house.

    Parameters
    ----------
    data : Path

    Returns
    -------
    Between or None
        None if the data set has no manifest or no mesh.
    """
    manifest, mesh = data / MANIFEST, data / "house/mesh/scene.obj"
    if not (manifest.exists() and mesh.exists()):
        return None
    content = manifest.read_bytes() + mesh.read_bytes()
    return Between(str(manifest), hashlib.sha256(content).hexdigest())


def section(job, report):
    """Blocks of the report: a table, and pictures of the middle of a cell.

    Parameters
    ----------
    job : Job
        The run of :func:`method`; it must be stored.
    report : Report

    Returns
    -------
    list of str
    """
    run = stored(job)
    table = run.history[["mode", *NUMBERS]]
    images = dict(zip(SHOWN, run.image, strict=True))
    text = formatted(table, NUMBERS).replace("nan", "")
    return [
        "## Views between views",
        "Every mode of `stylit-ref view` between the views of the house, which are 5 degrees apart "
        "and stylized with `--preset fast`. In the middle between four views, a blend of shifted "
        "pictures, which blurs, and the limited search (3.3.2):",
        report.pair("between", ("blend", images["blend"]), ("limited", images["limited"])),
        "The closest picture, shifted, and the limited search (3.5, 3.6):",
        report.pair("shifted", ("image", images["image"]), ("limited", images["limited"])),
        report.table("between", table, text),
        "*change* and *at a switch* are the median and the largest change of points along a path, "
        "in steps of 0.25 degrees; *gradient in the middle*, *outlines* and *ghosts*, dark pixels "
        "beside the house and away from it, are those of the middles of cells; *beside stylized* "
        "and *of its gradient* compare the middle view, shown from the corners of the grid, with "
        "the same view stylized (3.8); milliseconds of the processor are of one picture, the least "
        f"of {ROUNDS} runs.",
    ]


def claims(job):
    """What the thesis says of its modes.

    Parameters
    ----------
    job : Job or None
        The run of :func:`method`; it must be stored.

    Returns
    -------
    list of Claim
    """
    found = None if job is None else stored(job).history.set_index("mode")
    return [_claim(found, *each) for each in _CLAIMS]


def _claim(found, claim, section, rule, modes, numbers, holds):
    if found is None:
        return Claim(claim, section, OPEN, rule, "the house, or its mesh, is not rendered")
    told = ". ".join(
        f"{_WORDS[number]} "
        + by_case({mode: NUMBERS[number].form.format(found.loc[mode, number]) for mode in modes})
        for number in numbers
    )
    return Claim(claim, section, verdict(bool(holds(found))), rule, told, numbers == ("cpu",))


_WORDS = {
    "change": "The median change is",
    "switch": "The largest change at a switch is",
    "middle": "The gradient in the middle is",
    "outlines": "The share of outlines is",
    "ghosts": "The share of ghosts is",
    "error": "The error beside the stylized view is",
    "kept": "The share of its gradient is",
    "cpu": "The milliseconds of the processor for a picture are",
}
"""How a claim tells a number."""

_VIEWS = "the views themselves"

_CLAIMS = (
    (
        "Views that were not stylized coherently jump where the closest one changes",
        "3.3, Fig. 3.7",
        "with the limited search the largest change at a switch is at least 1.25 times as large "
        "without coherence",
        ("limited", "limited, views stylized alone"),
        ("switch",),
        lambda f: (
            f.loc["limited, views stylized alone", "switch"] >= 1.25 * f.loc["limited", "switch"]
        ),
    ),
    (
        "Shifting NNFs looks calmer than shifting images",
        "3.3.2, Fig. 3.5",
        "the median change and the largest at a switch are both smaller",
        ("image", "nnf"),
        ("change", "switch"),
        lambda f: (f.loc["nnf", ["change", "switch"]] < f.loc["image", ["change", "switch"]]).all(),
    ),
    (
        "The limited search removes what shifted NNFs leave",
        "3.3.2, Fig. 3.6",
        "the largest change at a switch is smaller, and the gradient in the middle is not",
        ("nnf", "limited"),
        ("switch", "middle"),
        lambda f: (
            f.loc["limited", "switch"] < f.loc["nnf", "switch"]
            and f.loc["limited", "middle"] >= f.loc["nnf", "middle"]
        ),
    ),
    (
        "A blend of the views around blurs",
        "3.3.1",
        "`linear` has at most 0.8 of the views' gradient in the middle between four views",
        ("linear", _VIEWS),
        ("middle",),
        lambda f: f.loc["linear", "middle"] <= 0.8 * f.loc[_VIEWS, "middle"],
    ),
    (
        "A blend of four shifted images hides artefacts and blurs",
        "3.3.1",
        "`blend` changes less at a switch than `image`, and has at most 0.9 of its gradient in the "
        "middle",
        ("image", "blend"),
        ("switch", "middle"),
        lambda f: (
            f.loc["blend", "switch"] < f.loc["image", "switch"]
            and f.loc["blend", "middle"] <= 0.9 * f.loc["image", "middle"]
        ),
    ),
    (
        "Outlines that leave their thing turn into ghosts where masks know only the thing",
        "3.3.1, 5.1, 5.2",
        "with the thesis' masks there are at least 1.5 times as many ghosts as in the views, and "
        "fewer outlines",
        (THESIS, "limited", _VIEWS),
        ("ghosts", "outlines"),
        lambda f: (
            f.loc[THESIS, "ghosts"] >= 1.5 * f.loc[_VIEWS, "ghosts"]
            and f.loc[THESIS, "outlines"] < f.loc[_VIEWS, "outlines"]
        ),
    ),
    (
        "Interpolated views look like stylized ones",
        "Figs. 3.8, 5.5 to 5.8, 5.11 to 5.14, 5.17 to 5.20",
        "the limited search keeps at least 0.9 of the gradient of a view that is left out, and its "
        "error is less than that of a linear blend",
        ("limited", "linear"),
        ("kept", "error"),
        lambda f: (
            f.loc["limited", "kept"] >= 0.9 and f.loc["limited", "error"] < f.loc["linear", "error"]
        ),
    ),
    (
        f"Shifting images is {PUBLISHED_RATIO:g} times as fast as shifting NNFs",
        "4.2.3",
        "a picture of `limited` takes 1.5 to 2.5 times the processor time of one of `image`, by "
        "the least of several rounds; the thesis has 60 and 30 frames a second",
        ("image", "limited"),
        ("cpu",),
        lambda f: 1.5 <= f.loc["limited", "cpu"] / f.loc["image", "cpu"] <= 2.5,
    ),
)
"""Claim, section, rule, modes and numbers that are told, and whether it holds."""
