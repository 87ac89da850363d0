"""The interleaved classes of target pixels that commit one after another."""

from stylit_ref.formulae.philox import uniform_below
from stylit_ref.formulae.random_stream import random_words

CLASS_STRIDE = 4
"""Pixels between members of a class on each axis: 16 classes."""


def commit_order(stream):
    """Shuffle the classes (Fisher-Yates), so that none is always first to choose.

    Parameters
    ----------
    stream : tuple of 4 uint32

    Returns
    -------
    tuple of 16 (int, int)
        First row and column of each class, in the order of commitment.
    """
    classes = [(y, x) for y in range(CLASS_STRIDE) for x in range(CLASS_STRIDE)]
    for last in range(len(classes) - 1, 0, -1):
        pick = uniform_below(random_words(stream, last, 0)[0], last + 1)
        classes[last], classes[pick] = classes[pick], classes[last]
    return tuple(classes)
