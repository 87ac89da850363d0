"""Compile functions that are inlined into every kernel that calls them."""

from numba import njit

inlined = njit(forceinline=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)
"""Decorator of a function that only kernels call."""
