"""Choose how a guide is encoded, from all pictures of it."""

from collections.abc import Iterable, Sequence
from math import inf
from typing import NamedTuple

import numpy as np

from stylit_ref.errors import InputError
from stylit_ref.files.guides.encoding import FAR, GuideEncoding, labels_of
from stylit_ref.files.guides.label_colours import MOST_LABELS, distinct_colours
from stylit_ref.files.layers.channels import are_labels
from stylit_ref.files.picture import Picture

MOST_CLIPPED = 0.005
"""The largest share of any picture that may be clipped at either end."""

_SIGNED = {"motion", "normal", "normals", "vector", "vectors", "velocity"}
_LARGEST_WHOLE = 1 << 24
"""Beyond it floats are not one apart."""

_HALF_A_STEP = 0.5 / 255
"""What lies outside by less is rounded, not clipped."""

_LARGEST_FLOAT = float(np.finfo(np.float32).max)


class GuideValues(NamedTuple):
    """What counts of a picture: its labels, if it has such, or the range of its values.

    Attributes
    ----------
    is_float, is_light, is_signed : bool
        Whether they are floating point, scene-linear light, and of a layer that has a sign.
    low, high : float
        The range, but for the share that may be clipped; of integers 0 and 1.
    labels : frozenset of int, or None
    """

    is_float: bool
    is_light: bool
    is_signed: bool
    low: float
    high: float
    labels: frozenset[int] | None


def choose_encoding(pictures: Iterable[Picture]) -> GuideEncoding:
    """Choose how a guide is encoded.

    - Integers, and floats of which at most :data:`MOST_CLIPPED` lie outside [0, 1], stay as they
      are.
    - Other light is exposed so that no picture has more pixels that are clipped.
    - Normals and vectors with negative values go from -1, or less, to the opposite of that: 0
      becomes the middle.
    - Other data goes linearly from the least to the largest value. At most that share is clipped,
      and pixels where nothing is do not count.
    - Whole numbers of a layer that is called index or ID, and Cryptomatte, are labels.

    Parameters
    ----------
    pictures : iterable of Picture
        Of the source and of all targets; none is kept.

    Returns
    -------
    GuideEncoding

    Raises
    ------
    InputError
        If some have labels that others cannot have, or there are too many.
    """
    return encoding_of([values_of(picture) for picture in pictures])


def encoding_of(found: Sequence[GuideValues]) -> GuideEncoding:
    """As :func:`choose_encoding`, of what counts of the pictures."""
    is_light = all(values.is_light for values in found)
    if all(values.labels is not None for values in found):
        return _labels(found)
    kind = "light" if is_light else "data"
    if not all(values.is_float for values in found):  # display values, which have no other range
        return GuideEncoding(kind)
    low, high = min(values.low for values in found), max(values.high for values in found)
    if is_light:
        return GuideEncoding(kind, high=max(high, 1.0))
    if not low < high or (low > -_HALF_A_STEP and high < 1 + _HALF_A_STEP):
        return GuideEncoding(kind)
    if low < 0 and all(values.is_signed for values in found):
        largest = max(-low, high)
        largest = largest if largest > 1 + _HALF_A_STEP else 1.0
        return GuideEncoding(kind, -largest, largest)
    return GuideEncoding(kind, low, high)


def plain_encoding(pictures: Sequence[Picture]) -> GuideEncoding:
    """Leave values between 0 and 1 as they are, and clip the others.

    Parameters
    ----------
    pictures : sequence of Picture
        Of the source and of all targets.

    Returns
    -------
    GuideEncoding
    """
    return GuideEncoding("light" if all(picture.is_light for picture in pictures) else "data")


def _labels(found: Sequence[GuideValues]):
    labels = sorted(frozenset().union(*(values.labels or () for values in found)))
    if len(labels) > MOST_LABELS:
        raise InputError(
            f"cannot give {len(labels)} labels a colour each; at most {MOST_LABELS} can be told "
            "apart",
            parameter="guide_encoding",
        )
    return GuideEncoding(
        "labels", labels=tuple(zip(labels, distinct_colours(len(labels)), strict=True))
    )


def values_of(picture: Picture) -> GuideValues:
    """Look at a picture for what counts of it."""
    labels = None
    if _has_labels(picture):
        labels = frozenset(np.unique(labels_of(picture)).tolist())
    is_float = picture.pixels.dtype == np.float32
    is_signed = not _SIGNED.isdisjoint(picture.words)
    low, high = _range(picture) if is_float else (0.0, 1.0)
    return GuideValues(is_float, picture.is_light, is_signed, low, high, labels)


def _has_labels(picture):
    if picture.pixels.dtype != np.float32 or picture.is_light:
        return picture.pixels.dtype == np.uint32
    if picture.pixels.shape[2] > 1 or not are_labels(picture.words):
        return False
    values = picture.pixels
    return bool((values == np.floor(values)).all() and (np.abs(values) < _LARGEST_WHOLE).all())


def _range(picture):
    """The least and the largest value but for the share that may be clipped."""
    if picture.is_light:
        return 0.0, min(_ends(_brightness(picture))[1], _LARGEST_FLOAT)
    ends = [_ends(channel[np.abs(channel) < FAR]) for channel in np.moveaxis(picture.colours, 2, 0)]
    return min(low for low, _ in ends), max(high for _, high in ends)


def _brightness(picture):
    """The brightest channel of each visible pixel, divided by alpha."""
    brightest = picture.colours.max(axis=2)
    if picture.alpha_channel is None:
        return brightest.ravel()
    alpha = picture.pixels[:, :, picture.alpha_channel]
    with np.errstate(over="ignore"):
        return brightest[alpha > 0] / np.minimum(alpha[alpha > 0], 1)


def _ends(values):
    if not values.size:
        return inf, -inf
    beyond = int(MOST_CLIPPED * values.size)
    ends = beyond, values.size - 1 - beyond
    low, high = np.partition(values, ends)[list(ends)]
    return float(low), float(high)
