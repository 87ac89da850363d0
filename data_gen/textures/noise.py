"""Noise and colours that several exemplars share."""

import numpy as np
from scipy.ndimage import gaussian_filter


def smooth_noise(rng, size, sigma):
    """Blurred white noise of unit variance before the blur.

    Parameters
    ----------
    rng : numpy.random.Generator
    size : int
    sigma : float or tuple of 2 float
        Of the Gaussian, down and along.

    Returns
    -------
    (size, size, 1) float64
    """
    return gaussian_filter(rng.normal(size=(size, size)), sigma)[..., None]


def clouds(rng, size, coarsest=64.0):
    """Noise with detail at every scale: each octave half as wide and half as strong.

    Parameters
    ----------
    rng : numpy.random.Generator
    size : int
    coarsest : float
        Standard deviation of the widest blur in pixels.

    Returns
    -------
    (size, size) float64
        About -2 to 2.
    """
    total, sigma, strength = np.zeros((size, size)), coarsest, 1.0
    while sigma >= 1:
        octave = smooth_noise(rng, size, sigma)[..., 0]
        total += strength * octave / octave.std()
        sigma, strength = sigma / 2, strength / 2
    return total


def picture(colours, blur=0.7):
    """Colours as 8-bit steps, with edges as soft as a camera's.

    Parameters
    ----------
    colours : (H, W, 3) float
    blur : float

    Returns
    -------
    (H, W, 3) uint8
    """
    soft = gaussian_filter(colours, (blur, blur, 0))
    return np.rint(soft.clip(0, 255)).astype(np.uint8)
