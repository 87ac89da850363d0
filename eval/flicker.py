"""Whether a picture stays calm while its object turns, and still shows its own frame.

Flicker is what changes of a point that both frames show. A picture that is never drawn anew would
flicker least on ground that stands still, so flicker is read together with energy: that of the last
frame over that of the same frame made from nothing.
"""

from typing import NamedTuple

import numpy as np
from scipy.ndimage import map_coordinates

from data_gen.multilayer_exr import read_layers

LARGEST_RISE = 1.01
"""Energy of the last frame over that of the frame made from nothing, at most."""


class Calm(NamedTuple):
    """Flicker of a sequence, and whether it was paid for with wrong frames.

    Attributes
    ----------
    flicker : float
        Mean warp error of the frames, in 8-bit steps.
    rise : float
        Energy of the last frame over that of the same frame made from nothing.
    """

    flicker: float
    rise: float

    @property
    def holds(self):
        """Whether the last frame is still as good as one made from nothing."""
        return self.rise <= LARGEST_RISE


def read_motion(folder, frame):
    """The motion from a frame to the next.

    Parameters
    ----------
    folder : Path
        ``turning/motion`` of a data set.
    frame : int

    Returns
    -------
    motion : (H, W, 2) float32
        (x, y) in pixels.
    visible : (H, W) bool
    """
    layers = read_layers(folder / f"{frame:02}_to_{frame + 1:02}.exr")
    return layers["MOTION"], layers["VISIBLE"][..., 0] > 0.5


def warp_error(before, after, motion, visible):
    """How much the points that both frames show have changed.

    Parameters
    ----------
    before, after : (H, W, n) uint8
        Two frames.
    motion : (H, W, 2) float
        Where each pixel of the first has gone, (x, y) in pixels.
    visible : (H, W) bool
        Pixels of the first that the second shows too.

    Returns
    -------
    float
        Mean absolute difference over channels and visible pixels, in 8-bit steps; the second frame
        is interpolated bilinearly. 0 if nothing is visible.
    """
    if not visible.any():
        return 0.0
    y, x = np.nonzero(visible)
    place = np.stack([y + motion[y, x, 1], x + motion[y, x, 0]])
    there = [
        map_coordinates(channel.astype(float), place, order=1, mode="nearest")
        for channel in np.moveaxis(after, -1, 0)
    ]
    return float(np.abs(np.stack(there, axis=-1) - before[y, x]).mean())


def calm(frames, motions, last_energy, energy_from_nothing):
    """Flicker and energy of a sequence, which mean nothing apart.

    Parameters
    ----------
    frames : sequence of (H, W, n) uint8
    motions : iterable of (motion, visible)
        From each frame to the next, as of :func:`read_motion`.
    last_energy : float
        Of the last frame.
    energy_from_nothing : float
        Of the last frame's target, stylized without the frames before.

    Returns
    -------
    Calm
    """
    errors = [
        warp_error(before, after, *motion)
        for before, after, motion in zip(frames[:-1], frames[1:], motions, strict=True)
    ]
    return Calm(float(np.mean(errors)), last_energy / energy_from_nothing)
