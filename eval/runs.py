"""Runs and their stored results: what is computed once is not computed again."""

import hashlib
import json
import time
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
import pandas as pd

from eval.scenes import Scene
from stylit_ref import Params, stylize
from stylit_ref.kernel import LIBRARY_DIGEST

STORE = Path("build/runs")


@dataclass(frozen=True)
class Run:
    """A stored stylization.

    Attributes
    ----------
    image, nnf, omega : array
    seconds : float
        Wall time of ``stylize`` with the kernels compiled before.
    guide_map : (H_B, W_B) bool
        Of the finest level; all black for methods without.
    history : pandas.DataFrame
        A row for each :class:`stylit_ref.Step`.
    """

    image: np.ndarray
    nnf: np.ndarray
    omega: np.ndarray
    seconds: float
    guide_map: np.ndarray
    history: pd.DataFrame

    @property
    def delta(self):
        """Mean δ when the last search ended."""
        return float(self.history["delta"].iloc[-1])

    @property
    def penalization(self):
        """Mean λρ when the last search ended."""
        return float(self.history["penalization"].iloc[-1])


def run(scene: Scene, params: Params, seed: int, progress=None) -> Run:
    """Stylize a scene, or read the result of having done so.

    Parameters
    ----------
    scene : Scene
    params : Params
    seed : int
    progress : callable, optional
        As for :func:`stylit_ref.stylize`.

    Returns
    -------
    Run
    """
    key = json.dumps([scene.digest, asdict(params), seed, LIBRARY_DIGEST])
    file = STORE / f"{hashlib.sha256(key.encode()).hexdigest()[:24]}.npz"
    if not file.exists():
        compile_kernels(scene, params)
        start = time.perf_counter()
        result = stylize(
            scene.style,
            scene.source_guides,
            scene.target_guides,
            params,
            seed=seed,
            progress=progress,
        )
        seconds = time.perf_counter() - start
        black = np.zeros(result.nnf.shape[:2], bool)
        STORE.mkdir(parents=True, exist_ok=True)
        partial = file.with_suffix(".partial.npz")
        np.savez_compressed(
            partial,
            image=result.image,
            nnf=result.nnf,
            omega=result.omega,
            seconds=seconds,
            guide_map=result.guide_maps[-1] if result.guide_maps else black,
            history=json.dumps([asdict(step) for step in result.history]),
        )
        partial.rename(file)
    with np.load(file) as stored:
        return Run(
            stored["image"],
            stored["nnf"],
            stored["omega"],
            float(stored["seconds"]),
            stored["guide_map"],
            pd.DataFrame(json.loads(str(stored["history"]))),
        )


def compile_kernels(scene, params):
    """Run the same kernels on a corner of the scene, so that timings hold no compilation."""
    corner = np.s_[: 4 * params.patch_width, : 4 * params.patch_width]
    stylize(
        scene.style[corner],
        [guide[corner] for guide in scene.source_guides],
        [guide[corner] for guide in scene.target_guides],
        Params(**(asdict(params) | {"levels": 2, "votes": 1, "patchmatch_iterations": 1})),
    )
