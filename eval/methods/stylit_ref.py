"""The methods of the library itself."""

import time
from dataclasses import asdict, dataclass, field, replace
from functools import partial

import numpy as np
import pandas as pd

from eval.device import device
from eval.outcome import Outcome
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.machine.compilation import compiling_together
from stylit_ref.stylization.params import Params
from stylit_ref.stylization.stylize import stylize
from stylit_ref.stylization.warm_up import kernels_of_run

_CODE = code_digest(__file__, without=("gpu_cuda",))
_CODE_ON_GPU = code_digest(__file__)


@dataclass(frozen=True)
class StylitRef:
    """A run of :func:`stylit_ref.stylize`.

    Attributes
    ----------
    params : Params
    backend : str
        One of :data:`stylit_ref.stylization.backends.BACKENDS`, but not ``auto``: times belong to
        a device.
    rounds : int
        How often it is run; times are the least, which a busy machine disturbs least.
    """

    params: Params = field(default_factory=Params)
    backend: str = "cpu"
    rounds: int = 1

    @property
    def name(self):
        """The method, and the parameter that reports vary."""
        settings = {
            "guide_map": f"ε = {self.params.epsilon:g}",
            "stylit": str(self.params.budget),
        }
        setting = settings.get(self.params.method, f"λ = {self.params.uniformity:g}")
        return f"{self.params.method}, {setting}"

    @property
    def code(self):
        """Digest of the algorithms, and of the CUDA kernels if they run."""
        return _CODE if self.backend == "cpu" else _CODE_ON_GPU

    @property
    def device(self):
        """Name of the processor or the GPU."""
        return device(self.backend)

    @property
    def alone(self):
        """Whether nothing else may run: a GPU is timed by the clock."""
        return self.backend != "cpu"

    @property
    def cost(self):
        """More for StyLit, whose retrievals are additional searches."""
        return self.rounds * (6.0 if self.params.method == "stylit" else 1.0)

    def run(self, scene, seed, progress=None):
        """Stylize a scene; the kernels are compiled first.

        Parameters
        ----------
        scene : Scene
        seed : int
        progress : callable, optional
            As for :func:`stylit_ref.stylize`.

        Returns
        -------
        Outcome
            On the processor, the stage ``cpu`` is its seconds, of all threads together.
        """
        compile_kernels(scene, self.params, self.backend)
        spent = []
        for _ in range(self.rounds):
            levels = []
            wall, cpu = time.perf_counter(), time.process_time()
            result = stylize(
                scene.style,
                scene.source_guides,
                scene.target_guides,
                self.params,
                seed=seed,
                backend=self.backend,
                progress=progress,
                on_level=lambda number, image, levels=levels: levels.append(image),
            )
            spent.append((time.perf_counter() - wall, time.process_time() - cpu))
        seconds, cpu = map(min, zip(*spent, strict=True))
        history = pd.DataFrame([asdict(step) for step in result.history])
        if self.params.method == "stylit":  # it does not minimize λρ
            history = history.drop(columns="penalization")
        return Outcome(
            image=result.image,
            seconds=seconds,
            nnf=result.nnf,
            omega=result.omega,
            guide_map=result.guide_maps[-1] if result.guide_maps else None,
            levels=tuple(levels),
            stages={"cpu": cpu} if self.backend == "cpu" else {},
            history=history,
        )


def compile_kernels(scene, params, backend="cpu"):
    """Run the same kernels on a corner of the scene, so that timings include no compilation."""
    corner = np.s_[: 4 * params.patch_width, : 4 * params.patch_width]
    style, *guides = (np.atleast_3d(each).shape[2] for each in (scene.style, *scene.source_guides))
    with compiling_together(partial(kernels_of_run, params, style, guides)):
        stylize(
            scene.style[corner],
            [guide[corner] for guide in scene.source_guides],
            [guide[corner] for guide in scene.target_guides],
            replace(params, levels=2, votes=1, patchmatch_iterations=1, uniformity=1e4),
            backend=backend,
        )
