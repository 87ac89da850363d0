"""What Blender wrote for the scene of ``data_gen/blender_shot.py`` at 64x48."""

from pathlib import Path

import numpy as np

from stylit_ref import read_uint8
from stylit_ref.files.motion_file import read_vectors
from stylit_ref.views.motion.samples import Sample

FOLDER = Path(__file__).parent / "blender"


def frame(shot, number):
    """The file of a frame."""
    return FOLDER / shot / f"shot.{number:04}.exr"


def brightness(shot, number):
    """What a frame shows, (H, W) float32."""
    picture = read_uint8(f"{frame(shot, number)}:ViewLayer.Combined")
    return picture[:, :, :3].mean(axis=2, dtype=np.float32)


def sample(shot, number, frames):
    """The vectors of a frame, with the pictures beside it."""
    pictures = {
        step: (brightness(shot, number), brightness(shot, number + step))
        for step in (1, -1)
        if number + step in frames
    }
    return Sample(str(frame(shot, number)), read_vectors(frame(shot, number)), pictures)
