"""Compile functions that are inlined into every kernel that calls them."""

from collections.abc import Callable
from typing import Any, TypeVar

from numba import njit

Function = TypeVar("Function", bound=Callable[..., Any])

Compiler = Callable[[Callable[..., Any]], Callable[..., Any]]
"""Compiles a function: :func:`numba.njit`, :func:`inlined`, or a decorator for a GPU."""


def inlined(function: Function) -> Function:
    """Compile a function that only kernels call; from Python, call its ``py_func``."""
    return njit(forceinline=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)(function)


def subroutine(function: Function) -> Function:
    """Compile a part of a kernel that tests call too; a division by zero raises nothing there."""
    return njit(error_model="numpy")(function)
