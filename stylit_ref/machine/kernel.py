"""Loops over whole arrays, compiled when they are first called."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from functools import wraps
from typing import ParamSpec

from numba import njit
from numba.core.dispatcher import Dispatcher

from stylit_ref.machine.compilation import Specialization, bring_others
from stylit_ref.machine.forks import survive_forks
from stylit_ref.machine.interruption import heed_waiting
from stylit_ref.machine.kernel_cache import KernelCache
from stylit_ref.machine.names import tell_functions_apart
from stylit_ref.machine.parallel_loops import ParallelKernelCompiler
from stylit_ref.machine.parts import KernelCompiler

survive_forks()  # here, since every kernel comes from here
tell_functions_apart()

Arguments = ParamSpec("Arguments")


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
            pipeline_class=ParallelKernelCompiler if parallel else KernelCompiler,
            error_model="numpy",
            nogil=nogil,
            no_cfunc_wrapper=True,
        )(function)
        with suppress(RuntimeError):  # no folder can be written, so every process compiles
            dispatcher._cache = KernelCache(function, constants)
        is_compiled = isinstance(dispatcher, Dispatcher)  # not NUMBA_DISABLE_JIT's plain function
        if is_compiled:
            bring_others(dispatcher)

        @wraps(function)
        def run(*arguments, **named):
            rehearsed = _REHEARSED.get()
            if rehearsed is None:
                dispatcher(*arguments, **named)
                heed_waiting()
            elif is_compiled:
                rehearsed[Specialization.of_call(dispatcher, arguments, named)] = None

        run.dispatcher = dispatcher
        return run

    return decorate
