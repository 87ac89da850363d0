"""Random words of sixteen pixels at once, against those of one."""

import numpy as np
import pytest
from numba import njit

from stylit_ref.randomness.neighbouring_words import LANES, neighbouring_words
from stylit_ref.randomness.random_stream import RETRIEVAL_SEARCH, random_stream, random_words

STREAM = random_stream(0xFEDCBA9876543210, RETRIEVAL_SEARCH, 3, 2, 9)


@njit
def write_words(words, stream, position, draw):
    neighbouring_words(words, stream, position, draw)


@pytest.mark.parametrize("position", [0, 7, 2**32 - LANES])
@pytest.mark.parametrize("draw", [0, 3])
def test_they_are_those_of_each_pixel(position, draw):
    words = np.zeros((4, LANES), np.uint32)
    write_words(words, STREAM, np.uint32(position), np.uint32(draw))
    for lane in range(LANES):
        assert tuple(words[:, lane]) == random_words(STREAM, position + lane, draw)
