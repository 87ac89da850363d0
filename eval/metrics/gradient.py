"""Whether coherence was paid for with blur."""

import numpy as np

from eval.frame_sets import FrameSet
from eval.metrics.sharpness import sharpness
from eval.number import Number

NUMBERS = {
    "gradient": Number("gradient", "{:.2f}"),
    "crispness": Number("sharpness of frames", "{:.3f}"),
}

DEFINITION = """\
- **gradient**: mean length of the gradient of luma, differences of neighbouring pixels, in 8-bit
  steps; blur lowers it. **sharpness of frames**: energy above a Gaussian blur (σ = 1 pixel) over
  that of the style at the pixels it was taken from, the mean over frames."""

LUMA = (0.299, 0.587, 0.114)


def measure(scene, outcome):
    """The gradient, and sharpness if the method tells its NNF."""
    if not isinstance(scene, FrameSet):
        return {}
    numbers = {"gradient": float(np.mean([gradient(image) for image in outcome.image]))}
    if outcome.nnf is not None:
        frames = zip(outcome.image, outcome.nnf, strict=True)
        numbers["crispness"] = float(
            np.mean([sharpness(image, scene.style, nnf) for image, nnf in frames])
        )
    return numbers


def luma(image):
    """Luma of an image of one or three channels, (..., H, W) float."""
    return image @ np.array(LUMA) if image.shape[-1] == 3 else image[..., 0].astype(float)


def gradient(image):
    """Mean length of the gradient of luma.

    Parameters
    ----------
    image : (H, W, n) uint8

    Returns
    -------
    float
    """
    values = luma(image)
    down, along = np.diff(values, axis=0)[:, :-1], np.diff(values, axis=1)[:-1]
    return float(np.hypot(down, along).mean())
