"""Measure time, memory and energy of whole programs on a scene.

With --ebsynth, both programs run on the same scene in turns, so that their ratios do not depend
on how fast or busy the machine is.
"""

import os
import sys
import tempfile
import time
from pathlib import Path

import numba
import pandas as pd
from tqdm import tqdm

from eval.methods.ebsynth import CONFIGURATION, Ebsynth, write_scene
from eval.methods.stylit_ref import compile_kernels
from eval.metrics.image_energy import image_energy
from eval.metrics.sharpness import richness
from eval.pages import options as shared
from eval.pages.page import new_report, shown
from eval.pages.tables import table
from eval.provenance import provenance
from eval.runs.process_cost import process_cost
from stylit_ref import PRESETS, Params, read_uint8, stylize

THESIS = {"uniformity": 10000, "levels": 6, "votes": 6, "patchmatch_iterations": 6}
EBSYNTH_DEFAULTS = CONFIGURATION
FAST = PRESETS["fast"] | {"uniformity": EBSYNTH_DEFAULTS["uniformity"]}
SCALES = (0.5, 1, 2, 4)
_FLAGS = {
    "uniformity": "--uniformity",
    "levels": "--pyramid-levels",
    "votes": "--search-vote-iters",
    "patchmatch_iterations": "--patchmatch-iters",
}


def add_options(parser):
    """Declare what the report may be told."""
    shared.add_scene(parser, "golem/crayon")
    parser.add_argument("--ebsynth", help="path of an ebsynth program to measure too")
    shared.add_output(parser, "bench_SCENE_SIZE")


def main(options):
    """Make the report; returns the exit code."""
    scene = shared.scene_of(options)
    folder = shared.folder_of(options, f"bench_{scene.name}_{scene.size}")
    bench(scene, folder, options.ebsynth)
    return shown(folder)


def bench(scene, folder, ebsynth=None):
    """Measure every configuration, several sizes and compilation, and write a page.

    Parameters
    ----------
    scene : Scene
    folder : Path
    ebsynth : str, optional
        Path of an ebsynth binary.

    Returns
    -------
    pandas.DataFrame
    """
    ours = {"stylit-ref": _stylit_ref_command}
    both = dict(ours)
    if ebsynth:
        binary = Ebsynth(ebsynth).binary
        both["ebsynth"] = lambda images, configuration, output: Ebsynth(
            binary, **configuration
        ).command(*images, output)
    configurations = {
        "preset fast": (FAST, ours),  # with ebsynth's λ, for a fair comparison
        "ebsynth's defaults": (EBSYNTH_DEFAULTS, both),
        "thesis configuration": (THESIS, both),
    }
    rows = []
    with tempfile.TemporaryDirectory() as workplace, tqdm(unit="program", disable=None) as bar:
        images = write_scene(scene, Path(workplace))
        for name, (configuration, programs) in configurations.items():
            for program, command in programs.items():
                bar.set_description(f"{program}, {name}")
                output = Path(workplace) / f"{program}.png"
                compile_kernels(scene, Params(**configuration))
                cost = process_cost(command(images, configuration, output))
                image = read_uint8(output)
                energy = image_energy(scene, image)
                rows.append(
                    {
                        "configuration": name,
                        "program": program,
                        "process [s]": cost.seconds,
                        "synthesis [s]": cost.seconds
                        if program == "ebsynth"
                        else _synthesis_seconds(scene, configuration),
                        "CPU [s]": cost.processor_seconds,
                        "peak [MiB]": cost.mebibytes,
                        "image energy": energy.mean,
                        "distinct in image": energy.distinct,
                        "richness": richness(image, scene.style),
                    }
                )
                bar.update()
        compilation = _compilation(images, Path(workplace))
        sizes = _sizes(scene, Path(workplace), bar)
    frame = pd.DataFrame(rows)
    shown = frame.copy()
    for column in shown.columns[2:]:
        precise = column in ("distinct in image", "richness")
        shown[column] = shown[column].map(("{:.3f}" if precise else "{:.1f}").format)
    lines = [*(_ratios(frame) if ebsynth else []), compilation, _thread_ratio(scene)]
    with new_report(folder) as report:
        sections = [
            provenance(),
            report.table("bench", frame, shown),
            "Preset fast and ebsynth's defaults: λ = 3500. "
            "Process: the whole program, start to end, with kernels that an earlier process has "
            "compiled. Synthesis: without start and files, in a run of its own (for ebsynth the "
            "whole process). "
            "Image energy: mean δ of the best matches that 30 PatchMatch iterations at λ = 0 find "
            "on the finished image. Richness: high-frequency energy of the image over that of the "
            "style.",
            "\n".join(lines),
            "Sizes: the thesis configuration on the scene enlarged or reduced.",
            table(sizes),
        ]
        report.page(f"Bench on {scene.name}, {scene.size}", sections)
    return frame


def _thread_ratio(scene):
    """Time of one thread over that of all threads, on two votes of the thesis configuration."""
    available = numba.config.NUMBA_NUM_THREADS
    params = Params(**(THESIS | {"votes": 2, "patchmatch_iterations": 2}))
    compile_kernels(scene, params)
    seconds = []
    for threads in (1, available):
        start = time.perf_counter()
        stylize(scene.style, scene.source_guides, scene.target_guides, params, threads=threads)
        seconds.append(time.perf_counter() - start)
    return f"- one thread takes {seconds[0] / seconds[1]:.2f} times as long as {available}."


def _ratios(frame):
    """Ebsynth over stylit-ref, a line for each configuration; ``fast`` is against its defaults."""
    lines = []
    for ours in frame[frame["program"] == "stylit-ref"].to_dict("records"):
        name = ours["configuration"]
        against = "ebsynth's defaults" if name == "preset fast" else name
        theirs = frame[(frame["program"] == "ebsynth") & (frame["configuration"] == against)]
        theirs = theirs.iloc[0]
        lines.append(
            f"- {name}: ebsynth ({against}) takes "
            f"{theirs['synthesis [s]'] / ours['synthesis [s]']:.1f} times the synthesis and "
            f"{theirs['process [s]'] / ours['process [s]']:.1f} times the process; its image "
            f"energy is {theirs['image energy'] / ours['image energy']:.3f} times ours."
        )
    return lines


def _compilation(images, workplace):
    """Time of a first process against that of later ones, from two runs with a new cache."""
    command = _stylit_ref_command(images, FAST, workplace / "first.png")
    environment = os.environ | {"NUMBA_CACHE_DIR": str(workplace / "kernels")}
    first, later = (process_cost(command, environment).seconds for _ in range(2))
    return (
        f"- compilation: the first process on a machine takes {first - later:.1f} s longer than "
        f"later ones (preset fast: {first:.1f} s, then {later:.1f} s)."
    )


def _sizes(scene, workplace, bar):
    """Time and memory of the thesis configuration by the number of pixels."""
    rows = []
    for scale in SCALES:
        size = scene.target_guides[0].shape[:2]
        scaled = scene.resized(tuple(round(scale * length) for length in size))
        bar.set_description(f"stylit-ref, {scaled.size}")
        folder = workplace / scaled.size
        folder.mkdir()
        cost = process_cost(
            _stylit_ref_command(write_scene(scaled, folder), THESIS, folder / "out.png")
        )
        pixels = scaled.target_guides[0].shape[0] * scaled.target_guides[0].shape[1]
        rows.append(
            {
                "size": scaled.size,
                "process [s]": f"{cost.seconds:.1f}",
                "µs a pixel": f"{1e6 * cost.seconds / pixels:.1f}",
                "peak [MiB]": f"{cost.mebibytes:.0f}",
                "bytes a pixel": f"{cost.mebibytes * 2**20 / pixels:.0f}",
            }
        )
        bar.update()
    return pd.DataFrame(rows)


def _synthesis_seconds(scene, configuration):
    params = Params(**configuration)
    compile_kernels(scene, params)
    start = time.perf_counter()
    stylize(scene.style, scene.source_guides, scene.target_guides, params)
    return time.perf_counter() - start


def _stylit_ref_command(images, configuration, output):
    style, pairs = images
    command = [sys.executable, "-m", "stylit_ref.cli", "run", "--quiet", "--style", str(style)]
    for source, target in pairs:
        command += ["--guide", str(source), str(target)]
    for name, flag in _FLAGS.items():
        value = configuration[name]
        command += [flag, ",".join(map(str, value)) if isinstance(value, tuple) else str(value)]
    return [*command, "--output", str(output)]
