"""Functions that become part of every kernel that calls them."""

from numba import njit

inlined = njit(forceinline=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)
"""Decorator of a function that nothing but kernels call."""
