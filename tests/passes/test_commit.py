import sys

import brute_force
import numba
import numpy as np
import pytest
from small_level import make_level

from stylit_ref import passes
from stylit_ref.randomness.commit_classes import CLASS_STRIDE, commit_order
from stylit_ref.randomness.random_stream import COMMIT_ORDER, random_stream


def propose(level):
    level.passes.propagation(
        level.textures, level.omega_sums, level.occurrence_weight, level.patch_width,
        level.nnf, level.delta, level.proposed_nnf, level.proposed_delta, 1,
    )  # fmt: skip


STREAM = random_stream(3, COMMIT_ORDER)


def commit(level):
    passes.commit(
        level.nnf, level.delta, level.proposed_nnf, level.proposed_delta,
        level.omega_sums, level.occurrence_weight, level.patch_width, STREAM, level.moves,
    )  # fmt: skip
    return level.take_moves()


@pytest.mark.parametrize("case", [{}, {"uniformity": 100000}, {"patch_width": 3}], ids=str)
def test_commit_takes_what_lowers_phi_class_by_class(case):
    """Against an oracle that recounts Ω before each class."""
    level = make_level(target_size=(15, 18), **case)
    propose(level)
    proposed = level.proposed_nnf.copy()
    classes = np.zeros((CLASS_STRIDE**2, 2), np.int32)
    commit_order(STREAM, classes)
    expected = level.nnf.copy()
    moved = 0
    for first_y, first_x in classes:
        omega = brute_force.omega(expected, level.omega.shape, level.patch_width)
        members = np.s_[first_y::CLASS_STRIDE, first_x::CLASS_STRIDE]
        before = expected[members].copy()
        for k in np.ndindex(before.shape[:2]):
            y, x = first_y + CLASS_STRIDE * k[0], first_x + CLASS_STRIDE * k[1]
            phis = [
                brute_force.phi(level, omega, y, x, *choice[y, x])
                for choice in (expected, proposed)
            ]
            if phis[1] < phis[0]:
                expected[y, x] = proposed[y, x]
                moved += 1
    before = level.nnf.copy()
    assert commit(level) == moved > 0
    np.testing.assert_array_equal(level.nnf, expected)
    np.testing.assert_array_equal(level.proposed_nnf, before)


@pytest.mark.parametrize("threads", [1, 2, 40])
@pytest.mark.parametrize("target_size", [(15, 18), (3, 30), (30, 2)])
def test_w_and_delta_follow_the_moves(target_size, threads, monkeypatch):
    """In as many bands of W as there are threads, some of them empty."""
    commit_module = sys.modules["stylit_ref.passes.commit"]
    monkeypatch.setattr(commit_module, "get_num_threads", lambda: threads)
    monkeypatch.setattr(commit_module, "set_num_threads", lambda _: None)
    monkeypatch.setattr(commit_module, "FEWEST_PIXELS_FOR_THREADS", 0)
    level = make_level(target_size=target_size)
    propose(level)
    commit(level)
    omega_sums, delta = level.omega_sums.copy(), level.delta.copy()
    level.init_occurrence_map()
    level.update_similarity()
    np.testing.assert_array_equal(omega_sums, level.omega_sums)
    np.testing.assert_array_equal(delta, level.delta)


def test_masked_pixels_stay_unassigned():
    masked = np.zeros((14, 12), bool)
    masked[4:9, 3:8] = True
    level = make_level(masked=masked)
    propose(level)
    commit(level)
    np.testing.assert_array_equal(level.nnf[:, :, 0] < 0, masked)


@pytest.mark.parametrize("fewest", [0, 10**9])
def test_threads_are_the_callers_again_afterwards(fewest, monkeypatch):
    monkeypatch.setattr(
        sys.modules["stylit_ref.passes.commit"], "FEWEST_PIXELS_FOR_THREADS", fewest
    )
    level = make_level(target_size=(15, 18))
    propose(level)
    before = numba.get_num_threads()
    assert commit(level) > 0
    assert numba.get_num_threads() == before
