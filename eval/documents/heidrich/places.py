"""Where a picture shows an artefact most: windows for figures 24, 25, 27 and 28."""

import numpy as np
from scipy.ndimage import uniform_filter

from eval.metrics.copying import MARGIN, SMALL
from eval.metrics.spilling import spilling
from eval.metrics.strokes import bent_strokes, hatching_kept
from eval.metrics.wrong_things import FOREGROUND, views_of
from eval.runs.store import stored

WINDOW = 64
"""Pixels along a window."""

_STEP = 16


def window_of(number, job):
    """The window where an artefact's number is worst.

    Parameters
    ----------
    number : str
        That of one of :data:`eval.documents.heidrich.artefacts.ARTEFACTS`.
    job : Job
        Its run must be stored.

    Returns
    -------
    tuple of 2 slices
    """
    run = stored(job)
    if number in _OF_WINDOWS:
        score = _OF_WINDOWS[number]
        return max(
            _windows(run.image.shape[:2]),
            key=lambda window: score(run.image[window], job.scene.style, run.nnf[window]),
        )
    return densest(_WHERE[number](job, run))


def densest(weights):
    """The window with the largest sum of weights, (H, W); the first of several such."""
    height, width = weights.shape
    side = min(WINDOW, height, width)
    sums = uniform_filter(weights.astype(float), side, mode="constant")
    half = side // 2
    inner = sums[half : height - side + half + 1, half : width - side + half + 1]
    y, x = np.unravel_index(np.argmax(inner.round(9)), inner.shape)
    return np.s_[y : y + side, x : x + side]


def _windows(size):
    side = min(WINDOW, *size)
    for y in range(0, size[0] - side + 1, _STEP):
        for x in range(0, size[1] - side + 1, _STEP):
            yield np.s_[y : y + side, x : x + side]


def _other_ground(job, run):
    outside = views_of(job.scene)[1].labels != FOREGROUND
    return spilling(run.nnf, job.scene.ids) & outside


def _foreground_outside(job, run):
    taken, labels = _labels(job, run)
    return (taken == FOREGROUND) & (labels != FOREGROUND)


def _other_side(job, run):
    taken, labels = _labels(job, run)
    return (taken == FOREGROUND) != (labels == FOREGROUND)


def _labels(job, run):
    source, target = views_of(job.scene)
    return source.labels[run.nnf[..., 0], run.nnf[..., 1]], target.labels


def _from_border(job, run):
    last = np.array(job.scene.style.shape[:2]) - 1
    near = (np.minimum(run.nnf, last - run.nnf) < MARGIN).any(axis=2)
    inside = np.zeros_like(near)
    inside[WINDOW // 4 : -(WINDOW // 4), WINDOW // 4 : -(WINDOW // 4)] = True
    return near & inside


def _stretched(job, run):
    steps = np.zeros(run.nnf.shape[:2], int)
    for axis, unit in ((0, (1, 0)), (1, (0, 1))):
        step = np.abs(np.diff(run.nnf, axis=axis) - unit).max(axis=2)
        where = np.s_[:-1] if axis == 0 else np.s_[:, :-1]
        steps[where] += (step > 0) & (step <= SMALL)
    return steps


def _highlights(job, run):
    return views_of(job.scene)[1].highlight


_WHERE = {
    "spilled": _other_ground,
    "foreground_outside": _foreground_outside,
    "style_border": _from_border,
    "silhouette_lines": _other_side,
    "stretched": _stretched,
    "lost_highlights": _highlights,
}

_OF_WINDOWS = {
    "bent": lambda image, style, nnf: image.std() * bent_strokes(image, style, nnf),
    "hatching": lambda image, style, nnf: image.std() * (1 - hatching_kept(image, style, nnf)),
}
"""Strokes that hardly show do not count: the weight is their contrast."""
