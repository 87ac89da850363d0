"""Which runs the tables and figures of the thesis need."""

import re
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from eval.documents.dzurenko.printed import EPSILONS, TARGETS, UNIFORMITIES
from eval.methods.image_analogies import ImageAnalogies
from eval.methods.stylit_ref import StylitRef
from eval.metrics import METRICS
from eval.pages.gpu_records import gpu_records
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.scenes import BUNDLED, Scene, load_scene
from stylit_ref import InputError, Params, read_uint8
from stylit_ref.formulae.patch_penalization import omega_best
from stylit_ref.metric.packing import ONE

STYLES = {
    "stego": "crayon",
    "scorpion": "watercolour",
    "hand": "pen",
    "teapot": "oil",
    "helmet": "crayon",
    "pumpkin": "watercolour",
    "golem": "oil",
}
"""The style of each target in every table; we may not use the exemplars of the thesis."""

BACKGROUND = "golem"
"""The target of the figures that show a single one (1.1 and 2.3); it is run with three seeds."""

ROUNDS = 2
"""How often a run is done whose time is judged: that of the first seed, but for StyLit."""

PRESETS = {"quick": BUNDLED, "thesis": Path("build/data/1200x912")}
"""Data set of each preset; the second is made by ``make data``."""

WITHOUT_ENERGY = tuple(name for name in METRICS if name != "image_energy")
"""Metrics of guide maps: without image energy, which no table shows for them."""


@dataclass(frozen=True)
class Plan:
    """Scenes and seeds, and the runs on them.

    Attributes
    ----------
    name : str
    scenes : dict of str to Scene
        By target.
    seeds : dict of str to tuple of int
        By target; the first is the default of a run.
    backend : {"cpu", "cuda"}
    scheduler : str, optional
        Address of the Dask scheduler whose cluster does the runs: times are not of this machine.
    """

    name: str
    scenes: dict[str, Scene]
    seeds: dict[str, tuple[int, ...]]
    backend: str = "cpu"
    scheduler: str | None = None

    @property
    def background(self):
        """Target of the figures that show one alone."""
        return BACKGROUND if BACKGROUND in self.scenes else next(iter(self.scenes))

    def ref(self, target, uniformity=10000, seed=None):
        """The run of ``ref`` with this λ."""
        return self._ours(target, seed, uniformity=uniformity)

    def omega_kept(self, target):
        """``ref`` with the least λ above 0: in effect λ = 0, but Ω is read and written."""
        scene = self.scenes[target]
        width = Params().patch_width
        size = (np.prod(image.shape[:2]) for image in (scene.style, scene.target_guides[0]))
        least = width**2 * omega_best(width, *size) / ONE
        return self._ours(target, uniformity=float(least))

    def guide_map(self, target, epsilon, seed=None):
        """The run with guide maps with this ε."""
        return self._ours(target, seed, method="guide_map", epsilon=float(epsilon))

    def stylit(self, target, seed=None):
        """The run of StyLit, on the CPU as in the thesis."""
        return self._job(target, StylitRef(Params("stylit")), seed)

    def uniform_usage(self, target):
        """StyLit without an error budget, which uses every patch of the style equally often."""
        params = Params("stylit", budget=1.0, fixed_share=1.0)
        return self._job(target, StylitRef(params))

    def image_analogies(self, target):
        """The run of Image Analogies."""
        return self._job(target, ImageAnalogies())

    def _ours(self, target, seed=None, **params):
        rounds = ROUNDS if seed in (None, self.seeds[target][0]) else 1
        return self._job(target, StylitRef(Params(**params), self.backend, rounds), seed)

    def _job(self, target, method, seed=None):
        seed = self.seeds[target][0] if seed is None else seed
        return Job(self.scenes[target], method, seed, self.scheduler)

    def gpu_records(self, target):
        """The records of GPUs on a target (:func:`eval.pages.gpu_records.gpu_records`)."""
        if target not in STYLES:
            return {}
        return gpu_records(f"{target}/{STYLES[target]}", self.scenes[target].size)

    @property
    def tasks(self):
        """Every run once, with the metrics to measure of it."""
        tasks = []
        for target, seeds in self.seeds.items():
            tasks.append(Task(self.omega_kept(target)))
            for seed in seeds:
                tasks.append(Task(self.stylit(target, seed)))
                tasks += [Task(self.ref(target, value, seed)) for value in UNIFORMITIES]
                tasks += [
                    Task(self.guide_map(target, value, seed), WITHOUT_ENERGY) for value in EPSILONS
                ]
        background = self.uniform_usage(self.background), self.image_analogies(self.background)
        return tasks + [Task(job) for job in background]

    @property
    def jobs(self):
        """The runs alone."""
        return [task.job for task in self.tasks]


def preset(name, data=None, targets=None, step=1, seeds=None, **where):
    """The plan of a preset.

    Parameters
    ----------
    name : {"quick", "thesis"}
    data : Path, optional
        Another data set than the preset's.
    targets : sequence of str, optional
        Some of the thesis' targets; all by default.
    step : int
        Keep every ``step``-th pixel.
    seeds : sequence of int, optional
        Of every target. By default 0, and for one target also 1 and 2.
    **where
        ``backend`` and ``scheduler`` of the :class:`Plan`.

    Returns
    -------
    Plan

    Raises
    ------
    InputError
        If there is no such target or data set.
    """
    data = Path(data or PRESETS[name])
    if not data.is_dir():
        raise InputError(f"{data}: does not exist; 'make data' renders it")
    targets = targets or TARGETS
    for target in targets:
        if target not in STYLES:
            raise InputError(
                f"--targets names {target!r}, which is no target; choose from {', '.join(STYLES)}"
            )
    scenes = {target: load_scene(f"{target}/{STYLES[target]}", data, step) for target in targets}
    per_target = {
        target: tuple(seeds or ((0, 1, 2) if target == BACKGROUND else (0,))) for target in targets
    }
    variant = [name, *(targets if len(scenes) < len(TARGETS) else ())]
    if data.resolve() != PRESETS[name].resolve():
        variant.append(data.resolve().name)
    if step > 1:
        variant.append(f"step_{step}")
    return Plan("_".join(variant), scenes, per_target, **where)


def own_scene(folder, style=None, seeds=None, **where):
    """The plan of a user's own scene.

    Parameters
    ----------
    folder : Path
        See :func:`eval.scenes.load_scene`.
    style : Path, optional
        Another style than the folder's, of the same size.
    seeds : sequence of int, optional
    **where
        ``backend`` and ``scheduler`` of the :class:`Plan`.

    Returns
    -------
    Plan
    """
    scene = load_scene(folder)
    if style is not None:
        image = read_uint8(style)
        if image.shape[:2] != scene.style.shape[:2]:
            sizes = ("{1}x{0}".format(*each.shape) for each in (image, scene.style))
            raise InputError(
                "{}: is {}, but the source guides are {}; they must have the same size".format(
                    style, *sizes
                )
            )
        scene = replace(scene, style=image, name=f"{scene.name}_{Path(style).stem}")
    name = re.sub(r"\W+", "_", scene.name)
    return Plan(name, {name: scene}, {name: tuple(seeds or (0, 1, 2))}, **where)
