"""In the simulator the threads of a block follow each other in a shuffled order."""

import os
import signal
from threading import active_count, current_thread

import numpy as np
import pytest
from numba import cuda

from gpu_cuda.host.device import SIMULATED, launch

if SIMULATED:
    from numba.cuda.simulator.kernel import BlockThread

pytestmark = pytest.mark.skipif(not SIMULATED, reason="a GPU has threads of its own")

SIZE = 7, 9
"""Rows and columns, of which the last are in blocks that reach beyond."""


@cuda.jit
def arrive(arrivals, count):
    x, y = cuda.grid(2)
    if y < SIZE[0] and x < SIZE[1]:
        arrivals[cuda.atomic.add(count, 0, 1)] = y * SIZE[1] + x


@cuda.jit
def turn_block(out, counts):
    shared = cuda.shared.array((8, 8), np.int32)
    x, y = cuda.threadIdx.x, cuda.threadIdx.y
    if y == 7:
        return
    shared[y, x] = 8 * y + x
    cuda.syncthreads()
    counts[y, x] = cuda.syncthreads_count(x < 3)
    out[y, x] = shared[6 - y, 7 - x]


@cuda.jit
def carry(out):
    x, y = cuda.grid(2)
    out[y, x] = out[y, x - 1] + 1 if x else 1


@cuda.jit
def ask(kinds):
    kinds.append(type(current_thread()))


@cuda.jit
def fail(out):
    x, y = cuda.grid(2)
    if x == 3 and y == 2:
        raise ValueError("too far")
    cuda.syncthreads()
    out[y, x] = 1


def press_ctrl_c():
    os.kill(os.getpid(), signal.SIGINT)


@cuda.jit
def interrupt(out):
    x, y = cuda.grid(2)
    cuda.syncthreads()
    if not out.any():
        press_ctrl_c()
    for _ in range(100_000):
        out[y, x] += 1


def arrivals():
    order, count = np.full(SIZE[0] * SIZE[1], -1), np.zeros(1, np.int64)
    launch(arrive, SIZE, order, count)
    return order.tolist()


def test_each_thread_runs_once_in_a_shuffled_order_that_stays():
    order = arrivals()
    assert sorted(order) == list(range(SIZE[0] * SIZE[1]))
    first = [(n % SIZE[1], n // SIZE[1]) for n in order if n % SIZE[1] < 8]
    assert sorted(first) != first
    assert sorted(first, key=lambda place: place[::-1]) != first
    assert arrivals() == order


def test_threads_wait_for_each_other_at_a_barrier():
    out, counts = np.zeros((2, 7, 8), np.int32)
    launch(turn_block, (8, 8), out, counts)
    np.testing.assert_array_equal(out, np.arange(56).reshape(7, 8)[::-1, ::-1])
    assert (counts == 3 * 7).all()


def test_a_result_that_depends_on_the_order_is_found_out():
    out = np.zeros((8, 8), np.int32)
    launch(carry, (8, 8), out)
    assert (out != np.arange(1, 9)).any()


def test_threads_that_race_are_those_of_the_simulator():
    def kinds(**how):
        found = []
        launch(ask, (8, 8), found, **how)
        return set(found)

    assert kinds(races=True) == {BlockThread}
    assert BlockThread not in kinds()
    with pytest.raises(ValueError, match="too far"):
        launch(fail, (8, 8), np.zeros((8, 8)))
    assert kinds(races=True) == {BlockThread}


def test_an_interruption_leaves_no_thread_behind():
    before = active_count()
    out = np.zeros((8, 8))
    with pytest.raises(KeyboardInterrupt):
        launch(interrupt, (8, 8), out)
    assert active_count() == before
    assert not out.all()


@pytest.mark.parametrize("races", [False, True])
def test_a_thread_that_fails_ends_the_kernel(races):
    out, before = np.zeros((8, 8), np.int32), active_count()
    with pytest.raises(ValueError, match="too far"):
        launch(fail, (8, 8), out, races=races)
    assert not out.any()
    assert races or active_count() == before
