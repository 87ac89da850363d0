"""Loops over whole arrays, compiled when they are first called."""

import inspect
import logging
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from functools import wraps
from operator import attrgetter
from pathlib import Path
from typing import NamedTuple, ParamSpec

from numba import njit, types
from numba.core.dispatcher import Dispatcher

from stylit_ref.machine.forks import survive_forks
from stylit_ref.machine.interruption import heed_waiting
from stylit_ref.machine.kernel_cache import KernelCache
from stylit_ref.machine.parallel_loops import KernelCompiler
from stylit_ref.machine.parts import PartCompiler
from stylit_ref.machine.shared_work import share
from stylit_ref.notes import note

survive_forks()  # here, since every kernel comes from here

Arguments = ParamSpec("Arguments")


class Specialization(NamedTuple):
    """A kernel for arguments of certain types: what is compiled, kept and loaded as one.

    Attributes
    ----------
    dispatcher : numba.core.dispatcher.Dispatcher
    types : tuple of numba.types.Type
    """

    dispatcher: Dispatcher
    types: tuple[types.Type, ...]

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

    def compile(self) -> None:
        """Compile it, and keep it on disk.

        Raises
        ------
        KeyboardInterrupt
            Afterwards, if it came meanwhile.
        """
        self.dispatcher.compile(self.types)
        heed_waiting()


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
    """Compile kernels in several processes, those that take longest first; they lie on the disk."""
    ordered = sorted(kernels, key=attrgetter("size"), reverse=True)
    share(
        [each.compile for each in ordered],
        lambda number: progress and progress(number + 1, len(ordered)),
    )


_REHEARSED: ContextVar[dict[Specialization, None] | None] = ContextVar("rehearsed", default=None)


@contextmanager
def rehearsal() -> Iterator[dict[Specialization, None]]:
    """While the block runs, kernels do nothing but note the types of their arguments.

    Yields
    ------
    dict
        Its keys are the kernels that the block has called, in their order, each once.
    """
    rehearsed = {}
    token = _REHEARSED.set(rehearsed)
    try:
        yield rehearsed
    finally:
        _REHEARSED.reset(token)


def kernel(
    *constants: int, parallel: bool = True, nogil: bool = False
) -> Callable[[Callable[Arguments, None]], Callable[Arguments, None]]:
    """Compile a loop over a whole array, once for each machine and source.

    Parameters
    ----------
    *constants : int
        What the factory that defines the kernel was called with: the arguments'
        types do not tell these kernels apart.
    parallel : bool
        Whether ``prange`` loops run in parallel.
    nogil : bool
        Whether other threads of Python run meanwhile; two calls must not meet then.

    Returns
    -------
    callable
        Decorator of a function that Numba can compile. It returns nothing: a kernel writes into
        its arguments.
    """

    def decorate(function):
        dispatcher = njit(
            pipeline_class=KernelCompiler if parallel else PartCompiler,
            error_model="numpy",
            nogil=nogil,
            no_cfunc_wrapper=True,
        )(function)
        with suppress(RuntimeError):  # no folder can be written, so every process compiles
            dispatcher._cache = KernelCache(function, constants)

        @wraps(function)
        def run(*arguments, **named):
            rehearsed = _REHEARSED.get()
            if rehearsed is None:
                dispatcher(*arguments, **named)
                heed_waiting()
            elif isinstance(dispatcher, Dispatcher):  # and not NUMBA_DISABLE_JIT's plain function
                values = inspect.signature(function).bind(*arguments, **named).args
                types_of = tuple(map(dispatcher.typeof_pyval, values))
                rehearsed[Specialization(dispatcher, types_of)] = None

        run.dispatcher = dispatcher
        return run

    return decorate
