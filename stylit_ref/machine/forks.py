"""Kernels in a forked process: they compute with one thread.

``fork`` copies one thread of a process. GNU OpenMP does not notice that the others are gone: a
kernel in the child would wait for them for ever, so Numba ends such a child with SIGTERM, and a
pool then waits for the child for ever. With one thread there is nobody to wait for, and Numba's
check compares process ids, which the child may register anew. A result does not depend on the
number of threads. The other threading layers of Numba start their threads again by themselves.
"""

import os
from ctypes import CFUNCTYPE, c_int

import numba

_is_alone = False
"""Whether this process lost its threads to a fork."""


def survive_forks() -> None:
    """Have kernels work in processes that are forked after a kernel ran. Costs nothing before."""
    if hasattr(os, "register_at_fork"):  # Windows has no fork
        os.register_at_fork(after_in_child=_continue_alone)


def available_threads() -> int:
    """How many threads a kernel can have: 1 in a process that was forked after a kernel ran."""
    return 1 if _is_alone else numba.config.NUMBA_NUM_THREADS


def _continue_alone():
    global _is_alone
    try:
        layer = numba.threading_layer()
    except ValueError:  # no kernel ran before the fork
        return
    if layer != "omp":
        return
    from numba.np.ufunc import omppool  # it is loaded: not every platform has it

    if omppool.openmp_vendor == "GNU":
        set_default = CFUNCTYPE(None, c_int)(omppool.launch_threads)  # and registers this process
        set_own = CFUNCTYPE(None, c_int)(omppool.set_num_threads)
        set_default(1)
        set_own(1)
        _is_alone = True
