"""Undo the light that a sheet was photographed in: its white paper shows it."""

import numpy as np
from numpy.typing import NDArray

_NEAR, _FAR = 20, 180
"""Between these distances from the picture, in dots, the paper is plain but for the marks."""

_ROUNDS = 10

_PAINT = 0.01
"""What counts a place that is darker than the light found so far; paper is what is brightest."""

_MARGINS = 0.3, 0.15, 0.08
"""Within these of the light, as logarithms, a place is paper."""

_LEAST_PAPER = 0.25
"""Paper is so much as bright as the brightest of the picture at least; else it is a table."""


def paper_places(width: int, height: int, step: float) -> NDArray[np.float64]:
    """Places on the plain paper beside each side of a picture.

    Parameters
    ----------
    width, height : int
        Of the picture, in dots.
    step : float
        Between places, in dots.

    Returns
    -------
    (N, 2) float64
        (x, y) in dots.
    """
    x, y = np.arange(step / 2, width, step), np.arange(step / 2, height, step)
    away = np.arange(_NEAR + step / 2, _FAR, step)
    places = [
        np.stack(np.meshgrid(x, side), axis=-1).reshape(-1, 2) for side in (-away, height + away)
    ]
    places += [
        np.stack(np.meshgrid(side, y), axis=-1).reshape(-1, 2) for side in (-away, width + away)
    ]
    return np.concatenate(places)


def evened(
    picture: NDArray[np.uint8],
    places: NDArray[np.float64],
    paper: NDArray[np.uint8],
) -> NDArray[np.uint8]:
    """Divide a picture by the light on it, so that paper is white.

    The light of each colour is the exponential of a quadratic polynomial, fitted to what is seen of
    the paper; whatever is darker, such as paint, is left out.

    Parameters
    ----------
    picture : (H, W, 3) uint8
    places : (N, 2) float64
        Where the paper was seen: (x, y) in pixels of the picture, outside it.
    paper : (N, 3) uint8
        Its colours.

    Returns
    -------
    (H, W, 3) uint8
        The picture as it is, if what was seen beside it is too dark for paper.
    """
    height, width = picture.shape[:2]
    light = _LINEAR[picture]
    seen = np.maximum(_LINEAR[paper], 1e-3)
    brightest = np.quantile(light.mean(axis=2), 0.98)
    if np.median(seen.mean(axis=1)) < _LEAST_PAPER * brightest:
        return picture
    shapes = _light(_terms(places, width, height), np.log(seen))
    x, y = np.arange(width) + 0.5, np.arange(height) + 0.5
    where = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    white = np.exp(_terms(where, width, height) @ shapes).reshape(picture.shape)
    return _encoded(light / white)


def _light(terms, logarithms):
    """The polynomial of each colour, (6, 3): through what is brightest, then through its like."""
    brightness = logarithms.mean(axis=1)
    counts = np.ones(len(brightness))
    for _ in range(_ROUNDS):
        shape = _fitted(terms, brightness, counts)
        counts = np.where(brightness > terms @ shape, 1, _PAINT)
    for margin in _MARGINS:
        near = np.abs(brightness - terms @ shape) < margin
        shape = _fitted(terms, brightness, near)
    return np.linalg.lstsq(terms[near], logarithms[near])[0]


def _fitted(terms, values, weights):
    root = np.sqrt(weights)
    return np.linalg.lstsq(terms * root[:, None], values * root)[0]


def _terms(places, width, height):
    x, y = (2 * places / (width, height) - 1).T
    return np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=1)


def _encoded(light):
    light = np.clip(light, 0, 1)
    shown = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    return np.floor(255 * shown + 0.5).astype(np.uint8)


_STEPS = np.arange(256) / 255
_LINEAR = np.where(_STEPS <= 0.04045, _STEPS / 12.92, ((_STEPS + 0.055) / 1.055) ** 2.4)
