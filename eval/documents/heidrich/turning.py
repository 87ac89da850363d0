"""A target that turns: whether warm frames stay calm and still show what they should."""

import hashlib
import json
import time
from dataclasses import dataclass, replace

import pandas as pd

from data_gen.manifest import Manifest
from eval.documents.heidrich.stage import of_stage
from eval.flicker import calm, read_motion
from eval.methods.realtime import Frames
from eval.metrics.image_energy import image_energy
from eval.on_processor import OnProcessor
from eval.outcome import Outcome
from eval.runs.job import Job
from stylit_ref.realtime.params import RealtimeParams

SCENE = "turning"


@dataclass(frozen=True)
class Turning(OnProcessor):
    """Every frame of ``turning``, warm and cold, and a picture that is never drawn anew.

    Attributes
    ----------
    data : str
        Folder of the data set.
    digest : str
        Of all its frames and motion.
    style : str
    presets : tuple of str
    """

    data: str
    digest: str
    style: str
    presets: tuple[str, ...]

    name = "turning"
    cost = 50.0

    def run(self, scene, seed, progress=None):
        """Make the frames.

        Parameters
        ----------
        scene : Scene
            The first frame's.
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The history has a row for each way: ``preset``, ``frames``, ``flicker`` in 8-bit steps,
            ``rise`` of the last frame's energy over that of a cold one, and ``holds``. The image is
            the last warm frame of the last preset.
        """
        begun = time.perf_counter()
        names = frames_of(self.data)
        scenes = [scene, *(of_stage(name, self.style, self.data) for name in names[1:])]
        folder = Manifest.read(self.data).folder / SCENE / "motion"
        motions = [read_motion(folder, frame) for frame in range(len(scenes) - 1)]
        rows = []
        for preset in self.presets:
            cold, warm = (self._pictures(scenes, preset, seed, warm) for warm in (False, True))
            from_nothing = image_energy(scenes[-1], cold[-1]).mean
            for way, pictures in (
                ("cold", cold), ("warm", warm), ("the first, kept", [cold[0]] * len(cold)),
            ):  # fmt: skip
                energy = image_energy(scenes[-1], pictures[-1]).mean
                found = calm(pictures, motions, energy, from_nothing)
                row = {"preset": preset, "frames": way, **found._asdict(), "holds": found.holds}
                rows.append(row)
        history = pd.DataFrame(rows)
        return Outcome(warm[-1], time.perf_counter() - begun, history=history)

    def _pictures(self, scenes, preset, seed, warm):
        frames = Frames(scenes[0], RealtimeParams.preset(preset), (), seed)
        pictures = [frames.frame()]
        for scene in scenes[1:]:
            frames.show(scene)
            frames.take()
            pictures.append(frames.session.frame(warm=warm))
        return pictures


def turning(data, style, presets):
    """The run of a data set's turning target.

    Parameters
    ----------
    data : Path
        It must have the frames and their motion.
    style : str
    presets : tuple of str

    Returns
    -------
    Job
    """
    pieces = Manifest.read(data).pieces
    ours = {name: files for name, files in pieces.items() if name.startswith(f"{SCENE}/")}
    digest = hashlib.sha256(json.dumps(ours, sort_keys=True).encode()).hexdigest()
    first = replace(of_stage(frames_of(data)[0], style, data), name=f"{SCENE}_{style}")
    return Job(first, Turning(str(data), digest, style, presets))


def frames_of(data):
    """Names of the frames in a data set, in their order; none if it has no turning target."""
    return [name for name in Manifest.read(data).targets if name.startswith(f"{SCENE}/")]
