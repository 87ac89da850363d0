"""Measure what guide maps change and what they save (thesis 5.2.3, 5.2.4)."""

import time
from dataclasses import replace

import numpy as np
import pandas as pd
from skimage.filters import gaussian
from tqdm import tqdm

from eval.methods.stylit_ref import StylitRef, compile_kernels
from eval.metrics import definitions
from eval.pages import options as shared
from eval.pages.figures import comparison, detailed_window
from eval.pages.page import new_report, shown
from eval.provenance import provenance
from eval.runs.job import Job
from eval.runs.local import numbers, run
from eval.similarity import psnr, ssim
from stylit_ref import Params, passes
from stylit_ref.machine.replaced import replaced
from stylit_ref.passes.plain_random_search import plain_random_search
from stylit_ref.stylization.backends import Backend
from stylit_ref.stylization.problem import make_synthesis

EPSILONS = (3, 5, 10, 25, 100, 500, 5000, 10000)
BEYOND = 50000
"""An ε so large that edges of little contrast are certainly lost."""
MAPS_SHOWN = (10, 100, 500, 5000, BEYOND)
BLACK, WHITE = 0.0, 1e9
"""No patch varies by less than the first; all patches vary by less than the second."""

DEFINITIONS = """\
- **white**: share of the finest level's target patches whose guides vary by less than ε.
- **PSNR** [dB] and **SSIM** (mean over channels, 7x7 windows): against the image of ref with the
  same seed. The row of another seed says how far two runs of ref are from each other.
- **ref/time**: time of ref over that of the row."""


def add_options(parser):
    """Declare what the report may be told."""
    shared.add_scene(parser, "golem/oil")
    shared.add_seed(parser)
    shared.add_numbers(parser)
    shared.add_output(parser, "epsilon_SCENE_SIZE")


def main(options):
    """Make the report; returns the exit code."""
    scene = shared.scene_of(options)
    folder = shared.folder_of(options, f"epsilon_{scene.name}_{scene.size}")
    epsilon_report(scene, folder, options.seed, not options.numbers)
    return shown(folder)


def epsilon_report(scene, folder, seed=0, pictures=True):
    """Stylize a scene at every ε of the thesis and write images, numbers and a page.

    Parameters
    ----------
    scene : Scene
    folder : Path
    seed : int
    pictures : bool
        False leaves out every image, for scenes that we may not show.

    Returns
    -------
    pandas.DataFrame
    """
    ref = Params()
    maps = [
        replace(ref, method="guide_map", epsilon=epsilon)
        for epsilon in (0, 1e-3, *EPSILONS, BEYOND)
    ]
    settings = [("ref", ref, seed), ("ref, another seed", ref, seed + 1)]
    settings += [(f"ε = {params.epsilon:g}", params, seed) for params in maps]
    rows, results = [], {}
    for name, params, setting_seed in tqdm(settings, unit="run", disable=None):
        job = Job(scene, StylitRef(params), setting_seed)
        result = results[name] = run(job)
        found = numbers(job, ("image_energy", "spilling"))
        reference = results["ref"]
        rows.append(
            {
                "method": name,
                "white": f"{result.guide_map.mean():.1%}" if name.startswith("ε") else "",
                "PSNR": f"{psnr(result.image, reference.image):.2f}",
                "SSIM": f"{ssim(result.image, reference.image):.3f}",
                **({"spilled": f"{found['spilled']:.2%}"} if scene.ids else {}),
                "image energy": f"{found['image_energy']:.0f}",
                "processor time [s]": f"{result.processor_seconds:.2f}",
                "ref/time": f"{reference.processor_seconds / result.processor_seconds:.2f}",
            }
        )
    frame = pd.DataFrame(rows)
    costs = _costs(scene, seed)
    equal = all(
        np.array_equal(getattr(results["ε = 0"], name), getattr(results["ref"], name))
        for name in ("image", "nnf", "omega")
    )
    with new_report(folder) as report:
        sections = [
            provenance(),
            *([_figure(scene, results, seed, report)] if pictures else []),
            report.table("epsilon", frame, frame),
            f"Thesis configuration, λ = 10000, seed {seed}. At ε = 0 image, NNF and Ω are "
            f"{'those of ref, byte for byte' if equal else 'NOT those of ref'}. Above 0, however "
            "little, patches whose guides do not vary at all are white.",
            f"{DEFINITIONS}\n{definitions(('image_energy', 'spilled'))}",
            "Time of the synthesis with and without guide maps, each with and without the exact "
            "lower bound of the SSD by moments; the least of three runs each, in turns, in one "
            "process:",
            report.table("costs", costs, costs.round(2)),
        ]
        report.page(f"Guide maps on {scene.name}, {scene.size}", sections)
    return frame


def _costs(scene, seed):
    """Times with and without the exact lower bound, for ref and three guide maps."""
    methods = {
        "ref": Params(),
        "guide_map, ε = 100": Params("guide_map", epsilon=100.0),
        "guide_map, all black": Params("guide_map", epsilon=BLACK),
        "guide_map, all white": Params("guide_map", epsilon=WHITE),
    }
    unbounded = replaced(passes, random_search=plain_random_search)
    searches = {"with the bound": passes, "without": unbounded}
    seconds = {(method, search): [] for method in methods for search in searches}
    for params in methods.values():
        compile_kernels(scene, params)
    with tqdm(total=3 * len(seconds), unit="timing", disable=None) as bar:
        for _ in range(3):
            for method, params in methods.items():
                fields = []
                for search, module in searches.items():
                    elapsed, nnf = _synthesis(scene, params, module, seed)
                    seconds[method, search].append(elapsed)
                    fields.append(nnf)
                    bar.update()
                if not np.array_equal(*fields):
                    raise AssertionError(f"{method}: the bound changed the result")
    times = pd.Series({key: min(values) for key, values in seconds.items()}).unstack(sort=False)
    times["saved by the bound"] = times["without"] / times["with the bound"]
    for search in searches:
        times[f"ref/time, {search}"] = times.loc["ref", search] / times[search]
    return times.rename_axis("method").reset_index()


def _synthesis(scene, params, module, seed):
    """Seconds and NNF of a synthesis with the given module of passes."""
    start = time.perf_counter()
    images = scene.style, scene.source_guides, scene.target_guides
    level = make_synthesis(*images, params, seed=seed, backend=Backend(module)).finish()
    return time.perf_counter() - start, level.nnf


def _figure(scene, results, seed, report):
    """Thesis 5.2 to 5.8: style, guide, StyLit, ref, ε rising; then guide maps.

    The zoom shows where the thesis' largest ε differs most from ref: strokes are blurred away.
    """
    first = [
        ("style", scene.style),
        ("target guide", scene.shown_guide),
        ("StyLit", run(Job(scene, StylitRef(Params("stylit")), seed)).image),
        ("ref, λ = 10000", results["ref"].image),
    ]
    rising = {epsilon: results[f"ε = {epsilon}"] for epsilon in (*EPSILONS, BEYOND)}
    images = [(f"ε = {epsilon}", result.image) for epsilon, result in rising.items()]
    maps = [
        (f"guide map, ε = {epsilon}", rising[epsilon].guide_map[:, :, None] * np.uint8(255))
        for epsilon in MAPS_SHOWN
    ]
    difference = rising[EPSILONS[-1]].image.astype(float) - results["ref"].image
    strokes_away = gaussian(difference, 4, channel_axis=2)
    return report.figure(
        "epsilon",
        "ref, StyLit, ε rising, and guide maps",
        comparison,
        [[*first, images[0]], images[1:6], [*images[6:], *maps[:2]], maps[2:]],
        detailed_window((strokes_away**2).sum(axis=2)),
        committed=True,
    )
