import numpy as np

from stylit_ref.formulae.candidates import propagation_candidate, random_candidate
from stylit_ref.randomness.commit_classes import CLASS_STRIDE, commit_order
from stylit_ref.randomness.random_stream import COMMIT_ORDER, random_stream


def test_propagation_continues_the_neighbours_area():
    assert propagation_candidate(8, 9, 0, 4, 2, 20, 20) == (8, 5)
    assert propagation_candidate(8, 9, -4, 0, 2, 20, 20) == (12, 9)


def test_propagation_is_clamped_to_whole_patches():
    assert propagation_candidate(3, 3, 4, 0, 2, 20, 20) == (2, 3)
    assert propagation_candidate(17, 17, 0, -4, 2, 20, 20) == (17, 17)


def test_random_candidates_fill_the_window_and_stay_in_the_source():
    rng = np.random.default_rng(0)
    found = {
        random_candidate(*rng.integers(0, 2**32, 2, dtype=np.uint32), 3, 10, 2, 2, 12, 13)
        for _ in range(2000)
    }
    assert found == {(y, x) for y in (2, 3, 4, 5) for x in (8, 9, 10)}


def test_commit_order_is_a_permutation_that_changes():
    orders = set()
    for k in range(20):
        order = np.zeros((CLASS_STRIDE**2, 2), np.int32)
        commit_order(random_stream(0, COMMIT_ORDER, 1, 1, k), order)
        orders.add(tuple(map(tuple, order.tolist())))
    assert len(orders) == 20
    everything = {(y, x) for y in range(CLASS_STRIDE) for x in range(CLASS_STRIDE)}
    assert all(set(order) == everything for order in orders)
