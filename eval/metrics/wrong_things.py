"""Paint of one thing on another, by name: artefacts of Heidrich 2017, Figures 24c, 25a and 28a."""

from typing import NamedTuple

import numpy as np
from scipy.ndimage import distance_transform_edt

from eval.number import Number

BAND = 3.0
"""Pixels on both sides of a silhouette."""

NUMBERS = {
    "wrong_id": Number("wrong ID", "{:.2%}"),
    "foreground_outside": Number("foreground in background", "{:.2%}"),
    "silhouette_lines": Number("lines at silhouettes", "{:.2%}"),
    "lost_highlights": Number("lost highlights", "{:.1%}"),
}

DEFINITION = """\
- Paint of one thing on another, on the stage of Heidrich 2017: foreground, background, cast shadow.
  **wrong ID**: target pixels taken from another of the three. **foreground in background**: pixels
  outside the foreground taken from it. **lines at silhouettes**: pixels at most 3 from the
  silhouette taken from the other side of the source's. **lost highlights**: pixels of the target's
  highlights whose colour is nearer to the lit object's than to the highlight's in the style."""

BACKGROUND, CAST_SHADOW, FOREGROUND = 0, 1, 2


class View(NamedTuple):
    """The masks of a view.

    Attributes
    ----------
    labels : (H, W) int
        One of the three above.
    highlight, lit : (H, W) bool
        Of the foreground.
    """

    labels: np.ndarray
    highlight: np.ndarray
    lit: np.ndarray


def measure(scene, outcome):
    """What of it the scene's masks and the method's NNF allow."""
    views = views_of(scene)
    if views is None:
        return {}
    source, target = views
    numbers = {}
    if source.highlight.any() and source.lit.any() and target.highlight.any():
        numbers["lost_highlights"] = lost_highlights(outcome.image, scene.style, source, target)
    if outcome.nnf is not None:
        taken = source.labels[outcome.nnf[..., 0], outcome.nnf[..., 1]]
        numbers["wrong_id"] = float((taken != target.labels).mean())
        numbers["foreground_outside"] = foreground_outside(taken, target.labels)
        numbers["silhouette_lines"] = silhouette_lines(taken, target.labels)
    return numbers


def views_of(scene):
    """The masks of source and target; None if the scene was read without LIGHTMASK."""
    if getattr(scene, "ids", None) is None or "LIGHTMASK" not in scene.buffers:
        return None
    return tuple(
        view_of(ids, light)
        for ids, light in zip(scene.ids, scene.buffers["LIGHTMASK"], strict=True)
    )


def view_of(idmask, lightmask):
    """The masks of a view.

    Parameters
    ----------
    idmask, lightmask : (H, W, 3) uint8
        Red in IDMASK is the foreground; LIGHTMASK is highlight, lit, shadow.

    Returns
    -------
    View
    """
    foreground = idmask[..., 0] > 127
    highlight, lit, shadow = np.moveaxis(lightmask > 127, -1, 0)
    labels = np.where(foreground, FOREGROUND, np.where(shadow, CAST_SHADOW, BACKGROUND))
    return View(labels, highlight & foreground, lit & foreground)


def foreground_outside(taken, labels):
    """Share of the pixels outside the foreground that are taken from it; 0 if there are none.

    Parameters
    ----------
    taken, labels : (H, W) int
        Label of each pixel's source, and its own.

    Returns
    -------
    float
    """
    outside = labels != FOREGROUND
    return float((taken[outside] == FOREGROUND).mean()) if outside.any() else 0.0


def silhouette_lines(taken, labels):
    """Share of the pixels near the silhouette whose source lies on its other side.

    Parameters
    ----------
    taken, labels : (H, W) int

    Returns
    -------
    float
        0 without a silhouette.
    """
    inside = labels == FOREGROUND
    if inside.all() or not inside.any():
        return 0.0
    near = np.where(inside, distance_transform_edt(inside), distance_transform_edt(~inside)) <= BAND
    return float(((taken == FOREGROUND) != inside)[near].mean())


def lost_highlights(image, style, source, target):
    """Share of the target's highlights that are painted as the lit object is.

    Parameters
    ----------
    image : (H_B, W_B, n) uint8
    style : (H_A, W_A, n) uint8
    source, target : View

    Returns
    -------
    float
    """
    painted = image[target.highlight].astype(float)
    shine, body = (
        ((painted - style[mask].mean(axis=0)) ** 2).sum(axis=1)
        for mask in (source.highlight, source.lit)
    )
    return float((body < shine).mean())
