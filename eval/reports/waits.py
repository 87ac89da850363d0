"""Measure where people wait, with this version and an older one in turns.

The older version is a checkout (git worktree add FOLDER COMMIT), and the same Python runs both.
Without --before, this version is measured alone.
"""

import json
import os
import subprocess
import sys
from collections.abc import Callable
from contextlib import contextmanager
from itertools import cycle, islice
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import numba
import pandas as pd
from tqdm import tqdm

from eval.methods.ebsynth import write_scene
from eval.pages import options as shared
from eval.pages.page import new_report, shown
from eval.provenance import provenance
from eval.reports.bench import FAST
from eval.runs.busy_programs import spinning_processes
from eval.runs.process_cost import process_cost
from eval.scenes import Scene
from stylit_ref import InputError

PRESET_FAST = "--preset", "fast", "--uniformity", str(FAST["uniformity"])

SMALL, BUSY, HUGE = (228, 300), (1000, 810), (3648, 4800)
GUIDES_WHEN_BUSY = 7
BESIDE = 14
THESIS = "--preset", "thesis"
_THIS = Path(__file__).parents[2]
_MEASURED_PARTS = str(Path(__file__).parents[1] / "runs" / "measured_parts.py")


class Version(NamedTuple):
    """A version of the library: its folder, and that of its compiled kernels."""

    folder: Path
    kernels: Path

    def run(self, images, *options):
        """The cost of ``stylit-ref run``."""
        style, pairs = images
        # Older versions have no stylit_ref.__main__.
        command = [sys.executable, "-m", "stylit_ref.cli", "run", "--quiet", *options]
        command += ["--style", style, "--output", self.kernels / "out.png"]
        for pair in pairs:
            command += ["--guide", *pair]
        return process_cost(list(map(str, command)), self._environment)

    def part(self, name, images, **params):
        """Seconds of a part of a run, of :mod:`eval.runs.measured_parts`."""
        style, pairs = images
        task = json.dumps({"style": style, "pairs": pairs, "params": params}, default=str)
        done = subprocess.run(
            [sys.executable, _MEASURED_PARTS, name, task],
            env=self._environment, stdout=subprocess.PIPE, text=True, check=True,
        )  # fmt: skip
        return float(done.stdout)

    @contextmanager
    def without_kernels(self):
        """The same version on a machine where nothing is compiled."""
        with TemporaryDirectory() as folder:
            yield self._replace(kernels=Path(folder))

    @property
    def _environment(self):
        return os.environ | {
            "PYTHONPATH": str(self.folder), "NUMBA_CACHE_DIR": str(self.kernels),
            "PYTHONSAFEPATH": "1",  # else the version of the current folder would run
        }  # fmt: skip


class Pictures:
    """The scene's files at other sizes, written when they are asked for.

    Parameters
    ----------
    scene : Scene
    folder : Path
    """

    def __init__(self, scene: Scene, folder: Path):
        self._scene, self._folder, self._written = scene, folder, {}

    def at(self, size=None, guides=None):
        """Style and pairs of guides, at (H, W), the guides repeated or left out to be so many."""
        key = size, guides
        if key not in self._written:
            scene = self._scene
            if size:
                scene = scene.resized(size)
            folder = self._folder / str(len(self._written))
            folder.mkdir()
            style, pairs = write_scene(scene, folder)
            self._written[key] = style, list(islice(cycle(pairs), guides or len(pairs)))
        return self._written[key]


def compilation(version, pictures):
    """Seconds that the first run takes longer than the second."""
    with version.without_kernels() as fresh:
        first, later = (fresh.run(pictures.at(SMALL), *PRESET_FAST).seconds for _ in range(2))
    return first - later


def other_channels(version, pictures):
    """The same for a run with one guide, on a machine that has had one with more."""
    with version.without_kernels() as fresh:
        fresh.run(pictures.at(SMALL), *PRESET_FAST)
        one = pictures.at(SMALL, 1)
        first, later = (fresh.run(one, *PRESET_FAST).seconds for _ in range(2))
    return first - later


def fast(version, pictures):
    """Seconds of a whole run."""
    return version.run(pictures.at(), *PRESET_FAST).seconds


def start(version, pictures):
    """Seconds of it that are not synthesis."""
    return fast(version, pictures) - version.part("synthesis", pictures.at(), **FAST)


def busy(version, pictures):
    """Seconds of a run beside busy programs, over those of its fair share of the processors."""
    images = pictures.at(BUSY, GUIDES_WHEN_BUSY)
    processor_seconds = version.run(images, *PRESET_FAST).processor_seconds
    threads = numba.config.NUMBA_NUM_THREADS
    fair = processor_seconds / threads * max(1, (BESIDE + threads) / os.cpu_count())
    with spinning_processes(BESIDE):
        return version.run(images, *PRESET_FAST).seconds / fair


def stylit(version, pictures):
    """Seconds of a whole run."""
    return version.run(pictures.at(), "--method", "stylit", *THESIS).seconds


def stylit_preview(version, pictures):
    """Seconds of a whole run."""
    preview = "--method", "stylit", "--preset", "fast", "--patchmatch-iters", "2"
    return version.run(pictures.at(), *preview).seconds


def huge(version, pictures):
    """Microseconds of a pixel."""
    return version.run(pictures.at(HUGE), *THESIS).seconds / (HUGE[0] * HUGE[1]) * 1e6


def memory(version, pictures):
    """GiB at the most; with few votes, which do not change it."""
    cost = version.run(pictures.at(HUGE), *PRESET_FAST)
    return cost.mebibytes / 1024


def small(version, pictures):
    """Seconds of synthesis alone."""
    return version.part("synthesis", pictures.at(SMALL))


def files(version, pictures):
    """Seconds for reading seven PNGs, writing one, and twelve halvings."""
    images = pictures.at(BUSY, GUIDES_WHEN_BUSY)
    return sum(version.part(name, images) for name in ("reading", "writing", "halving"))


class Wait(NamedTuple):
    """Something that people wait for.

    Attributes
    ----------
    name, told : str
    goal : float
    measure : callable
        Called with a version and pictures; its docstring names the unit.
    runs : int
        So many are made; the least counts.
    """

    name: str
    told: str
    goal: float
    measure: Callable[[Version, Pictures], float]
    runs: int = 3


WAITS = (
    Wait("compilation", "first run, 300x228: compilation [s]", 4, compilation),
    Wait("channels", "another number of channels: compilation [s]", 1, other_channels),
    Wait("start", "later runs: all but synthesis [s]", 0.6, start),
    Wait("fast", "`--preset fast`, the whole process [s]", 1.5, fast),
    Wait("busy", f"810x1000, 7 guides, beside {BESIDE} programs: over the fair time", 1.3, busy, 1),
    Wait("stylit", "`--method stylit` [s]", 25, stylit, 1),
    Wait(
        "stylit_preview",
        "`--method stylit --preset fast --patchmatch-iters 2` [s]",
        25,
        stylit_preview,
    ),
    Wait("huge", "4800x3648, the thesis' configuration: a pixel [µs]", 20, huge, 1),
    Wait("memory", "4800x3648: memory [GiB]", 3, memory, 1),
    Wait("small", "300x228, defaults: synthesis alone [s]", 0.6, small),
    Wait("files", "810x1000: read seven PNGs, write one, halve twelve times [s]", 0.2, files),
)


def add_options(parser):
    """Declare what the report may be told."""
    shared.add_scene(parser, "golem/crayon")
    parser.add_argument(
        "--before", type=Path, metavar="FOLDER", help="checkout of an older version"
    )
    parser.add_argument(
        "--waits", metavar="NAME,...",
        help=f"measure these alone, of {', '.join(wait.name for wait in WAITS)}",
    )  # fmt: skip
    shared.add_output(parser, "waits_SCENE_SIZE")


def main(options):
    """Make the report; returns the exit code."""
    scene = shared.scene_of(options)
    names = options.waits.split(",") if options.waits else [wait.name for wait in WAITS]
    if unknown := set(names) - {wait.name for wait in WAITS}:
        raise InputError(f"--waits: there is no {', '.join(sorted(unknown))}")
    if options.before and not (options.before / "stylit_ref" / "__init__.py").exists():
        raise InputError(f"--before: {options.before} is no checkout: it has no stylit_ref")
    folder = shared.folder_of(options, f"waits_{scene.name}_{scene.size}")
    chosen = [wait for wait in WAITS if wait.name in names]
    frame = measured(scene, chosen, options.before)
    told = frame.map(lambda value: value if isinstance(value, str) else f"{value:.3g}")
    with new_report(folder) as report:
        sections = [
            provenance(),
            report.table("waits", frame, told),
            "Two versions take turns. The least of three runs counts; StyLit, 4800x3648 and the "
            f"run beside busy programs are measured once. The scene has {scene.size} where no size "
            "is named. The fair time of a run beside busy programs: its seconds of the processor, "
            "alone, over its threads, times programs and threads for each processor.",
        ]
        report.page(f"Where people wait, on {scene.name}", sections)
    return shown(folder)


def measured(scene, waits, before=None):
    """Measure waits.

    Parameters
    ----------
    scene : Scene
    waits : sequence of Wait
    before : Path, optional
        Checkout of an older version.

    Returns
    -------
    pandas.DataFrame
        A row for each.
    """
    with TemporaryDirectory() as name:
        versions = {
            label: Version(root.resolve(), _folder(name, label))
            for label, root in (("before", before), ("now", _THIS))
            if root
        }
        pictures = Pictures(scene, _folder(name, "pictures"))
        rows = []
        for wait in tqdm(waits, disable=None):
            values = {label: [] for label in versions}
            for _ in range(wait.runs):
                for label, version in versions.items():
                    values[label].append(wait.measure(version, pictures))
            least = {label: min(found) for label, found in values.items()}
            rows.append({"wait": wait.told, **least, "goal": wait.goal})
    return pd.DataFrame(rows)


def _folder(*parts):
    folder = Path(*parts)
    folder.mkdir()
    return folder
