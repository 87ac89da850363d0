"""Time, memory and energy of whole programs on a scene, in one run.

With the path of an ebsynth binary the same scene goes through both, so that ratios do
not depend on how fast or busy the machine is.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numba
import pandas as pd
from tqdm import tqdm

from eval.image_energy import image_energy
from eval.report import table, write_report
from eval.runs import compile_kernels
from stylit_ref import InputError, Params, read_image, read_uint8, stylize, write_image

THESIS = {"uniformity": 10000, "levels": 6, "votes": 6, "patchmatch_iterations": 6}
EBSYNTH_DEFAULTS = {"uniformity": 3500, "levels": 7, "votes": 6, "patchmatch_iterations": 4}
_FLAGS = {
    "uniformity": "--uniformity",
    "levels": "--pyramid-levels",
    "votes": "--search-vote-iters",
    "patchmatch_iterations": "--patchmatch-iters",
}


@dataclass(frozen=True)
class Cost:
    """What a finished process took: wall and processor seconds, MiB of memory."""

    seconds: float
    processor_seconds: float
    mebibytes: float


def timed(command):
    """Run a command to its end and account for it.

    Parameters
    ----------
    command : list of str

    Returns
    -------
    Cost

    Raises
    ------
    InputError
        If it fails; the message holds the end of its output.
    """
    with tempfile.TemporaryFile() as output:
        start = time.perf_counter()
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT)
        _, status, used = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            output.seek(0)
            tail = output.read()[-300:].decode(errors="replace").strip()
            raise InputError(f"{command[0]} failed with code {process.returncode}: {tail}")
    return Cost(seconds, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)


def bench(scene, folder, ebsynth=None):
    """Measure both configurations and write a page.

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
    if ebsynth and not shutil.which(ebsynth):
        raise InputError(f"{ebsynth}: is no program that can be started")
    folder.mkdir(parents=True, exist_ok=True)
    configurations = {"thesis configuration": THESIS, "ebsynth's defaults": EBSYNTH_DEFAULTS}
    rows = []
    with tempfile.TemporaryDirectory() as workplace, tqdm(unit="program", disable=None) as bar:
        images = _write_scene(scene, Path(workplace))
        for name, configuration in configurations.items():
            programs = {"stylit-ref": _stylit_ref_command}
            if ebsynth:
                programs["ebsynth"] = lambda *arguments: [ebsynth, *_ebsynth_arguments(*arguments)]
            for program, command in programs.items():
                bar.set_description(f"{program}, {name}")
                output = Path(workplace) / f"{program}.png"
                cost = timed(command(images, configuration, output))
                energy = image_energy(scene, read_uint8(output))
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
                    }
                )
                bar.update()
    frame = pd.DataFrame(rows)
    frame.to_csv(folder / "bench.csv", index=False)
    shown = frame.copy()
    for column in shown.columns[2:]:
        shown[column] = shown[column].map(("{:.3f}" if "distinct" in column else "{:.1f}").format)
    sections = [
        table(shown),
        "Process: the whole program, start to end, compilation of the kernels included. "
        "Synthesis: without compilation and files (for ebsynth the whole process). "
        "Image energy: mean δ of a converged λ = 0 search on the finished image.",
    ]
    sections.insert(1, _thread_ratio(scene))
    if ebsynth:
        sections.insert(1, _ratios(frame))
    write_report(folder, f"Bench on {scene.name}, {scene.size}", sections)
    return frame


def _thread_ratio(scene):
    """How much all threads save over one, on two votes of the thesis configuration."""
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
    """Ebsynth over stylit-ref, a line for each configuration."""
    lines = []
    for name, part in frame.groupby("configuration", sort=False):
        ours, theirs = (
            part[part["program"] == program].iloc[0] for program in ("stylit-ref", "ebsynth")
        )
        lines.append(
            f"- {name}: ebsynth takes {theirs['synthesis [s]'] / ours['synthesis [s]']:.1f} times "
            f"the synthesis and {theirs['process [s]'] / ours['process [s]']:.1f} times the "
            f"process; its image energy is {theirs['image energy'] / ours['image energy']:.3f} "
            "times ours."
        )
    return "\n".join(lines)


def _synthesis_seconds(scene, configuration):
    params = Params(**configuration)
    compile_kernels(scene, params)
    start = time.perf_counter()
    stylize(scene.style, scene.source_guides, scene.target_guides, params)
    return time.perf_counter() - start


def _write_scene(scene, folder):
    """The scene's images as files, at the size it was loaded."""
    write_image(folder / "style.png", scene.style)
    pairs = []
    for name, source, target in zip(
        scene.guide_names, scene.source_guides, scene.target_guides, strict=True
    ):
        files = folder / f"source_{name}.png", folder / f"target_{name}.png"
        for file, image in zip(files, (source, target), strict=True):
            write_image(file, image)
        pairs.append(files)
    return folder / "style.png", pairs


def _stylit_ref_command(images, configuration, output):
    style, pairs = images
    command = [sys.executable, "-m", "stylit_ref.cli", "run", "--quiet", "--style", str(style)]
    for source, target in pairs:
        command += ["--guide", str(source), str(target)]
    for name, flag in _FLAGS.items():
        command += [flag, str(configuration[name])]
    return [*command, "--output", str(output)]


def _ebsynth_arguments(images, configuration, output):
    """Equal metric: every guide channel weighs μ/n_g and every style channel 1/n_s."""
    style, pairs = images
    arguments = ["-style", str(style), "-weight", "1", "-backend", "cpu"]
    channels = [read_image(source).shape[2] for source, _ in pairs]
    for (source, target), count in zip(pairs, channels, strict=True):
        weight = Params().guide_influence * count / sum(channels)
        arguments += ["-guide", str(source), str(target), "-weight", str(weight)]
    for name, flag in _FLAGS.items():
        arguments += ["-" + flag.replace("-", ""), str(configuration[name])]
    return [*arguments, "-output", str(output)]
