"""How much of the style's fine detail is in the output.

Wash-out has two sides: voting averages patches that disagree (``sharpness``), and a
search free to repeat itself prefers the style's smooth patches (``richness``).
"""

import numpy as np
from skimage.filters import gaussian

from eval.number import Number

SIGMA = 1.0

NUMBERS = {
    "sharpness": Number("sharpness", "{:.3f}"),
    "richness": Number("richness", "{:.3f}"),
}

DEFINITION = """\
- Wash-out has two sides. **sharpness**: energy above a Gaussian blur (σ = 1 pixel) of the output
  over that of the style at the pixels it was taken from; below 1, voting blurs. **richness**: the
  same energy of the output over that of the whole style; lower, smooth patches are preferred."""


def measure(scene, outcome):
    """Richness, and sharpness if the method tells its NNF."""
    numbers = {"richness": richness(outcome.image, scene.style)}
    if outcome.nnf is not None:
        numbers["sharpness"] = sharpness(outcome.image, scene.style, outcome.nnf)
    return numbers


def detail(image):
    """High-frequency energy of each pixel: squared difference from a Gaussian blur.

    Parameters
    ----------
    image : (H, W, n) uint8

    Returns
    -------
    (H, W) float64
        Mean over channels, in squared 8-bit steps.
    """
    image = np.atleast_3d(image).astype(float)
    blurred = gaussian(image, SIGMA, channel_axis=2, preserve_range=True)
    return ((image - blurred) ** 2).mean(axis=2)


def sharpness(image, style, nnf):
    """High-frequency energy of an image over that of the style where it was taken from.

    1 where every pixel is as crisp as the style pixel it is assigned to; washed-out
    images fall below.

    Parameters
    ----------
    image : (H_B, W_B, n) uint8
    style : (H_A, W_A, n) uint8
    nnf : (H_B, W_B, 2) int32

    Returns
    -------
    float
    """
    taken_from = detail(style)[nnf[:, :, 0], nnf[:, :, 1]]
    return float(detail(image).sum() / taken_from.sum())


def richness(image, style):
    """Mean high-frequency energy of an image over that of the whole style.

    Parameters
    ----------
    image : (H_B, W_B, n) uint8
    style : (H_A, W_A, n) uint8

    Returns
    -------
    float
    """
    return float(detail(image).mean() / detail(style).mean())
