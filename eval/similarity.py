"""Measures of how similar two images are, pixel by pixel."""

import flip_evaluator
import numpy as np
from skimage.filters import gaussian
from skimage.metrics import peak_signal_noise_ratio, structural_similarity

from eval.number import Number

NUMBERS = {
    "PSNR": Number("PSNR [dB]", "{:.1f}"),
    "SSIM": Number("SSIM", "{:.3f}"),
    "FLIP": Number("FLIP", "{:.3f}"),
}

DEFINITION = """\
- **PSNR**, **SSIM** (mean over channels, 7x7 windows) and **FLIP** (mean; 0 alike, 1 as unlike as
  can be; 67 pixels a degree)"""

SMOOTHED = 100
"""Single strokes are smoothed away by a Gaussian of an image's width over this number."""


def psnr(image, reference):
    """Peak signal-to-noise ratio in dB; infinite for equal images.

    Parameters
    ----------
    image, reference : (H, W, n) uint8

    Returns
    -------
    float
    """
    if (image == reference).all():
        return float("inf")
    return float(peak_signal_noise_ratio(reference, image, data_range=255))


def smooth_psnr(image, reference):
    """PSNR of the colours of larger places: both images are smoothed first.

    Parameters
    ----------
    image, reference : (H, W, n) uint8

    Returns
    -------
    float
    """
    width = image.shape[1] / SMOOTHED
    return psnr(*(_smoothed(each, width) for each in (image, reference)))


def ssim(image, reference):
    """Mean structural similarity over all channels (7x7 windows), up to 1.

    Parameters
    ----------
    image, reference : (H, W, n) uint8

    Returns
    -------
    float
    """
    return float(structural_similarity(reference, image, channel_axis=2, data_range=255))


def flip(image, reference):
    """Mean FLIP: how visible the difference is when both are shown in turns, 0 to 1.

    Seen from 0.7 m on a monitor 0.7 m wide with 3840 pixels, the defaults of FLIP.

    Parameters
    ----------
    image, reference : (H, W, n) uint8
        With 1 or 3 channels; otherwise the first channel is compared.

    Returns
    -------
    float
    """
    shown = (_in_unit_range(each) for each in (reference, image))
    _, mean, _ = flip_evaluator.evaluate(*shown, "LDR", applyMagma=False)
    return float(mean)


def _smoothed(image, width):
    smooth = gaussian(image, width, channel_axis=2, preserve_range=True)
    return np.rint(smooth).astype(np.uint8)


def _in_unit_range(image):
    colour = image[:, :, :3] if image.shape[2] >= 3 else np.repeat(image[:, :, :1], 3, axis=2)
    return np.ascontiguousarray(colour, np.float32) / 255
