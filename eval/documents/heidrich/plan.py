"""Which runs the tables and figures of the thesis need."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import chain, combinations
from typing import Any

from eval.documents.heidrich.frame_times import FrameTimes
from eval.documents.heidrich.hand_times import HandTimes
from eval.documents.heidrich.outlook import FewestBuffers, Hybrid
from eval.documents.heidrich.stage import STYLES
from eval.methods.lit_sphere import LitSphere
from eval.methods.realtime import Realtime
from eval.methods.styleblit import StyleBlit
from eval.methods.stylit_ref import StylitRef
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.scenes import Scene
from stylit_ref import Params
from stylit_ref.realtime.packing.stage import STAGE_BUFFERS
from stylit_ref.realtime.params import RealtimeParams

METRICS = "copying", "image_energy", "sharpness", "spilling", "strokes", "wrong_things"
"""What is measured of every picture; for those on the sheet also the background, which is slow."""

WITHOUT_ENERGY = tuple(name for name in METRICS if name != "image_energy")
"""What is measured of large pictures, whose energy would take minutes."""

DENSE = {"ref": Params(), "StyLit": Params("stylit")}
RIVALS = {"Lit Sphere": LitSphere(), "StyleBlit": StyleBlit()}
THESIS = "simple", "optimized"
PRODUCTS = "quick", "best"
METHODS = (*DENSE, *RIVALS, *THESIS, *PRODUCTS)

SIDES = (500, 1000)
"""Pixels along the pictures of table 1."""

SAVINGS = {
    "packing": {"packing": "all"},
    "scale space": {"scale_space": False},
    "unread terms": {"unread_terms": False},
}
"""The three savings of 4.2, and what leaves each out of the optimized method."""

LEFT_OUT = tuple(
    chain.from_iterable(combinations(SAVINGS, count) for count in range(len(SAVINGS) + 1))
)
"""Which savings the variants of the ablation lack."""

BUFFERS = {
    **{f"without {name}": ((name, 0),) for name in STAGE_BUFFERS},
    "FULL alone": tuple((name, 0) for name in STAGE_BUFFERS if name != "FULL"),
}
"""Weights of figure 27."""

SCHEDULES = {
    "both terms to the finest level": (8, 8, 8, 8, 0, 0),
    "both terms from the coarsest level": (16, 16, 8, 8, 8, 8),
}
"""μ in sixteenths, the finest level first; the thesis has 16 16 8 8 0 0 (4.2.4)."""

ITERATIONS = (1, 2, 4, 8)
"""Iterations a level; the thesis has 2."""


@dataclass(frozen=True)
class Preset:
    """How much is done.

    Attributes
    ----------
    studied : tuple of str
        Styles of the ablation and of the sweeps.
    rounds, of_a_hand : int
        In which frames are timed, in turns, and what a hand waits for.
    seeds : int
        Over which energies of the house are means.
    widths : tuple of int
        w of the simple method.
    depths : tuple of int
        D of the optimized one.
    """

    studied: tuple[str, ...]
    rounds: int
    of_a_hand: int
    seeds: int
    widths: tuple[int, ...] = (3, 5, 7, 9, 11, 13)
    depths: tuple[int, ...] = (1, 2, 3, 4)


PRESETS = {"quick": Preset(("oil",), 7, 25, 1), "full": Preset(STYLES, 50, 50, 3)}


@dataclass(frozen=True)
class Plan:
    """The runs of a preset.

    Attributes
    ----------
    name : str
    preset : Preset
    shown : callable
        The scene of a style, of which pictures are made.
    timed : callable
        The scene of ``side`` x ``side`` pixels on which frames are timed.
    sides : tuple of int
    large : callable, optional
        The scene of a style at the thesis' size, if ``shown`` gives smaller ones.
    turning : Job, optional
        The run of the turning target, if it is rendered.
    asides : tuple
        Further sections of the page, each with ``tasks``, ``claims()`` and ``sections(report)``.
    """

    name: str
    preset: Preset
    shown: Callable[[str], Scene]
    timed: Callable[[int], Scene]
    sides: tuple[int, ...] = SIDES
    large: Callable[[str], Scene] | None = None
    turning: Job | None = None
    asides: tuple[Any, ...] = ()

    @cached_property
    def _scene(self):
        return cache(self.shown)

    @cached_property
    def _timed(self):
        return cache(self.timed)

    def scene(self, style):
        """The stage in a style."""
        return self._scene(style)

    def picture(self, style, name, seed=0):
        """A run of one of :data:`METHODS`."""
        if name in DENSE:
            return Job(self.scene(style), StylitRef(DENSE[name]), seed)
        if name in RIVALS:
            return Job(self.scene(style), RIVALS[name], seed)
        return self._realtime(style, name, name, seed=seed)

    @cached_property
    def _large(self):
        return cache(self.large)

    def large_picture(self, style, name):
        """A run of a method in real time, at the thesis' size if it is there."""
        if self.large is None:
            return self.picture(style, name)
        return Job(self._large(style), _realtime_method(name, name))

    def left_out(self, style, savings):
        """The optimized method without some of the savings."""
        for method, lacking in (("optimized", ()), ("simple", ("scale space",))):
            if savings == lacking:
                return self.picture(style, method)
        return Job(self.scene(style), _variant(savings))

    def width(self, style, width):
        """The simple method with patches of another width."""
        if width == RealtimeParams.preset("simple").patch_width:
            return self.picture(style, "simple")
        return self._realtime(style, f"w = {width}", "simple", patch_width=width)

    def depth(self, style, depth):
        """The optimized method with another number of scales."""
        if depth == RealtimeParams.preset("optimized").depth:
            return self.picture(style, "optimized")
        return self._realtime(style, f"D = {depth}", "optimized", depth=depth)

    def boxes(self, style):
        """The optimized method, its scales means of boxes around the pixel."""
        return self._realtime(style, "optimized, boxes", "optimized", means="box")

    def weighted(self, style, method, weights):
        """A method with one of :data:`BUFFERS`."""
        name = f"{method}, {weights}"
        return self._realtime(style, name, method, BUFFERS[weights])

    def scheduled(self, style, schedule):
        """The simple method with one of :data:`SCHEDULES`."""
        return self._realtime(style, schedule, "simple", mu=SCHEDULES[schedule])

    def iterated(self, style, iterations):
        """The simple method with other iterations a level."""
        if (iterations,) == RealtimeParams.preset("simple").iterations:
            return self.picture(style, "simple")
        return self._realtime(style, f"{iterations} iterations", "simple", iterations=(iterations,))

    def hybrid(self, style):
        """Patches at the finest level, scales at the others."""
        return Job(self.scene(style), Hybrid())

    def fewest(self, style, method):
        """How many buffers a method can do without."""
        return Job(self.scene(style), FewestBuffers(_realtime_method(method, method)))

    def _realtime(self, style, name, preset, weights=(), seed=0, **changes):
        return Job(self.scene(style), _realtime_method(name, preset, weights, **changes), seed)

    def times(self, side):
        """Table 1: the thesis' methods and ours."""
        methods = [_realtime_method(name, name) for name in THESIS + PRODUCTS]
        return self._times(side, "methods", methods, on_all=True)

    def times_of_savings(self, side):
        """The ablation's times."""
        return self._times(side, "savings", [_variant(savings) for savings in LEFT_OUT])

    def times_of_widths(self, side):
        """Times of the simple method as w grows."""
        methods = [_realtime_method(f"{w}", "simple", patch_width=w) for w in self.preset.widths]
        return self._times(side, "w", methods)

    def times_of_depths(self, side):
        """Times of the optimized method as D grows."""
        methods = [_realtime_method(f"{d}", "optimized", depth=d) for d in self.preset.depths]
        return self._times(side, "D", methods)

    def times_of_few(self, side):
        """Times of what the outlook asks for."""
        return self._times(side, "hybrid", [_realtime_method("optimized", "optimized"), Hybrid()])

    def hand_times(self, side):
        """What a hand waits for."""
        return Job(self._timed(side), HandTimes(PRODUCTS, self.preset.of_a_hand))

    def _times(self, side, name, methods, on_all=False):
        method = FrameTimes(name, tuple(methods), self.preset.rounds, on_all)
        return Job(self._timed(side), method)

    @property
    def studies(self):
        """The runs of the ablation, the sweeps and the other choices."""
        jobs = []
        for style in self.preset.studied:
            jobs += [self.left_out(style, savings) for savings in LEFT_OUT]
            jobs += [self.width(style, width) for width in self.preset.widths]
            jobs += [self.depth(style, depth) for depth in self.preset.depths] + [self.boxes(style)]
            jobs += [self.weighted(style, method, w) for method in THESIS for w in BUFFERS]
            jobs += [self.scheduled(style, schedule) for schedule in SCHEDULES]
            jobs += [self.iterated(style, iterations) for iterations in ITERATIONS]
            jobs += [self.picture(style, method, seed=1) for method in THESIS]
            jobs.append(self.hybrid(style))
        return jobs

    @property
    def tasks(self):
        """Every run once, with the metrics to measure of it."""
        tasks = [
            Task(make(side), ())
            for side in self.sides
            for make in (
                self.times, self.times_of_savings, self.times_of_widths, self.times_of_depths,
                self.times_of_few, self.hand_times,
            )
        ]  # fmt: skip
        tasks += [Task(job, METRICS) for job in self.studies]
        tasks += [
            Task(self.picture(style, name), (*METRICS, "background"))
            for style in STYLES
            for name in METHODS
        ]
        tasks += [Task(self.fewest(style, "simple"), ()) for style in self.preset.studied]
        if self.large is not None:
            tasks += [
                Task(self.large_picture(style, name), WITHOUT_ENERGY)
                for style in STYLES
                for name in THESIS + PRODUCTS
            ]
        if self.turning is not None:
            tasks.append(Task(self.turning, ()))
        for aside in self.asides:
            tasks += aside.tasks
        return _each_once(tasks)


def _each_once(tasks):
    """Every run once, with all metrics that any of its tasks asks for."""
    jobs, metrics = {}, {}
    for job, names in tasks:
        jobs[job.key] = job
        metrics.setdefault(job.key, {}).update(dict.fromkeys(names))
    return [Task(job, tuple(metrics[key])) for key, job in jobs.items()]


def _realtime_method(name, preset, weights=(), **changes):
    return Realtime(name, RealtimeParams.preset(preset, **changes), weights)


def _variant(savings):
    changes = {name: value for saving in savings for name, value in SAVINGS[saving].items()}
    name = f"without {', '.join(savings)}" if savings else "all three"
    return _realtime_method(name, "optimized", **changes)
