"""How much the paint of fixed surface points changes over all frames."""

import numpy as np

from eval.frame_sets import FrameSet
from eval.motion_paths import along, landing, shortest_paths
from eval.number import Number
from stylit_ref import InputError
from stylit_ref.views.frames import sequence_pairs

NUMBERS = {
    "flicker": Number("flicker", "{:.2f}"),
    "fast": Number("fast", "{:.0%}"),
    "followed": Number("followed", "{:.0%}"),
}

DEFINITION = """\
- **flicker**: points of the middle frame are followed through all others by composed motion. Mean
  over those seen in every frame, and channels, of the standard deviation of their value, in 8-bit
  steps. **fast**, of sequences: which share of that variance changes faster than once in four
  frames. **followed**: which share of the pixels is seen in every frame."""

_FASTEST_CALM = 0.25
"""Cycles a frame."""


def measure(scene, outcome):
    """All three numbers, as far as they apply."""
    if not isinstance(scene, FrameSet):
        return {}
    values = followed(outcome.image, scene.edges)
    numbers = {"followed": values.shape[1] / outcome.image[0, ..., 0].size}
    if values.shape[1]:
        numbers["flicker"] = float(values.std(axis=0).mean())
        if set(scene.edges) == set(sequence_pairs(scene.frames)) and scene.frames > 4:
            numbers["fast"] = fast_share(values)
    return numbers


def followed(images, edges):
    """Values of the points that all frames show.

    Parameters
    ----------
    images : (F, H, W, n) uint8
    edges : mapping

    Returns
    -------
    (F, P, n) float
        Of P points.
    """
    paths = middle_paths(edges, len(images))
    places = [landing(along(edges, path)) for frame, path in sorted(paths.items()) if len(path) > 1]
    middle = next(frame for frame, path in paths.items() if len(path) == 1)
    seen = np.logical_and.reduce(
        [np.ones(images.shape[1:3], np.bool_), *(each[2] for each in places)]
    )
    own = np.nonzero(seen)
    where = [(y[seen], x[seen]) for y, x, _ in places]
    where.insert(middle, own)
    return np.stack(
        [image[place].astype(float) for image, place in zip(images, where, strict=True)]
    )


def middle_paths(edges, frames):
    """Paths to all frames from the one from which the farthest is nearest.

    Parameters
    ----------
    edges : mapping
    frames : int

    Returns
    -------
    dict of int to tuple of int

    Raises
    ------
    InputError
        If no frame leads to all others.
    """
    found = [shortest_paths(edges, start) for start in range(frames)]
    whole = [paths for paths in found if len(paths) == frames]
    if not whole:
        missing = sorted(set(range(frames)).difference(max(found, key=len)))
        raise InputError(
            f"no motion joins the frames {', '.join(map(str, missing))} to the others; points are "
            "followed through all frames, so measure those that are joined",
            parameter="edges",
        )
    return min(whole, key=lambda paths: max(map(len, paths.values())))


def fast_share(values):
    """Which share of the variance over time is faster than one cycle in four frames.

    Parameters
    ----------
    values : (F, P, n) float

    Returns
    -------
    float
        0 if nothing changes.
    """
    power = np.abs(np.fft.rfft(values - values[0], axis=0)) ** 2
    power[1 : (len(values) + 1) // 2] *= 2  # stands for its mirror image, too
    sums = power.sum(axis=(1, 2))
    frequencies = np.fft.rfftfreq(len(values))
    whole = sums[1:].sum()
    return float(sums[frequencies > _FASTEST_CALM].sum() / whole) if whole else 0.0
