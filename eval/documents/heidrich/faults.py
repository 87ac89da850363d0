"""What is wrong with our own pictures: a number for each fault, and what could cure it."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import pandas as pd

from eval.documents.heidrich.fault_crops import crops_of
from eval.documents.heidrich.frame_times import FrameTimes
from eval.documents.heidrich.tables import frame_times
from eval.methods.realtime import Realtime
from eval.methods.stylit_ref import StylitRef
from eval.metrics import NUMBERS, definitions
from eval.pages.figures import contact_sheet
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.runs.store import numbers_of, stored
from eval.scenes import Scene
from stylit_ref.realtime.params import RealtimeParams

VARIANTS = {
    "quick": ("quick", {}),
    "best": ("best", {}),
    "quick, dense finish": ("quick", {"dense_finish": True}),
    "best, dense finish": ("best", {"dense_finish": True}),
    "best, w = 3": ("best", {"patch_width": 3}),
    "best, w = 7": ("best", {"patch_width": 7}),
    "best, r = 5": ("best", {"spacing": 5}),
    "best, twice the iterations": ("best", {"iterations": (2, 6, 8, 16)}),
}
"""Presets, and what is changed of them."""

DENSE = "dense"

RENDERING = "rendering"
"""The source's own rendering as its painting: no paint has smoother edges."""


class Fault(NamedTuple):
    """A fault, the number that measures it, and what was found.

    Attributes
    ----------
    title, number : str
        The metric has the number's name.
    styles : tuple of str
        Those that are measured; of the first there are crops.
    finding : str
        What cures it, or why nothing does.
    """

    title: str
    number: str
    styles: tuple[str, ...]
    finding: str


FAULTS = (
    Fault(
        "Seams on flat ground", "ground_seams", ("pen", "oil"),
        "pieces of the painting end in level or upright lines, which line art shows most. A dense "
        "finish softens them and cannot move them: each pixel chooses among the four entries "
        "around it. More iterations change little. Wider patches leave a few less, and strokes "
        "in shorter pieces. Not cured; where every pixel searches there are fewest.",
    ),
    Fault(
        "Contrast that comes and goes with the grid", "grid_contrast", ("watercolour", "oil"),
        "of nine pixels one has one patch, four have two and four have four, so fine grain is "
        "strongest at every third pixel. Cured by a dense finish, where 25 patches lie over every "
        "pixel; no other width or spacing cures it.",
    ),
    Fault(
        "Ragged edges", "ragged", ("watercolour", RENDERING),
        "the edges of our paintings are ragged themselves, and those of our presets are no more "
        "so. Where the painting has smooth edges, here the rendering itself, steps of the grid "
        "remain. Smoother with a dense finish, which asks every pixel for its label; worse with "
        "a wider grid.",
    ),
    Fault(
        "Strokes in short pieces", "stroke_ends", ("pen",),
        "a stroke ends where its piece does. A dense finish closes some of the gaps. Not cured: "
        "the search compares patches of 5 pixels, and prefers another piece to a stroke that goes "
        "on. Take a dense method for line art.",
    ),
)  # fmt: skip

STYLES = tuple(dict.fromkeys(style for fault in FAULTS for style in fault.styles))

METRICS = tuple(fault.number for fault in FAULTS)


@dataclass(frozen=True)
class Faults:
    """Our presets, what could cure their faults, and the dense method, at the thesis' sizes.

    Attributes
    ----------
    scene_of : callable
        The scene of a style at ``side`` x ``side`` pixels.
    sides : tuple of int
    rounds : int
        In which frames are timed.
    """

    scene_of: Callable[[str, int], Scene]
    sides: tuple[int, ...]
    rounds: int

    def scene(self, style, side):
        """The stage in a style, or in no paint."""
        if style != RENDERING:
            return self.scene_of(style, side)
        scene = self.scene_of("oil", side)
        return replace(scene, name=RENDERING, style=scene.source_guides[0])

    def picture(self, style, side, name):
        """A run of one of :data:`VARIANTS`, or of the dense method."""
        return Job(self.scene(style, side), StylitRef() if name == DENSE else variant(name))

    def times(self, side):
        """The run in which the variants take turns."""
        methods = tuple(map(variant, VARIANTS))
        return Job(self.scene_of("oil", side), FrameTimes("faults", methods, self.rounds))

    @property
    def tasks(self):
        """All runs."""
        return [Task(self.times(side), ()) for side in self.sides] + [
            Task(self.picture(style, side, name), METRICS)
            for side in self.sides
            for style in STYLES
            for name in (*VARIANTS, DENSE)
        ]

    def claims(self):
        """None: the section says what was found."""
        return []

    def sections(self, report):
        """What the page says of them."""
        table = self.table()
        shown = table.copy()
        for fault in FAULTS:
            for style in fault.styles:
                title, form = NUMBERS[fault.number]
                name = f"{fault.number}, {style}"
                shown[name] = shown[name].map(form.format)
                shown = shown.rename(columns={name: f"{title}, {style}"})
        return [
            "## Faults of our own",
            report.table("faults", table, shown.astype(object).fillna("")),
            "Cold frames; milliseconds on one thread in oil, in turns. `dense` is `ref`, which "
            "takes seconds.",
            *(f"- **{fault.title}**: {fault.finding}" for fault in FAULTS),
            report.figure("faults", "crops of each fault", self.draw, committed=True),
            f"Each row is the place where `best` shows a fault most, {self.sides[-1]}²: "
            f"{'; '.join(f'{fault.title} ({fault.styles[0]})' for fault in FAULTS)}.",
            definitions(METRICS),
        ]

    def table(self):
        """The numbers by size and variant."""
        rows = []
        for side in self.sides:
            times = frame_times(self.times(side))["cpu"]
            for name in (*VARIANTS, DENSE):
                row = {"size": f"{side}²", "method": name, "ms": times.round(1).get(name)}
                for fault in FAULTS:
                    for style in fault.styles:
                        found = numbers_of(self.picture(style, side, name))
                        row[f"{fault.number}, {style}"] = found[fault.number]
                rows.append(row)
        return pd.DataFrame(rows)

    def draw(self, file):
        """Crops at the largest size."""
        rows = []
        for fault in FAULTS:
            jobs = {
                name: self.picture(fault.styles[0], self.sides[-1], name)
                for name in ("best", "quick", "best, dense finish", DENSE)
            }
            images = {name: stored(job).image for name, job in jobs.items()}
            best = jobs["best"]
            rows.append(crops_of(fault.number, best.scene, stored(best), images))
        contact_sheet(rows, file, tile=220)


def variant(name):
    """A method of :data:`VARIANTS`."""
    preset, changes = VARIANTS[name]
    return Realtime(name, RealtimeParams.preset(preset, **changes))
