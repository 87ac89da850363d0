"""Runs and their stored results: what is computed once is not computed again."""

import hashlib
import io
import json
import time
import zipfile
import zlib
from dataclasses import asdict, dataclass, replace
from functools import cache, cached_property, lru_cache
from pathlib import Path

import numpy as np
import pandas as pd

from eval.circumstances import circumstances, device
from eval.image_analogies import ImageAnalogies, image_analogies
from eval.scenes import Scene
from stylit_ref import Params, Profile, stylize
from stylit_ref.files.output_file import whole_file
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.stylization import stylize as algorithm

STORE = Path("build/runs")

# Taken at the start: what is edited during a long report did not make it.
LIBRARY_DIGEST = code_digest(algorithm, without=("gpu_cuda",))
"""Identifies the code that every run depends on."""


@dataclass(frozen=True)
class Job:
    """What a run's result depends on.

    Attributes
    ----------
    scene : Scene
    params : Params or ImageAnalogies
    seed : int
    backend : {"cpu", "cuda"}
    device : str
        Where it runs: times are of one device.
    """

    scene: Scene
    params: Params | ImageAnalogies
    seed: int = 0
    backend: str = "cpu"
    device: str = device("cpu")

    @cached_property
    def key(self):
        """Name of the result."""
        identity = [
            self.scene.digest, type(self.params).__name__, asdict(self.params), self.seed,
            self.backend, self.device, self._code,
        ]  # fmt: skip
        return hashlib.sha256(json.dumps(identity).encode()).hexdigest()[:24]

    @property
    def _code(self):
        if isinstance(self.params, ImageAnalogies):
            return self.params.code
        return LIBRARY_DIGEST + (kernels_digest() if self.backend == "cuda" else "")

    @property
    def file(self):
        """Where the result is stored."""
        return STORE / f"{self.key}.npz"

    @property
    def title(self):
        """For progress and errors."""
        params = self.params
        if isinstance(params, ImageAnalogies):
            return f"{self.scene.name}, image analogies"
        setting = {"guide_map": f", ε = {params.epsilon:g}", "stylit": f", {params.budget}"}
        setting = setting.get(params.method, f", λ = {params.uniformity:g}")
        return f"{self.scene.name}, {params.method}{setting}, seed {self.seed}"


@dataclass(frozen=True)
class Run:
    """A stored stylization.

    Attributes
    ----------
    key : str
        Of the job it belongs to, wherever its file lies.
    image, nnf, omega : array
    seconds : float
        Wall time of ``stylize`` with the kernels compiled before.
    stages : dict of str to float
        Seconds by stage of the same.
    made : str
        Machine, versions and commit.
    guide_map : (H_B, W_B) bool
        Of the finest level; all black for methods without.
    levels : tuple of (H, W, n) uint8
        B' of every pyramid level, the coarsest first.
    history : pandas.DataFrame
        A row for each :class:`stylit_ref.Step`.
    """

    key: str
    image: np.ndarray
    nnf: np.ndarray
    omega: np.ndarray
    seconds: float
    stages: dict[str, float]
    made: str
    guide_map: np.ndarray
    levels: tuple[np.ndarray, ...]
    history: pd.DataFrame

    @property
    def delta(self):
        """Mean δ when the last search ended."""
        return float(self.history["delta"].iloc[-1])

    @property
    def penalization(self):
        """Mean λρ when the last search ended."""
        return float(self.history["penalization"].iloc[-1])


def run(scene, params, seed, progress=None) -> Run:
    """Stylize a scene on the CPU, or read the result of having done so.

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
    job = Job(scene, params, seed)
    result = stored(job)
    if result is None:
        store(job, compute(job, progress))
        result = stored(job)
    return result


def compute(job, progress=None):
    """Run a job.

    Parameters
    ----------
    job : Job
    progress : callable, optional
        As for :func:`stylit_ref.stylize`.

    Returns
    -------
    bytes
        What :func:`store` keeps.
    """
    scene, params = job.scene, job.params
    if isinstance(params, ImageAnalogies):
        made = image_analogies(scene.style, scene.source_guides, scene.target_guides, params)
    else:
        made = _stylize(job, progress)
    arrays, facts = made
    file = io.BytesIO()
    facts |= {"key": job.key, "made": circumstances()}
    np.savez_compressed(file, facts=json.dumps(facts), **arrays)
    return file.getvalue()


def _stylize(job, progress):
    scene, params = job.scene, job.params
    compile_kernels(scene, params, job.backend)
    levels, profile = {}, Profile()
    start = time.perf_counter()
    result = stylize(
        scene.style,
        scene.source_guides,
        scene.target_guides,
        params,
        seed=job.seed,
        backend=job.backend,
        progress=progress,
        on_level=lambda number, image: levels.update({f"level_{number}": image}),
        profile=profile,
    )
    seconds = time.perf_counter() - start
    black = np.zeros(result.nnf.shape[:2], bool)
    arrays = {
        "image": result.image,
        "nnf": result.nnf,
        "omega": result.omega,
        "guide_map": result.guide_maps[-1] if result.guide_maps else black,
    }
    history = [asdict(step) for step in result.history]
    return arrays | levels, {"seconds": seconds, "stages": profile.seconds, "history": history}


def store(job, result):
    """Keep a result, whole or not at all."""
    STORE.mkdir(parents=True, exist_ok=True)
    with whole_file(job.file, len(result)) as partial:
        partial.write_bytes(result)


def stored(job):
    """The :class:`Run` of a job, or None if there is none that can be read."""
    try:
        run = _read(job.file, job.file.stat().st_mtime_ns)
    except OSError:
        return None
    return run if run and run.key == job.key else None


@lru_cache(maxsize=64)
def _read(file, _):
    """A report asks for the same results again and again."""
    return read(file)


def read(file):
    """The :class:`Run` in a file, or None if there is none that can be read.

    Parameters
    ----------
    file : Path or file object
    """
    try:
        with np.load(file) as file:
            facts = json.loads(str(file["facts"]))
            count = sum(name.startswith("level_") for name in file.files)
            return Run(
                key=facts["key"],
                image=file["image"],
                nnf=file["nnf"],
                omega=file["omega"],
                seconds=facts["seconds"],
                stages=facts["stages"],
                made=facts["made"],
                guide_map=file["guide_map"],
                levels=tuple(file[f"level_{number}"] for number in range(1, count + 1)),
                history=pd.DataFrame(facts["history"]),
            )
    except (
        OSError,
        ValueError,
        KeyError,
        EOFError,
        NotImplementedError,
        zipfile.BadZipFile,
        zlib.error,
    ):
        return None


@cache
def kernels_digest():
    """Identifies the CUDA kernels."""
    files = sorted((Path(__file__).parents[1] / "gpu_cuda").rglob("*.py"))
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def compile_kernels(scene, params, backend="cpu"):
    """Run the same kernels on a corner of the scene, so that timings hold no compilation."""
    corner = np.s_[: 4 * params.patch_width, : 4 * params.patch_width]
    stylize(
        scene.style[corner],
        [guide[corner] for guide in scene.source_guides],
        [guide[corner] for guide in scene.target_guides],
        replace(params, levels=2, votes=1, patchmatch_iterations=1, uniformity=1e4),
        backend=backend,
    )
