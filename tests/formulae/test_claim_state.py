"""What propagation remembers of a claim."""

import pytest

from stylit_ref.formulae.candidates import PROPAGATION_DISTANCES
from stylit_ref.formulae.claim_state import (
    ASKING,
    LOST,
    UNKNOWN,
    distance_bit,
    must_ask,
    next_state,
)

BITS = [distance_bit(distance) for distance in PROPAGATION_DISTANCES]


@pytest.mark.parametrize("bit", BITS)
def test_an_unchanged_claim_is_offered_once_at_every_distance(bit):
    state = next_state(UNKNOWN, bit, False, False)
    assert not must_ask(state, state, bit)
    assert all(must_ask(state, state, other) for other in BITS if other != bit)


@pytest.mark.parametrize("bit", BITS)
def test_a_changed_claim_is_offered_again_also_at_the_distance_that_changed_it(bit):
    quiet = next_state(next_state(0, bit, False, False), 0, False, False)
    changed = next_state(quiet, bit, True, False)
    assert all(must_ask(quiet, changed, other) for other in BITS)
    assert not any(must_ask(changed, quiet, other) for other in BITS)


def test_who_has_lost_a_claim_asks_everyone_once():
    lost = ASKING | LOST
    assert all(must_ask(lost, 0, bit) for bit in BITS)
    for bit in BITS:
        lost = next_state(lost, bit, False, True)
    assert lost == LOST
    assert not any(must_ask(lost, 0, bit) for bit in BITS)


def test_a_random_search_spends_no_offer():
    assert next_state(UNKNOWN | LOST, 0, False, True) == UNKNOWN | LOST
    assert next_state(UNKNOWN | LOST, 0, False, False) == UNKNOWN
