"""How many threads kernels have."""

from collections.abc import Iterator
from contextlib import contextmanager
from numbers import Integral

import numba

from stylit_ref.errors import InputError, shown
from stylit_ref.machine.forks import available_threads
from stylit_ref.notes import note


def check_threads(threads: int | None) -> None:
    """Refuse what is neither None nor an integer of at least 1.

    Raises
    ------
    InputError
    """
    if threads is not None and (not isinstance(threads, Integral) or threads < 1):
        raise InputError(
            f"is {shown(threads)}; it must be an integer of at least 1", parameter="threads"
        )


@contextmanager
def using_threads(threads: int | None) -> Iterator[None]:
    """Have kernels use so many threads while the block runs; None changes nothing.

    If there are fewer, all are used, and a note says so.

    Raises
    ------
    InputError
        If it is no integer of at least 1.
    """
    check_threads(threads)
    if threads is None:
        yield
        return
    available = available_threads()
    if threads > available:
        note(f"is {threads}, but {available} are used, all that there are", parameter="threads")
    before = numba.get_num_threads()
    numba.set_num_threads(min(threads, available))
    try:
        yield
    finally:
        numba.set_num_threads(min(before, available_threads()))  # fewer in a fork from a callback
