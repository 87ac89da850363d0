"""Kernels and programs call the same functions."""

import re

import numba
import numpy as np
from numba import njit, prange

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel


@njit
def least(a, b):
    return min(a, b)


@inlined
def least_of_three(a, b, c):
    return least(least(a, b), c)


@kernel(parallel=False)
def store_least(values):
    values[0] = least_of_three(values[0], values[1], values[2])


@kernel(parallel=False)
def store_lesser(values):
    values[0] = least(values[1], values[2])


def test_a_function_of_a_function():
    values = np.array([5, 3, 4])
    store_least(values)
    assert values[0] == 3


def test_another_kernel_has_other_types():
    store_least(np.array([5, 3, 4]))
    values = np.array([0.0, 2.5, 1.5])
    store_lesser(values)
    assert values[0] == 1.5


def test_a_program_calls_what_a_kernel_calls():
    store_lesser(np.array([0, 1, 2]))
    assert least(7, 6) == 6


def test_other_code_cannot_see_what_a_kernel_is_made_of(tmp_path, monkeypatch):
    """LLVM's linker would take a function of the kernel for one of the same name."""
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))

    @kernel()
    def clear_rows(values):
        for y in prange(values.shape[0]):
            for x in range(values.shape[1]):
                values[y][x] = 0

    clear_rows(np.ones((2, 2)))
    [code] = clear_rows.dispatcher.inspect_llvm().values()
    made = set(re.findall(r'^define [^@]*@"?([^"(]+)', code, re.MULTILINE))
    [compiled] = clear_rows.dispatcher.overloads.values()
    own = compiled.fndesc
    visible = {name for name in made if not name.startswith("private.")}
    assert visible == {own.llvm_func_name, own.llvm_cpython_wrapper_name}
    assert "private.run" in made
