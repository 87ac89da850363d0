"""Another implementation beside ours, in the same minutes: times in turns, and energies."""

import importlib.util
import time
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
import pandas as pd

from eval.methods.foreign_program import digest_of
from eval.methods.realtime import Realtime
from eval.on_processor import OnProcessor
from eval.outcome import Outcome
from stylit_ref import InputError
from stylit_ref.machine.forks import available_threads
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.realtime.params import RealtimeParams

PAIRS = {
    "quick": "quick",
    "best": "best",
    "simple": "thesis-ev",
    "optimized": "thesis-ov-mip",
}
"""Our presets, and what the prototype calls the same."""

COMPARED = "quick", "best"
"""The presets whose energies are compared."""

ROUNDS = 50
"""Turns in which frames are timed."""


@cache
def prototype_of(file):
    """The module in a Python file.

    It must have ``pack(buffers)`` and ``labels(buffers)``, ``PRESETS``, the options of an engine by
    name, and ``Engine(guides, style, (height, width), ids=(source, target), **options)``, whose
    ``frame(guides)`` makes a picture.

    Raises
    ------
    InputError
        If it cannot be loaded, or lacks one of them.
    """
    if not Path(file).is_file():
        raise InputError(f"--prototype: {file} is not a file; give the path of a Python file")
    spec = importlib.util.spec_from_file_location("prototype", file)
    if spec is None:
        raise InputError(f"--prototype: {file} is no Python file, whose name ends in .py")
    module = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except Exception as error:
        raise InputError(f"--prototype: {file} cannot be loaded: {error}") from None
    missing = [
        name for name in ("Engine", "PRESETS", "pack", "labels") if not hasattr(module, name)
    ]
    if missing:
        raise InputError(f"--prototype: {file} has no {', '.join(missing)}")
    absent = [name for name in PAIRS.values() if name not in module.PRESETS]
    if absent:
        raise InputError(f"--prototype: {file} has no {', '.join(absent)} among its PRESETS")
    return module


@dataclass(frozen=True)
class _OfFile(OnProcessor):
    """What a prototype's file decides too."""

    file: str

    @property
    def code(self):
        """Digest of its file, and of this one."""
        return super().code + digest_of(self.file)


@dataclass(frozen=True)
class Prototype(_OfFile):
    """A cold frame of the prototype.

    Attributes
    ----------
    file : str
    preset : str
        One of ours; :data:`PAIRS` has its name for it.
    """

    preset: str

    cost = 0.2

    @property
    def name(self):
        """What it is, and its preset."""
        return f"prototype, {self.preset}"

    def frames(self, scene, seed, threads=None):
        """An engine that makes frames of the scene."""
        return _Frames(prototype_of(self.file), PAIRS[self.preset], scene, seed, threads)

    def run(self, scene, seed, progress=None):
        """Make a frame."""
        frames = self.frames(scene, seed)
        frames.frame()  # compiles
        before = time.perf_counter()
        image = frames.frame()
        return Outcome(image, time.perf_counter() - before)


class _Frames:
    """An engine, and the buffers of the target."""

    def __init__(self, module, name, scene, seed, threads):
        self._pack, self._seed, self._threads = module.pack, seed, threads
        source, self._target = (
            {buffer: pair[side] for buffer, pair in scene.buffers.items()} for side in (0, 1)
        )
        ids = (
            None if name.startswith("thesis") else tuple(map(module.labels, (source, self._target)))
        )
        self._engine = module.Engine(
            self._pack(source), scene.style, scene.target_guides[0].shape[:2], ids=ids,
            **module.PRESETS[name],
        )  # fmt: skip
        self.packing = 0.0

    def frame(self):
        """A cold frame, packing included; :attr:`packing` is how many seconds that took."""
        with using_threads(self._threads):
            before = time.perf_counter()
            guides = self._pack(self._target)
            self.packing = time.perf_counter() - before
            return self._engine.frame(guides, seed=self._seed + 1)


@dataclass(frozen=True)
class InTurns(_OfFile):
    """Cold frames of ours and of the prototype's one after the other, on all threads.

    Attributes
    ----------
    file : str
    rounds : int
    """

    rounds: int = ROUNDS

    name = "beside the prototype"
    cost = 10.0
    alone = True

    def run(self, scene, seed, progress=None):
        """Make the frames.

        Parameters
        ----------
        scene : Scene
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The history has a row for each preset: ``preset``; medians in milliseconds of ``ours``
            and of the prototype's, with its packing (``theirs``) and without (``packed``); and the
            medians of ``ratio`` and ``ratio_packed`` of each turn. The image is our last one's.
        """
        threads, rows, begun = available_threads(), [], time.perf_counter()
        for preset in PAIRS:
            ours = Realtime(preset, RealtimeParams.preset(preset)).frames(scene, seed, threads)
            theirs = Prototype(self.file, preset).frames(scene, seed, threads)
            spent = np.zeros((self.rounds + 1, 3))
            for turn in spent:
                before = time.perf_counter()
                image = ours.frame()
                between = time.perf_counter()
                theirs.frame()
                other = time.perf_counter() - between
                turn[:] = between - before, other, other - theirs.packing
            spent = 1000 * spent[1:]  # the first turn compiles
            medians = dict(zip(("ours", "theirs", "packed"), np.median(spent, axis=0), strict=True))
            ratios = np.median(spent[:, :1] / spent[:, 1:], axis=0)
            rows.append(
                {"preset": preset, **medians, "ratio": ratios[0], "ratio_packed": ratios[1]}
            )
        return Outcome(image, time.perf_counter() - begun, history=pd.DataFrame(rows))
