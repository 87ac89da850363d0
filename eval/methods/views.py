"""Coherent stylization of frames by the library itself, and what it is measured between."""

import time
from dataclasses import dataclass, field, replace

import numpy as np

from eval.device import processor
from eval.outcome import Outcome
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.stylization.params import Params
from stylit_ref.views.frames import Motion
from stylit_ref.views.params import Coherence
from stylit_ref.views.stylize_views import stylize_views

_CODE = code_digest(__file__, without=("gpu_cuda",))


@dataclass(frozen=True)
class Views:
    """A run of :func:`stylit_ref.views.stylize_views.stylize_views`.

    Attributes
    ----------
    params : Params
    coherence : Coherence
        With a weight of 0, every frame is stylized by itself.
    silhouettes : bool
        Whether strokes beside silhouettes move with what they belong to, where depth is known.
    """

    params: Params = field(default_factory=Params)
    coherence: Coherence = field(default_factory=Coherence)
    silhouettes: bool = True

    @property
    def name(self):
        """The method, and how frames pull at each other."""
        how = self.coherence
        if not how.weight:
            return f"{self.params.method}, alone"
        rule = "" if self.silhouettes else ", without silhouettes"
        return f"{self.params.method}, {how.order}, λ = {how.weight:g} {how.form}{rule}"

    @property
    def code(self):
        """Digest of the algorithm."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    @property
    def cost(self):
        """More for StyLit, whose retrievals are additional searches."""
        return 4.0 if self.params.method == "stylit" else 1.0

    def run(self, scene, seed, progress=None):
        """Stylize all frames; the kernels are compiled first.

        Parameters
        ----------
        scene : FrameSet
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            Images (F, H, W, n) and NNFs (F, H, W, 2) of all frames; the stage ``cpu`` is seconds of
            all threads.
        """
        compile_kernels(scene, self.params, self.coherence)
        if self.silhouettes and self.coherence.weight:
            scene = replace(scene, edges=scene.edges_of_strokes)
        wall, cpu = time.perf_counter(), time.process_time()
        results = stylized(scene, self.params, self.coherence, seed)
        wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
        return Outcome(
            image=np.stack([result.image for result in results]),
            seconds=wall,
            nnf=np.stack([result.nnf for result in results]),
            stages={"cpu": cpu},
        )


@dataclass(frozen=True)
class Renderings:
    """The frames as they were rendered: no paint, so that nothing could move better."""

    name = "renderings"
    device = "none"
    cost = 0.0

    @property
    def code(self):
        """Digest of this file."""
        return _CODE

    def run(self, scene, seed, progress=None):
        """The renderings of a :class:`eval.frame_sets.FrameSet`, as an Outcome."""
        return Outcome(scene.renderings, 0.0)


def stylized(scene, params, coherence, seed=0):
    """The finished frames of a set in their order, a list of FrameResult."""
    results = stylize_views(
        scene.style, scene.source_guides, scene.guides, params, coherence, edges=scene.edges,
        seed=seed,
    )  # fmt: skip
    return sorted(results, key=lambda result: result.frame)


def compile_kernels(scene, params, coherence):
    """Run the same kernels on a corner of two frames, so that times include no compilation."""
    side = 4 * params.patch_width
    corner = np.s_[:side, :side]
    still = Motion(np.zeros((side, side, 2), np.float32), np.ones((side, side), np.bool_))
    small = replace(
        scene,
        style=scene.style[corner],
        source_guides=tuple(guide[corner] for guide in scene.source_guides),
        guides=tuple(tuple(guide[corner] for guide in frame) for frame in scene.guides[:2]),
        edges={(0, 1): still, (1, 0): still} if coherence.weight else {},
        depths=None,
    )
    few = replace(params, levels=2, votes=1, patchmatch_iterations=1, uniformity=1e4)
    stylized(small, few, coherence)
