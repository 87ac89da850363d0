"""A long shot from the command line, files included: time, memory, and whether paint moves along.

The frames are those of a turning figure, stretched, forth and back until there are enough: they are
as many pixels as those of a film, and what is drawn is not.
"""

import sys
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pandas as pd
from PIL import Image

from data_gen.multilayer_exr import write_layers
from eval.device import processor
from eval.metrics.warping import warping_error
from eval.outcome import Outcome
from eval.pages.claims import OPEN, Claim, verdict
from eval.read_frames import read_frames
from eval.runs.process_cost import process_cost
from eval.runs.store import stored
from stylit_ref import read_uint8, write_image
from stylit_ref.cli import sequence
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.views.frames import Motion

GUIDES = "FULL", "LDE", "LSE", "LDDE"
"""As StyLit's authors have them."""

MOST_SECONDS, MOST_OF_ALONE = 75, 0.5
"""Goals on two idle cores; the error is over that of frames without motion."""

_CODE = code_digest(__file__, sequence, without=("gpu_cuda",))


@dataclass(frozen=True)
class LongShot:
    """``stylit-ref sequence`` on many large frames, one after the other.

    Attributes
    ----------
    frames : int
    size : tuple of int
        Height and width.
    beside : int
        How many of them are stylized without motion, too, for comparison.
    options : tuple of str
        Of the command.
    """

    frames: int = 100
    size: tuple[int, int] = (544, 960)
    beside: int = 16
    options: tuple[str, ...] = ("--preset", "fast")

    name = "long shot"
    cost = 40.0
    alone = True

    @property
    def code(self):
        """Digest of the command."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, scene, seed, progress=None):
        """Write the files, run the command on them, and read what it wrote.

        Parameters
        ----------
        scene : FrameSet
            A sequence.
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            Four of the frames. The history has one row: wall ``seconds``, those of the processor
            (``cpu``), ``mebibytes`` of memory, ``states`` in megabytes of the work folder at the
            end, and the warping errors ``coherent`` and ``alone`` of the frames that were stylized
            in both ways.
        """
        with TemporaryDirectory() as name:
            folder = Path(name)
            edges = _write(scene, self, folder)
            self._stylize(folder, seed, "warm", 2, True)  # compiles the kernels
            cost = self._stylize(folder, seed, "coherent", self.frames, True)
            self._stylize(folder, seed, "alone", self.beside, False)
            coherent, alone = (
                np.stack([read_uint8(file) for file in sorted((folder / way).iterdir())])
                for way in ("coherent", "alone")
            )
            states = sum(file.stat().st_size for file in (folder / "coherent_work").iterdir())
        pairs = [pair for pair in edges if max(pair) < self.beside]
        row = {
            "seconds": cost.seconds,
            "cpu": cost.processor_seconds,
            "mebibytes": cost.mebibytes,
            "states": states / 1e6,
            "coherent": warping_error(coherent, edges, pairs),
            "alone": warping_error(alone, edges, pairs),
        }
        shown = np.linspace(0, self.frames - 1, 4).astype(int)
        return Outcome(coherent[shown], cost.seconds, history=pd.DataFrame([row]))

    def _stylize(self, folder, seed, way, frames, with_motion):
        (folder / way).mkdir()
        command = [sys.executable, "-m", "stylit_ref", "sequence", *self.options, "--quiet"]
        command += ["--style", folder / "style.png", "--seed", seed, "--frames", f"1-{frames}"]
        for guide in sorted(folder.glob("source_*.png")):
            number = guide.stem.removeprefix("source_")
            command += ["--guide", guide, folder / f"shot/{number}.%04d.png"]
        if with_motion:
            command += ["--motion", folder / "motion/%04d_to_%04d.exr"]
        command += ["--work", folder / f"{way}_work", "--output", folder / way / "%04d.png"]
        return process_cost(list(map(str, command)))


def _write(scene, shot, folder):
    """Write style, guides and motion as files; returns the motion, by pairs of frames."""
    for name in ("shot", "motion"):
        (folder / name).mkdir()
    write_image(folder / "style.png", scene.style)
    for number, guide in enumerate(scene.source_guides):
        write_image(folder / f"source_{number}.png", guide)
    turns = [abs((k + scene.frames - 1) % (2 * scene.frames - 2) - scene.frames + 1)
             for k in range(shot.frames)]  # fmt: skip
    for frame, turn in enumerate(turns):
        for number, guide in enumerate(scene.guides[turn]):
            image = Image.fromarray(guide.squeeze()).resize(shot.size[::-1])
            image.save(folder / f"shot/{number}.{frame + 1:04d}.png", compress_level=1)
    edges = {}
    for frame in range(1, shot.frames):
        for to, other in ((frame, frame - 1), (frame - 1, frame)):
            motion = _stretched(scene.edges[turns[to], turns[other]], shot.size)
            layers = {"MOTION": motion.field, "VISIBLE": np.float32(motion.visible)[..., None]}
            write_layers(folder / f"motion/{to + 1:04d}_to_{other + 1:04d}.exr", layers)
            if frame < shot.beside:
                edges[to, other] = motion
    return edges


def _stretched(motion, size):
    """Motion of a frame of another size: each pixel has that of the pixel that it lies in."""
    scale = np.array(size) / motion.visible.shape
    rows, columns = (np.arange(n) * m // n for n, m in zip(size, motion.visible.shape, strict=True))
    place = np.ix_(rows, columns)
    return Motion(np.float32(motion.field[place] * scale[::-1]), motion.visible[place])


def read_turning(data, style):
    """The turning figure of ``make data SCENES=turning SIZE=500x500``, with StyLit's guides.

    Parameters
    ----------
    data : Path
    style : str

    Returns
    -------
    FrameSet
    """
    return read_frames("turning", style, data, GUIDES)


def claims(job):
    """Whether a long shot is quick, and moves along.

    Parameters
    ----------
    job : Job or None
        Stored; None if it is not done.

    Returns
    -------
    list of Claim
    """
    row = None if job is None else stored(job).history.iloc[0]
    return [
        Claim(
            f"100 frames of 960x544 take at most {MOST_SECONDS} s with `--preset fast`",
            "ours",
            OPEN if row is None else verdict(row["seconds"] <= MOST_SECONDS),
            "`stylit-ref sequence` takes no longer by the clock, files and start included, kernels "
            "compiled; on two cores, which must be idle",
            "it is not part of this preset, or its frames are not rendered"
            if row is None
            else f"it takes {row['seconds']:.0f} s, {row['cpu']:.0f} s of the processor and "
            f"{row['mebibytes']:.0f} MiB; ReEzSynth's own README says 46 s a pass on an RTX 3060, "
            "with flow that it finds itself: not the same work",
            of_time=True,
        ),
        Claim(
            f"In the long shot the error is at most {MOST_OF_ALONE} of that without motion",
            "ours",
            OPEN if row is None else verdict(row["coherent"] <= MOST_OF_ALONE * row["alone"]),
            "the warping error is so of the frames that are stylized in both ways",
            "it is not part of this preset, or its frames are not rendered"
            if row is None
            else f"it is {row['coherent']:.2f}, and {row['alone']:.2f} without motion",
        ),
    ]
