"""The four requirements of 1.1, each with a number and a threshold, for all methods.

The thesis prints one threshold: 15 frames a second. The others are judged there by eye.
"""

import numpy as np
import pandas as pd
from skimage.color import rgb2lab

from eval.documents.heidrich.plan import DENSE, METHODS, RIVALS, STYLES
from eval.documents.heidrich.printed import REAL_TIME
from eval.documents.heidrich.tables import frame_times
from eval.metrics.wrong_things import BACKGROUND, CAST_SHADOW, views_of
from eval.runs.store import numbers_of, stored

QUALITY = 1.25
"""Energy of a picture that is good, over that of StyLit: the mean over styles."""

ADAPTS = 1.5
"""Energy over that of StyLit in the style that suits a method least."""

LIGHT = 0.5
"""Share of the painted contrast of highlights and cast shadow that must be left."""

LEAST_CONTRAST = 5.0
"""A style whose highlight or shadow is no lighter or darker than so much (L*) paints none."""

DEFINITION = f"""\
1. **real time**: more than {REAL_TIME:g} frames a second (printed), here of 500 x 500 pixels; dense
   methods and rivals at the rate of a pixel of our pictures, on the processor of one core.
2. **quality**: energy over StyLit's, the mean over styles, at most {QUALITY} (our threshold; the
   thesis measures itself "at a related method").
3. **light**: how much of the painted contrast between highlight and lit object, and between cast
   shadow and ground, is in the picture: the mean over styles of the lesser, at least {LIGHT}
   (ours).
   Contrast is a difference of mean L*; a style with less than {LEAST_CONTRAST:g} there has none.
4. **adaptability**: energy over StyLit's in the worst style, at most {ADAPTS} (ours)."""


def requirements(plan):
    """Every method beside the thresholds.

    Returns
    -------
    pandas.DataFrame
        ``fps``, ``quality``, ``light`` and ``adaptability``, and for each whether it is met.
    """
    rows = []
    for method in METHODS:
        ratios = [
            numbers_of(plan.picture(style, method))["image_energy"]
            / numbers_of(plan.picture(style, "StyLit"))["image_energy"]
            for style in STYLES
        ]
        kept = [light_kept(plan.picture(style, method)) for style in STYLES]
        fps, quality, worst = frame_rate(plan, method), np.mean(ratios), max(ratios)
        light = float(np.mean([each for each in kept if each is not None]))
        rows.append(
            {
                "method": method,
                "fps": fps,
                "1 real time": fps > REAL_TIME,
                "quality": quality,
                "2 quality": quality <= QUALITY,
                "light": light,
                "3 light": light >= LIGHT,
                "adaptability": worst,
                "4 adaptability": worst <= ADAPTS,
            }
        )
    return pd.DataFrame(rows)


def frame_rate(plan, method):
    """Frames of the smaller size a second, on the processor of one core."""
    side = plan.sides[0]
    if method not in DENSE and method not in RIVALS:
        return 1000 / frame_times(plan.times(side)).loc[method, "cpu"]
    jobs = [plan.picture(style, method) for style in STYLES]
    seconds = [stored(job).processor_seconds for job in jobs]
    pixels = [job.scene.pixels for job in jobs]
    return 1 / (min(np.divide(seconds, pixels)) * side**2)


def light_kept(job):
    """The lesser share of contrast that a picture keeps of its style's highlight and shadow.

    Parameters
    ----------
    job : Job

    Returns
    -------
    float or None
        At most 1; None if the style paints neither.
    """
    source, target = views_of(job.scene)
    style, picture = (
        rgb2lab(image)[..., 0] for image in (job.scene.style, stored(job).image)
    )  # fmt: skip
    kept = []
    for bright, dark in (
        (lambda view: view.highlight, lambda view: view.lit),
        (lambda view: view.labels == BACKGROUND, lambda view: view.labels == CAST_SHADOW),
    ):
        painted, found = (
            image[bright(view)].mean() - image[dark(view)].mean()
            for image, view in ((style, source), (picture, target))
        )
        if painted >= LEAST_CONTRAST:
            kept.append(float(np.clip(found / painted, 0, 1)))
    return min(kept, default=None)
