"""How much pictures differ along vectors, whatever these mean."""

from collections.abc import Mapping
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.motion_file import Vectors
from stylit_ref.views.motion.conventions import BEFORE, NEXT, FrameMotion, Lead

MOST_PIXELS = 100_000
"""Of each frame: more don't change the outcome."""

SHORTEST = 0.5
"""Vectors shorter than this, in pixels, tell nothing: all conventions lead to the same place."""

NOISE = 2
"""Standard deviation in pixels of what smooths a renderer's noise."""


class Sample(NamedTuple):
    """The vectors of a frame, and the pictures between which they may lead.

    Attributes
    ----------
    name : str
        Of the file.
    vectors : Vectors
        As stored.
    pictures : mapping of int to tuple of 2 (H, W) float32
        By the step in time, 1 or -1: the brightness of the frame that the vectors would belong to,
        and of the one that they would lead into. A step without pictures cannot be tried.
    """

    name: str
    vectors: Vectors
    pictures: Mapping[int, tuple[NDArray[np.float32], NDArray[np.float32]]]

    def check_sizes(self) -> None:
        """Refuse pictures of another size than the vectors.

        Raises
        ------
        InputError
        """
        height, width = next(known.shape for known in self.vectors.known if known is not None)
        for picture in (each for pair in self.pictures.values() for each in pair):
            if picture.shape != (height, width):
                raise InputError(
                    f"{self.name}: has vectors of {width}x{height} pixels, and a picture is "
                    f"{picture.shape[1]}x{picture.shape[0]}; both must have the same size"
                )


class Difference(NamedTuple):
    """How much pictures differ at some pixels.

    Attributes
    ----------
    total : float
        Sum of absolute differences of brightness.
    pixels : int
    """

    total: float = 0
    pixels: int = 0

    @property
    def mean(self) -> float:
        """The warping error; infinite without pixels."""
        return self.total / self.pixels if self.pixels else np.inf

    def with_more(self, other: "Difference") -> "Difference":
        """Of the pixels of both."""
        return Difference(self.total + other.total, self.pixels + other.pixels)


class Ways(NamedTuple):
    """The differences along a pair of channels.

    Attributes
    ----------
    along : dict
        By where the pair may lead, and whether its first channel may be the vertical one.
    still : Difference
        Without motion, at the same pixels.
    """

    along: dict[tuple[Lead, bool], Difference]
    still: Difference


def ways_of(sample: Sample, number: int) -> Ways:
    """Try all that a pair of channels may mean.

    Parameters
    ----------
    sample : Sample
    number : int
        Of the pair.

    Returns
    -------
    Ways
        Of pixels whose vectors are known, long enough to tell, and lead to a place within the
        picture whatever they mean.
    """
    pair, known = sample.vectors.pairs[number], sample.vectors.known[number]
    if pair is None or known is None:
        return Ways({}, Difference())
    length = np.abs(pair).max(axis=2)
    height, width = length.shape
    y, x = np.mgrid[:height, :width]
    is_inside = np.minimum.reduce([y, x, height - 1 - y, width - 1 - x]) >= length
    usable = known & is_inside & (length > SHORTEST)
    if sample.vectors.visible is not None:
        usable &= sample.vectors.visible
    pixels = _spread(usable)
    along, still = {}, Difference()
    for step, pictures in sample.pictures.items():
        still = still.with_more(_difference(pictures, pixels, np.zeros((len(pixels[0]), 2))))
        for right, down, swapped in product((1, -1), (1, -1), (False, True)):
            axes = pair[pixels][:, ::-1] if swapped else pair[pixels]
            vectors = axes * np.float32((right, down))
            along[Lead(step, right, down), swapped] = _difference(pictures, pixels, vectors)
    return Ways(along, still)


def change_of(sample: Sample) -> Difference:
    """How much the pictures differ without motion, at all pixels, once noise is smoothed away."""
    from scipy.ndimage import gaussian_filter  # imported late: SciPy takes long to load

    change = Difference()
    for pictures in sample.pictures.values():
        smooth = [gaussian_filter(picture, NOISE) for picture in pictures]
        pixels = _spread(np.ones(pictures[0].shape, np.bool_))
        change = change.with_more(_difference(smooth, pixels, np.zeros((len(pixels[0]), 2))))
    return change


class Halves(NamedTuple):
    """The motion of a frame in both directions, taken apart.

    A point that goes on as it came has opposite motion into the frame before and into the next one.

    Attributes
    ----------
    common, opposite : float
        Root mean square length, in pixels, of what both have in common, and of what is opposite.
    along_opposite, still : Difference
        How much pictures differ along the second, and without motion.
    """

    common: float
    opposite: float
    along_opposite: Difference
    still: Difference


def halves_of(sample: Sample, motion: FrameMotion) -> Halves | None:
    """Take the motion of a frame apart; None if one direction is not known."""
    if motion.forward is None or motion.backward is None:
        return None
    common = (motion.forward.field + motion.backward.field) / 2
    opposite = (motion.forward.field - motion.backward.field) / 2
    pixels = _spread(motion.forward.visible & motion.backward.visible)
    along, still = Difference(), Difference()
    for step, pictures in sample.pictures.items():
        vectors = opposite[pixels] * (1 if step == NEXT else BEFORE)
        along = along.with_more(_difference(pictures, pixels, vectors))
        still = still.with_more(_difference(pictures, pixels, 0 * vectors))
    return Halves(_length(common), _length(opposite), along, still)


def _length(field):
    return float(np.sqrt(np.square(field, dtype=np.float64).sum(axis=2).mean()))


def _spread(chosen):
    """Rows and columns of chosen pixels, evenly spread where there are too many."""
    rows, columns = np.nonzero(chosen)
    stride = max(1, -(-len(rows) // MOST_PIXELS))
    return rows[::stride], columns[::stride]


def _difference(pictures, pixels, vectors):
    from scipy.ndimage import map_coordinates  # imported late: SciPy takes long to load

    here, there = pictures
    places = [pixels[0] + vectors[:, 1], pixels[1] + vectors[:, 0]]
    found = map_coordinates(there, places, np.float64, order=1, mode="nearest")
    return Difference(float(np.abs(found - here[pixels]).sum()), len(pixels[0]))
