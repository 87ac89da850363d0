"""The NNF of a level from that of the level above, and at random, entry by entry."""

import numpy as np
import pytest

from stylit_ref.randomness.random_stream import REALTIME_NNF, random_stream, random_words
from stylit_ref.realtime.passes import random_nnf, upsample_nnf


def ends(side, margin):
    """The first centre of a patch along a side, and the last."""
    return min(margin, (side - 1) // 2), max(side - 1 - margin, (side - 1) // 2)


SOURCES = [(1, 1), (3, 4), (1, 9), (30, 23)]


@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.parametrize("margin", [1, 2, 6])
@pytest.mark.parametrize("step", [2, 3, 7])
@pytest.mark.parametrize(("coarse", "fine"), [((1, 1), (1, 1)), ((2, 3), (4, 6)), ((3, 2), (5, 5))])
def test_matches_double_and_stay_in_the_source(source, margin, step, coarse, fine):
    random = np.random.default_rng(step)
    places = np.stack([random.integers(0, side // 2 + 1, coarse) for side in source], -1)
    out = np.zeros(fine, np.int32)
    packed = (places[..., 0] << 16 | places[..., 1]).astype(np.int32)
    upsample_nnf(packed, out, *source, margin, step)
    for entry in np.ndindex(fine):
        parent = tuple(min(k // 2, count - 1) for k, count in zip(entry, coarse, strict=True))
        for k, found in enumerate((out[entry] >> 16, out[entry] & 0xFFFF)):
            first, last = ends(source[k], margin)
            # As far from twice the parent's place in the source as in the target.
            place = 2 * places[parent][k] + (entry[k] * step - 2 * parent[k] * step)
            assert found == np.clip(place, first, last)


@pytest.mark.parametrize("source", SOURCES)
def test_a_random_match_depends_on_its_entry_alone(source):
    stream = random_stream(4, REALTIME_NNF, 5)
    nnf = np.zeros((4, 5), np.int32)
    random_nnf(nnf, *source, 2, stream)
    for a, b in np.ndindex(nnf.shape):
        word = int(random_words(stream, a * 5 + b, 0)[0])
        found = int(nnf[a, b]) >> 16, int(nnf[a, b]) & 0xFFFF
        for k, bits in enumerate((word >> 16, word & 0xFFFF)):
            first, last = ends(source[k], 2)
            assert found[k] == first + (bits * (last - first + 1) >> 16)
