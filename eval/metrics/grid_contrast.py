"""Whether fine detail comes and goes with the grid that a picture was blended on."""

import numpy as np

from eval.metrics.sharpness import detail
from eval.number import Number
from eval.scenes import Scene

PERIODS = range(2, 8)
"""Pixels from entry to entry of the grids that are looked for."""

NUMBERS = {"grid_contrast": Number("contrast of the grid", "{:.1%}")}

DEFINITION = """\
- **contrast of the grid**: by how much fine detail (see sharpness) rises and falls with a period of
  2 to 7 pixels, to the right or downwards: the largest amplitude over the mean. A picture that was
  blended on a grid is sharp where one patch covers a pixel, and soft where two or four do; one that
  knows no grid has nearly 0 %."""


def measure(scene, outcome):
    """The number of a single picture."""
    return {"grid_contrast": grid_contrast(outcome.image)} if isinstance(scene, Scene) else {}


def grid_contrast(image):
    """The largest amplitude of fine detail over its mean.

    Parameters
    ----------
    image : (H, W, n) uint8

    Returns
    -------
    float
        From 0 to 2; 0 for a picture without detail.
    """
    found = detail(image)
    if not found.any():
        return 0.0
    return max(_amplitude(found.mean(axis=axis), period) for axis in (0, 1) for period in PERIODS)


def _amplitude(profile, period):
    """Of one frequency, over the mean; whole periods alone count."""
    whole = profile[: len(profile) // period * period]
    if not whole.any():
        return 0.0
    by_phase = whole.reshape(-1, period).mean(axis=0)
    waves = np.abs(np.fft.rfft(by_phase))
    return float((1 if period == 2 else 2) * waves[1] / waves[0])
