"""Loops whose turns threads share do what Python does."""

import numpy as np
import pytest
from numba import njit, prange, set_num_threads

from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.thread_count import available_threads


@pytest.fixture(autouse=True, params=["one thread", "all threads"])
def threads(request):
    set_num_threads(1 if request.param == "one thread" else available_threads())
    yield
    set_num_threads(available_threads())


@njit
def twice(value):
    return 2 * value


@kernel()
def number(array, offset):
    for y in prange(array.shape[0]):
        for x in range(array.shape[1]):
            array[y, x] = offset + twice(10 * y + x)


@kernel()
def add_rounds(array, rounds):
    for n in range(rounds):
        step = n + 1
        for y in prange(array.size):
            array[y] += step * y
        y = array.size - 1
        for k in prange(y):
            array[k] += array[y]


@kernel()
def nested(array):
    for y in prange(array.shape[0]):
        for x in prange(array.shape[1]):
            array[y, x] += y - x


def made(run, shape, *values):
    array = np.zeros(shape, np.int64)
    run(array, *values)
    return array


def same(run, shape, *values):
    expected = made(run.dispatcher.py_func, shape, *values)
    np.testing.assert_array_equal(made(run, shape, *values), expected)


@pytest.mark.parametrize("rows", [0, 1, 2, 17])
def test_every_turn_comes_once(rows):
    same(number, (rows, 3), 7)


def test_loops_in_a_loop_follow_each_other():
    same(add_rounds, 23, 3)


def test_a_loop_inside_another():
    same(nested, (5, 4))
