"""Noise where the painting is blank paper: Hauptfleisch 2020, 2.4.1 and Figure 2.8."""

import numpy as np
from scipy.ndimage import binary_erosion

from eval.number import Number

LIGHT = "LIGHTMASK"
"""The guide or buffer that tells lit places from those in shadow."""

_BORDER = 1 / 15
"""Share of the height around other things that is left out: strokes leave the geometry."""

_FEWEST = 500
"""Pixels of a place that is looked at, in each of the two pictures."""

_INK = 30
"""8-bit steps by which a stroke is darker than the paper."""

_BLANK = 0.02
"""Share of strokes up to which a place of the painting counts as blank."""

NUMBERS = {
    "noise": Number("noise on white", "{:.1f}"),
    "specks": Number("specks on white", "{:.1%}"),
}

DEFINITION = """\
- **noise on white**: RMS difference, in 8-bit steps, from the colour of the paper, where the same
  things in the same light are blank in the painting, away from their borders; less that of the
  paper's own grain. **specks on white**: share of these pixels that are as dark as a stroke."""


def measure(scene, outcome):
    """Both numbers, if the scene's objects are known and some of them are left blank."""
    places = _places(scene)
    if places is None:
        return {}
    found = noise_on_white(outcome.image, scene.style, *places[::-1])
    return {} if found is None else dict(zip(NUMBERS, found, strict=True))


def noise_on_white(image, style, places, places_in_style):
    """How far an image is from blank paper where the style is blank.

    Parameters
    ----------
    image, style : (H, W, n) uint8
    places, places_in_style : (H, W) int
        A number for each kind of place, in the image and in the style.

    Returns
    -------
    (float, float) or None
        Noise and specks; None if no place is blank.
    """
    ours, theirs = (np.atleast_3d(picture).astype(float).mean(axis=2) for picture in (image, style))
    paper = np.quantile(theirs, 0.9)
    blank, grain = [], []
    for place in np.unique(places_in_style):
        here, there = (_inside(p == place) for p in (places, places_in_style))
        if min(here.sum(), there.sum()) < _FEWEST:
            continue
        if (theirs[there] < paper - _INK).mean() <= _BLANK:
            blank.append(ours[here])
            grain.append(theirs[there])
    if not blank:
        return None
    blank, grain = np.concatenate(blank), np.concatenate(grain)
    paper = np.median(grain)
    noise, own = (float(np.sqrt(((values - paper) ** 2).mean())) for values in (blank, grain))
    return noise - own, float((blank < paper - _INK).mean())


def _inside(mask):
    return binary_erosion(mask, iterations=max(1, round(_BORDER * mask.shape[0])), border_value=1)


def _places(scene):
    """What each pixel of source and target shows, and in which light; None if it is not known."""
    if scene.ids is None:
        return None
    codes = [_code(image) for image in scene.ids]
    if LIGHT in scene.guide_names:
        number = scene.guide_names.index(LIGHT)
        light = scene.source_guides[number], scene.target_guides[number]
        codes = [8 * code + _code(image) for code, image in zip(codes, light, strict=True)]
    return tuple(codes)


def _code(image):
    """A number for each colour of a mask."""
    white = np.atleast_3d(image)[..., :3] > 127
    return white @ 2 ** np.arange(white.shape[2])
