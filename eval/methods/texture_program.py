"""Other programs for texture synthesis, if they are installed; they read and write files."""

import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from eval.device import processor
from eval.methods.foreign_program import digest_of, find_program
from eval.outcome import Outcome
from stylit_ref import InputError, read_uint8, write_image


@dataclass(frozen=True)
class TextureProgram:
    """A run of a program.

    Attributes
    ----------
    name : str
        What reports call it.
    program : str
        Path of the program, or its name if it is on PATH.
    arguments : tuple of str
        ``{exemplar}``, ``{output}``, ``{width}``, ``{height}`` and ``{seed}`` stand for what they
        say.
    """

    name: str
    program: str
    arguments: tuple[str, ...]

    cost = 20.0
    alone = True

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
        return find_program(self.program, self.name)

    def run(self, texture, seed, progress=None):
        """Synthesize a texture.

        Parameters
        ----------
        texture : Texture
        seed : int
        progress : callable, optional
            Not called: the program reports no steps.

        Returns
        -------
        Outcome
            The image only. Its time includes the program's start and its files.

        Raises
        ------
        InputError
            If the program fails; the message holds the end of what it said.
        """
        height, width = texture.shape
        with tempfile.TemporaryDirectory() as folder:
            exemplar, output = Path(folder) / "exemplar.png", Path(folder) / "output.png"
            write_image(exemplar, texture.exemplar)
            words = {"exemplar": exemplar, "output": output, "width": width, "height": height}
            command = [each.format(**words, seed=seed) for each in self.arguments]
            start = time.perf_counter()
            done = subprocess.run(
                [self.binary, *command],
                check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                text=True, errors="replace",
            )  # fmt: skip
            seconds = time.perf_counter() - start
            if done.returncode or not output.exists():
                said = done.stdout[-300:].strip()
                raise InputError(f"{self.program} failed with code {done.returncode}: {said}")
            image = read_uint8(output)[:, :, : texture.exemplar.shape[2]]
        return Outcome(image, seconds)


def gmic(program="gmic"):
    """G'MIC's patch-based resynthesis (``syntexturize_matchpatch``).

    Parameters
    ----------
    program : str
    """
    arguments = (
        "{exemplar}", "srand", "{seed}", "syntexturize_matchpatch", "{width},{height}", "round",
        "cut", "0,255", "-output", "{output}",
    )  # fmt: skip
    return TextureProgram("G'MIC", program, arguments)


def img2texture(program="img2texture"):
    """img2texture, which blends the edges of the exemplar; its tile is smaller than that.

    Parameters
    ----------
    program : str
    """
    arguments = "{exemplar}", "{output}", "--overlap=0.2"
    return TextureProgram("img2texture", program, arguments)


def embark(program="texture-synthesis"):
    """EmbarkStudios' texture-synthesis, told to tile, with one thread: else its bytes differ.

    Parameters
    ----------
    program : str
    """
    arguments = (
        "--out", "{output}", "--out-size", "{width}x{height}", "--seed", "{seed}", "--threads", "1",
        "--tiling", "generate", "{exemplar}",
    )  # fmt: skip
    return TextureProgram("texture-synthesis", program, arguments)
