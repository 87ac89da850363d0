"""Which runs the tables and figures of the paper need."""

from dataclasses import dataclass
from functools import cached_property

from eval.documents.lasram.cut_quality import CutQuality
from eval.documents.lasram.interaction import SIDE, Interaction
from eval.documents.lasram.patch_costs import PatchCosts
from eval.documents.lasram.presets import Preset
from eval.documents.lasram.timing import Ceiling, ThreadTimes
from eval.methods.hole_filling import CURES, HOLES, HoleFilling
from eval.methods.image_quilting import ImageQuilting
from eval.methods.pixel_synthesis import PixelSynthesis
from eval.methods.texture import TextureSynthesis
from eval.methods.texture_completion import LabelledTexture, TextureCompletion
from eval.methods.texture_program import TextureProgram
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.textures import NINE, large_texture, load_texture
from stylit_ref.texture.formulae.polar import WEIGHTINGS
from stylit_ref.texture.params import TextureParams

METRICS = (
    "border", "nearest_patch", "pieces", "repetition", "seam_cost", "sliced_wasserstein",
)  # fmt: skip
"""What the study of quality measures of every run."""

COVERING = (1, 2, 3, 4, 5)
"""Iterations after which it is counted how much of S is covered."""

RADII = (8, 16, 32, 64, 128)
"""R of figure 9."""

JITTERS = {"pixels, high jitter": 1.0, "pixels, low jitter": 0.2}
"""The pixel-based rival of figure 16."""

FILLED = ("bricks", "canes", "flowers", "brick", "grass", "gravel")
"""Exemplars with holes to fill."""

LARGEST_HOLE = "blobs"
"""The hole that is filled without each cure."""

QUIET = 3
"""How often a run is repeated whose times count."""

LONG = 40
"""Iterations of the plot of convergence (figure 14), and until flowers vanish."""


@dataclass(frozen=True)
class Plan:
    """The runs of a preset.

    Attributes
    ----------
    name : str
    preset : Preset
    exemplars : tuple of str
    rivals : tuple of TextureProgram
        Other programs that are installed.
    side : int
        Height and width of S where the paper says 512.
    """

    name: str
    preset: Preset
    exemplars: tuple[str, ...] = NINE
    rivals: tuple[TextureProgram, ...] = ()
    side: int = 512

    def paper(self, exemplar, label="paper", shape=None, seed=0, **changes):
        """A run with the settings of section 8, some of them changed."""
        params = TextureParams.preset("paper", **changes)
        return self._job(exemplar, TextureSynthesis(label, params), shape, seed)

    def default(self, exemplar, seed=0):
        """A run with our defaults."""
        return self._job(exemplar, TextureSynthesis(), None, seed)

    def quilting(self, exemplar, seed=0):
        """A run of image quilting."""
        return self._job(exemplar, ImageQuilting(), None, seed)

    def of_one_radius(self, exemplar, seed=0):
        """Our defaults, but for R, which does not fall."""
        params = TextureParams(radius=64, radius_step=0)
        return self._job(exemplar, TextureSynthesis("one R", params), None, seed)

    def rival(self, exemplar, program):
        """A run of another program."""
        return self._job(exemplar, program, None, 0)

    def _job(self, exemplar, method, shape, seed):
        return Job(self._texture(exemplar, shape or (self.side, self.side)), method, seed)

    def _texture(self, exemplar, shape):
        key = exemplar, shape
        if key not in self._textures:
            self._textures[key] = load_texture(exemplar, shape)
        return self._textures[key]

    @cached_property
    def _textures(self):
        return {}

    def covering(self, exemplar, iterations):
        """The first iterations of the paper's settings."""
        return self.paper(exemplar, f"paper, {iterations} iterations", iterations=iterations)

    def long(self, exemplar):
        """Figure 14."""
        return self.paper(exemplar, f"paper, {LONG} iterations", iterations=LONG)

    def of_radius(self, radius, iterations=8):
        """Figure 9; with more iterations, flowers vanish at small R."""
        return self.paper(
            "flowers", f"R = {radius}, {iterations} iterations", radius=radius,
            iterations=iterations,
        )  # fmt: skip

    def falling_radius(self, radius):
        """Figure 10: R falls from 132 by 4 an iteration, until it is this."""
        return self.paper(
            "canes", f"R from 132 to {radius}", radius=132, radius_step=4,
            iterations=(132 - radius) // 4 + 1,
        )  # fmt: skip

    def falling_deformation(self, exemplar, deformation=0):
        """Figure 11: D_max falls from 160 by 10 an iteration, until it is this."""
        return self.paper(
            exemplar, f"D_max from 160 to {deformation}", (self.side, self.side // 2),
            max_deformation=160, deformation_step=10, iterations=(160 - deformation) // 10 + 1,
        )  # fmt: skip

    def constant_deformation(self, exemplar, deformation):
        """The same number of iterations with one D_max."""
        return self.paper(
            exemplar, f"D_max = {deformation}", (self.side, self.side // 2),
            max_deformation=deformation, iterations=17,
        )  # fmt: skip

    def large_radius(self, exemplar):
        """Figure 16."""
        return self._quiet(exemplar, "R = 128", None, radius=128)

    def pixels(self, exemplar, label):
        """The pixel-based rival of figure 16; ``label`` is one of :data:`JITTERS`."""
        return self._job(exemplar, PixelSynthesis(label, JITTERS[label]), None, 0)

    def judged_by(self, predicate):
        """The paper's settings with another way to reject patches."""
        return self._quiet("flowers", f"predicate {predicate}", None, predicate=predicate)

    def _quiet(self, exemplar, label, shape, **changes):
        params = TextureParams.preset("paper", **changes)
        return self._job(exemplar, TextureSynthesis(label, params, QUIET, alone=True), shape, 0)

    def spread(self, gamma):
        """Deformation that fades as γ says; no patch is rejected."""
        return self.paper("canes", f"γ = {gamma}", gamma=gamma, predicate="none", iterations=1)

    def completed(self, inverted):
        """Figure 12."""
        name = f"completion{', inverted' if inverted else ''}"
        return Job(self._large, TextureCompletion(name, inverted))

    @cached_property
    def _large(self):
        return large_texture("flowers", self.preset.completed)

    def filled(self, exemplar, hole, without=None):
        """A hole that is filled, possibly without a cure."""
        name = f"{hole} without {without}" if without else hole
        return self._job(exemplar, HoleFilling(name, hole, without), (256, 256), 0)

    @property
    def with_holes(self):
        """Exemplars with holes to fill."""
        return tuple(name for name in FILLED if name in self.exemplars)

    def labelled(self):
        """Figure 13."""
        return self._job("flowers", LabelledTexture("with bricks", "bricks"), None, 0)

    def cuts(self, exemplar, weighting, hides):
        """Cuts on an exemplar: its share of all trials."""
        number = self.exemplars.index(exemplar)
        share = self.preset.trials * (number + 1) // len(self.exemplars)
        share -= self.preset.trials * number // len(self.exemplars)
        name = f"cuts {weighting} {'with' if hides else 'without'} seams"
        return self._job(exemplar, CutQuality(name, weighting, hides, share), None, 0)

    def timed(self, size, radius=64):
        """A row of the table of times."""
        params = TextureParams.preset("paper", radius=radius)
        return self._timing(TextureSynthesis(f"timed, R = {radius}", params, alone=True), size)

    def timed_radius(self, size, radius):
        """A point of figure 15."""
        return self._quiet("gravel", f"quiet, R = {radius}", (size, size), radius=radius)

    @property
    def timed_radii(self):
        """R of figure 15."""
        return 16, 32, 64, 96, 128

    @property
    def of_threads(self):
        """Times on one thread and on two: every size, and figure 16."""
        shapes = [*((size, 64) for size in self.preset.sizes), (self.side, 128)]
        return [self._timing(ThreadTimes(radius), size) for size, radius in shapes]

    def patch_costs(self, size):
        """Stages of a patch, and memory."""
        return self._timing(PatchCosts(), size)

    @property
    def ceiling(self):
        """What two threads can gain on this machine."""
        return self._timing(Ceiling(), self.side)

    @property
    def interaction(self):
        """What a hand waits for."""
        return self._timing(Interaction(), min(SIDE, max(self.preset.sizes)))

    def _timing(self, method, size):
        return self._job("gravel", method, (size, size), 0)

    @property
    def quality(self):
        """Tasks of the study of quality."""
        jobs = []
        for exemplar in self.exemplars:
            for seed in self.preset.seeds:
                jobs += [self.default(exemplar, seed), self.quilting(exemplar, seed)]
                jobs += [self.paper(exemplar, seed=seed), self.of_one_radius(exemplar, seed)]
            jobs += [self.rival(exemplar, program) for program in self.rivals]
        return [Task(job, METRICS) for job in jobs]

    @property
    def structured(self):
        """Exemplars with contours to align."""
        return tuple(name for name in ("bricks", "canes", "glyphs") if name in self.exemplars)

    @property
    def tasks(self):
        """Every run once, with the metrics to measure of it."""
        jobs = [self.covering(name, k) for name in self.exemplars for k in COVERING]
        jobs += [self.long(name) for name in self.exemplars]
        jobs += [self.of_radius(radius) for radius in RADII]
        jobs += [self.of_radius(radius, LONG) for radius in (8, 64)]
        jobs += [self.falling_radius(radius) for radius in (72, 4)]
        jobs += [self.falling_deformation("bricks", value) for value in (100, 50)]
        for name in self.structured:
            jobs.append(self.falling_deformation(name))
            jobs += [self.constant_deformation(name, value) for value in (0, 32)]
        jobs.append(self.paper("door"))
        jobs += [self.completed(inverted) for inverted in (False, True)] + [self.labelled()]
        jobs += [self.judged_by(predicate) for predicate in ("none", "before", "after")]
        jobs += [self.spread(gamma) for gamma in (0.25, 4)]
        jobs += [self.timed(size) for size in self.preset.sizes]
        jobs += [
            self.timed_radius(size, radius)
            for size in self.preset.sizes[:2]
            for radius in self.timed_radii
        ]
        jobs += [
            self.cuts(name, weighting, hides)
            for name in self.exemplars
            for weighting in WEIGHTINGS
            for hides in (False, True)
        ]
        jobs += [self.filled(name, hole) for name in self.with_holes for hole in HOLES]
        jobs += [self.filled(name, LARGEST_HOLE, c) for name in self.with_holes for c in CURES]
        figures = {job.key: Task(job, ("pieces",)) for job in jobs}
        beside = [self.pixels(name, label) for name in self.structured for label in JITTERS]
        beside += [self.large_radius(name) for name in self.structured]
        timings = [*self.of_threads, self.ceiling, self.interaction]
        timings += [self.patch_costs(size) for size in self.preset.sizes]
        return [
            *self.quality,
            *figures.values(),
            *(Task(job, METRICS) for job in beside),
            *(Task(job, ()) for job in timings),
        ]
