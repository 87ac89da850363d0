"""Kernels that are missing are compiled together, in several processes."""

import inspect
import logging
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import partial
from operator import attrgetter
from pathlib import Path
from typing import Any, NamedTuple

from numba import types
from numba.core.dispatcher import Dispatcher

from stylit_ref.machine.interruption import heed_waiting
from stylit_ref.machine.kernel_cache import KernelCache
from stylit_ref.machine.once import once
from stylit_ref.machine.shared_work import share
from stylit_ref.notes import note


class Specialization(NamedTuple):
    """A kernel for arguments of certain types: what is compiled, kept and loaded as one.

    Attributes
    ----------
    dispatcher : numba.core.dispatcher.Dispatcher
    types : tuple of numba.types.Type
    """

    dispatcher: Dispatcher
    types: tuple[types.Type, ...]

    @classmethod
    def of_call(
        cls, dispatcher: Dispatcher, arguments: tuple[Any, ...], named: dict[str, Any]
    ) -> "Specialization":
        """The kernel that a call calls."""
        values = inspect.signature(dispatcher.py_func).bind(*arguments, **named).args
        return cls(dispatcher, tuple(map(dispatcher.typeof_pyval, values)))

    @property
    def is_compiled(self) -> bool:
        """Whether it can be called without compiling: this process has it, or the disk."""
        return self.types in self.dispatcher.overloads or (
            isinstance(self.dispatcher._cache, KernelCache)
            and self.dispatcher._cache.holds(self.types)
        )

    @property
    def folder(self) -> Path | None:
        """Where it is kept, None where no folder can be written."""
        cache = self.dispatcher._cache
        return Path(cache.cache_path) if isinstance(cache, KernelCache) else None

    @property
    def size(self) -> int:
        """Bytes of its function's code, by which one can guess how long it takes to compile."""
        return len(self.dispatcher.py_func.__code__.co_code)

    def compile(self, *, waiting: bool = True) -> None:
        """Compile it, and keep it on disk.

        Parameters
        ----------
        waiting : bool
            Whether to wait for another process that compiles it; else nothing is done then.

        Raises
        ------
        KeyboardInterrupt
            Afterwards, if it came meanwhile.
        """
        with self.compiled_once(waiting=waiting) as is_ours:
            if is_ours:
                self.dispatcher.compile(self.types)
        heed_waiting()

    @contextmanager
    def compiled_once(self, *, waiting: bool) -> Iterator[bool]:
        """While the block runs, no other process compiles it (:mod:`stylit_ref.machine.once`)."""
        folder = self.folder
        number = None if folder is None else self.dispatcher._cache.number_of(self.types)
        if number is None:
            yield True
        else:
            with once(folder, number, lambda: self.is_compiled, waiting=waiting) as is_ours:
                yield is_ours


def compile_missing(
    kernels: Iterable[Specialization], progress: Callable[[int, int], None] | None = None
) -> int:
    """Compile those kernels that neither this process nor the disk has.

    Parameters
    ----------
    kernels : iterable of Specialization
    progress : callable, optional
        Called with a kernel's number, from 1, and how many there are to compile, before each.

    Returns
    -------
    int
        How many were compiled.
    """
    missing = [each for each in kernels if not each.is_compiled]
    if any(each.folder is None for each in missing):
        note(
            "compiled kernels cannot be kept, since no folder for them can be written; set "
            "NUMBA_CACHE_DIR to one that can",
            level=logging.WARNING,
        )
    elif len(missing) > 1:
        _share(missing, progress)
    for number, each in enumerate(missing, 1):
        if not each.is_compiled:
            if progress:
                progress(number, len(missing))
            each.compile()
    return len(missing)


def _share(kernels, progress):
    """Compile kernels in several processes, those that take longest first; they lie on the disk.

    Those that other runs compile meanwhile are left out.
    """
    ordered = sorted(kernels, key=attrgetter("size"), reverse=True)
    share(
        [partial(each.compile, waiting=False) for each in ordered],
        lambda number: progress and progress(number + 1, len(ordered)),
    )


_WANTED: ContextVar[Callable[[], None] | None] = ContextVar("wanted", default=None)


@contextmanager
def compiling_together(
    kernels: Callable[[], Iterable[Specialization]],
    progress: Callable[[int, int], None] | None = None,
) -> Iterator[None]:
    """While the block runs, the first kernel that is missing has others compiled too.

    Which ones is not asked before, as it takes 50 ms and most runs lack none.

    Parameters
    ----------
    kernels : callable
        Returns all kernels that the block may call.
    progress : callable, optional
        As of :func:`compile_missing`.
    """

    def compile_all():
        _WANTED.set(None)  # only once
        compile_missing(kernels(), progress)

    token = _WANTED.set(compile_all)
    try:
        yield
    finally:
        _WANTED.reset(token)


def bring_others(dispatcher: Dispatcher) -> None:
    """Let a kernel heed :func:`compiling_together` and other processes when it has new types."""
    compile_or_load = dispatcher._compile_for_args

    def compile_for_args(*arguments, **named):
        kernel = Specialization.of_call(dispatcher, arguments, named)
        compile_all = _WANTED.get()
        if compile_all and not kernel.is_compiled:
            compile_all()
        with kernel.compiled_once(waiting=True):
            return compile_or_load(*arguments, **named)

    dispatcher._compile_for_args = compile_for_args
