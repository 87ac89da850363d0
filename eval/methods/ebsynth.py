"""Ebsynth (Jamriška 2018), if its program is installed; it reads and writes files."""

import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from eval.device import processor
from eval.methods.foreign_program import digest_of, find_program
from eval.outcome import Outcome
from stylit_ref import InputError, Params, read_image, read_uint8, write_image

CONFIGURATION = {"uniformity": 3500, "levels": 7, "votes": 6, "patchmatch_iterations": 4}
"""Ebsynth's defaults, by the names of :class:`stylit_ref.Params`."""

_FLAGS = {
    "uniformity": "-uniformity",
    "levels": "-pyramidlevels",
    "votes": "-searchvoteiters",
    "patchmatch_iterations": "-patchmatchiters",
}


@dataclass(frozen=True)
class Ebsynth:
    """A run of the program on the CPU.

    Attributes
    ----------
    program : str
        Path of the program, or its name if it is on PATH.
    uniformity : float
    levels, votes, patchmatch_iterations : int
    """

    program: str
    uniformity: float = 3500
    levels: int = 7
    votes: int = 6
    patchmatch_iterations: int = 4

    cost = 10.0
    alone = True

    @property
    def name(self):
        """The program and its λ."""
        return f"ebsynth, λ = {self.uniformity:g}"

    @property
    def code(self):
        """Digest of the binary."""
        return digest_of(self.binary)

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    @property
    def binary(self):
        """Path of the program.

        Raises
        ------
        InputError
            If it cannot be started.
        """
        return find_program(self.program, "ebsynth")

    def command(self, style, guides, output):
        """The command line, with weights that give the same metric as ours.

        Every guide channel weighs μ/n_g, and every style channel 1/n_s.

        Parameters
        ----------
        style, output : Path
        guides : sequence of (Path, Path)
            Files of source and target.

        Returns
        -------
        list of str
        """
        command = [self.binary, "-style", str(style), "-weight", "1", "-backend", "cpu"]
        channels = [read_image(source).shape[2] for source, _ in guides]
        for (source, target), count in zip(guides, channels, strict=True):
            weight = Params().guide_influence * count / sum(channels)
            command += ["-guide", str(source), str(target), "-weight", str(weight)]
        for name, flag in _FLAGS.items():
            command += [flag, str(getattr(self, name))]
        return [*command, "-output", str(output)]

    def run(self, scene, seed, progress=None):
        """Stylize a scene; there is no seed to choose.

        Parameters
        ----------
        scene : Scene
        seed : int
        progress : callable, optional
            Not called: the program reports no steps.

        Returns
        -------
        Outcome
            The image only. Its time includes the program's start and its files.
        """
        with tempfile.TemporaryDirectory() as folder:
            style, guides = write_scene(scene, Path(folder))
            output = Path(folder) / "output.png"
            start = time.perf_counter()
            done = subprocess.run(
                self.command(style, guides, output),
                check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                text=True, errors="replace",
            )  # fmt: skip
            seconds = time.perf_counter() - start
            if done.returncode:
                said = done.stdout[-300:].strip()
                raise InputError(f"{self.program} failed with code {done.returncode}: {said}")
            return Outcome(read_uint8(output), seconds)


def write_scene(scene, folder):
    """Write a scene's images as files, at the size it was loaded.

    Parameters
    ----------
    scene : Scene
    folder : Path

    Returns
    -------
    style : Path
    guides : list of (Path, Path)
        Of source and target.
    """
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
