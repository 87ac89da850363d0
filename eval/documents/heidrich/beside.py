"""The section on another implementation: times in turns, and energies at both sizes."""

from collections.abc import Callable
from dataclasses import dataclass

import pandas as pd

from eval.documents.heidrich.prototype import COMPARED, ROUNDS, InTurns, Prototype
from eval.documents.heidrich.stage import STYLES
from eval.documents.heidrich.tables import energy
from eval.methods.realtime import Realtime
from eval.pages.claims import Claim, listed, verdict
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.runs.store import stored
from eval.scenes import Scene
from stylit_ref.realtime.params import RealtimeParams

SEEDS = 3
"""Energies are means over so many: with another seed they change by up to 3 %."""

MOST_TIME = {"quick": 0.74, "best": 0.8}
"""Goals: time over the prototype's."""


@dataclass(frozen=True)
class Beside:
    """Ours and the prototype's frames of the same scenes.

    Attributes
    ----------
    file : str
        The prototype.
    scene_of : callable
        The scene of a style at ``side`` x ``side`` pixels.
    sides : tuple of int
    """

    file: str
    scene_of: Callable[[str, int], Scene]
    sides: tuple[int, ...]

    def times(self, side):
        """The run in which both take turns."""
        return Job(self.scene_of("oil", side), InTurns(self.file))

    def pictures(self, style, side, preset):
        """Our runs of a preset, and the prototype's, a list each."""
        scene = self.scene_of(style, side)
        methods = Realtime(preset, RealtimeParams.preset(preset)), Prototype(self.file, preset)
        return [[Job(scene, method, seed) for seed in range(SEEDS)] for method in methods]

    @property
    def tasks(self):
        """All runs."""
        return [Task(self.times(side), ()) for side in self.sides] + [
            Task(job, ("image_energy",))
            for side in self.sides
            for style in STYLES
            for preset in COMPARED
            for jobs in self.pictures(style, side, preset)
            for job in jobs
        ]

    def claims(self):
        """What we ask of ourselves."""
        times = pd.concat([stored(self.times(side)).history for side in self.sides])
        times = times.groupby("preset")["ratio"].max()
        energies = self.table_of_energies()
        worst = energies.loc[energies["ratio"].idxmax()]
        return [
            Claim(
                "Frames take less time than the prototype's",
                "ours",
                verdict(all(times[preset] <= most for preset, most in MOST_TIME.items())),
                "a frame takes at most "
                + listed([f"{most:g} of its time with {name}" for name, most in MOST_TIME.items()])
                + ", at every size, packing included, in turns",
                "it takes at most "
                + listed([f"{times[name]:.2f} of it with {name}" for name in MOST_TIME]),
                of_time=True,
            ),
            Claim(
                "Energies are at most the prototype's",
                "ours",
                verdict(bool((energies["ratio"] <= 1).all())),
                f"they are so with {' and '.join(COMPARED)} in every style at every size, by the "
                f"mean over {SEEDS} seeds",
                f"{(energies['ratio'] <= 1).sum()} of {len(energies)} are; the worst is "
                f"{worst['ratio']:.3f} times the prototype's, with {worst['preset']} in "
                f"{worst['style']} at {worst['size']}",
            ),
        ]

    def sections(self, report):
        """What the page says of it."""
        times, energies = self.table_of_times(), self.table_of_energies()
        return [
            "## Beside another implementation",
            report.table("prototype_times", times, times),
            f"A cold frame of each in turns, on all threads, in oil: medians of {ROUNDS}, and the "
            "median of the ratios of all turns. Our frames begin with the buffers in memory; those "
            "of the prototype are given with its packing and without.",
            report.table("prototype_energies", energies, energies),
            f"Energies of cold frames, means over {SEEDS} seeds; below 1 ours is better.",
        ]

    def table_of_times(self):
        """Milliseconds by size and preset."""
        tables = []
        for side in self.sides:
            table = stored(self.times(side)).history.copy()
            table.insert(0, "size", f"{side}²")
            tables.append(table)
        return pd.concat(tables).rename(columns=_TITLES).round(2)

    def table_of_energies(self):
        """Image energies by size, style and preset."""
        rows = []
        for side in self.sides:
            for style in STYLES:
                for preset in COMPARED:
                    ours, theirs = map(energy, self.pictures(style, side, preset))
                    rows.append(
                        {
                            "size": f"{side}²",
                            "style": style,
                            "preset": preset,
                            "ours": round(ours),
                            "prototype": round(theirs),
                            "ratio": round(ours / theirs, 3),
                        }
                    )
        return pd.DataFrame(rows)


_TITLES = {
    "ours": "ours [ms]",
    "theirs": "prototype [ms]",
    "packed": "without packing [ms]",
    "ratio": "ours over it",
    "ratio_packed": "ours over it without packing",
}
