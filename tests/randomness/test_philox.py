import numpy as np
import pytest

from stylit_ref.randomness.philox import philox4x32, uniform_below

# kat_vectors of the Random123 distribution, philox4x32 with 10 rounds.
KNOWN_ANSWERS = [
    ("00000000 00000000 00000000 00000000", "00000000 00000000",
     "6627e8d5 e169c58d bc57ac4c 9b00dbd8"),
    ("ffffffff ffffffff ffffffff ffffffff", "ffffffff ffffffff",
     "408f276d 41c83b0e a20bc7c6 6d5451fd"),
    ("243f6a88 85a308d3 13198a2e 03707344", "a4093822 299f31d0",
     "d16cfe09 94fdcceb 5001e420 24126ea1"),
]  # fmt: skip


def words(text):
    return [np.uint32(int(word, 16)) for word in text.split()]


@pytest.mark.parametrize(("counter", "key", "answer"), KNOWN_ANSWERS)
def test_known_answers(counter, key, answer):
    assert list(philox4x32(*words(counter), *words(key))) == words(answer)


@pytest.mark.parametrize("n", [1, 2, 7, 1200])
def test_uniform_below_covers_its_range(n):
    assert uniform_below(np.uint32(0), n) == 0
    assert uniform_below(np.uint32(0xFFFFFFFF), n) == n - 1
