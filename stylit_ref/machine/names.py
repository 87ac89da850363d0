"""Names of compiled functions: no two processes give the same."""

import itertools
import os

from numba.core.bytecode import FunctionIdentity


def tell_functions_apart() -> None:
    """Number functions from a random number on, which forks choose anew.

    Numba begins at 1 in every process, and names the code of a function by its own name and its
    number. Kernels that two processes have kept on the disk can so hold different functions of one
    name. Where a third process loads both, LLVM gives the second kernel the function of the first:
    its results are wrong, or it overwrites memory.
    """
    _begin_elsewhere()
    if hasattr(os, "register_at_fork"):  # Windows has no fork
        os.register_at_fork(after_in_child=_begin_elsewhere)


def _begin_elsewhere():
    # Numbers of as many digits, so that a kernel has the same size whoever compiles it.
    first = 10**16 + int.from_bytes(os.urandom(6))
    FunctionIdentity._unique_ids = itertools.count(first)
