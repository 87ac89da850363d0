"""Backends: the passes on the CPU, and several ways to run them as CUDA kernels."""

from typing import NamedTuple

from stylit_ref import passes
from stylit_ref.errors import InputError
from stylit_ref.machine.replaced import Passes
from stylit_ref.stylization.params import Params
from stylit_ref.stylization.schedules import Iterate


class Backend(NamedTuple):
    """The parts of a run that depend on where it runs.

    Attributes
    ----------
    passes : module
        A module with the functions of :mod:`stylit_ref.passes`.
    iterate : callable, optional
        A PatchMatch iteration that replaces that of the schedule.
    """

    passes: Passes
    iterate: Iterate | None = None


CPU = Backend(passes)


def _cuda():
    """The kernels of the default schedule."""
    import gpu_cuda

    return Backend(gpu_cuda)


def _shared_memory():
    """Target patches in shared memory (thesis 5.1)."""
    from gpu_cuda.variants import shared_memory

    return Backend(shared_memory.passes)


def _live():
    """Ω live by atomics, ρ summed over Ω (thesis 3.2, 3.3); runs are not reproducible."""
    import gpu_cuda
    from gpu_cuda.variants.live import live

    return Backend(gpu_cuda, live)


def _live_sums():
    """The same with W, Ω summed over each patch, in place of Ω."""
    import gpu_cuda
    from gpu_cuda.variants.live import live_sums

    return Backend(gpu_cuda, live_sums)


GPU_BACKENDS = {
    "cuda": _cuda,
    "cuda:shared_memory": _shared_memory,
    "cuda:live": _live,
    "cuda:live_sums": _live_sums,
}
"""The ways to use a GPU, by name; ``METHODS`` says which of them each method can use."""

BACKENDS = ("cpu", "auto", *GPU_BACKENDS)


def find_backend(name: str, params: Params) -> Backend:
    """Find a backend for a method.

    Parameters
    ----------
    name : str
        One of :data:`BACKENDS`. ``auto`` is ``cuda`` if there is a GPU and the method has kernels,
        otherwise ``cpu``.
    params : Params

    Returns
    -------
    Backend

    Raises
    ------
    InputError
        If there is no such backend, no GPU, or no kernels for the method.
    """
    if name not in BACKENDS:
        *others, last = map(repr, BACKENDS)
        raise InputError(
            f"is {name!r}; it must be {', '.join(others)} or {last}", parameter="backend"
        )
    has_kernels = params.schedule in params.traits.gpu_schedules
    offered = params.traits.gpu_backends if has_kernels else ()
    if name == "cpu" or (name == "auto" and ("cuda" not in offered or _missing())):
        return CPU
    if name not in ("auto", *offered):
        raise InputError(
            f"is {name!r}, but method {params.method!r} with schedule {params.schedule!r} has no "
            f"kernels for it; choose {' or '.join(map(repr, ('cpu', *offered)))}",
            parameter="backend",
        )
    missing = _missing()
    if missing:
        raise InputError(
            f"is {name!r}, but {missing}; 'stylit-ref doctor' shows what is installed",
            parameter="backend",
        )
    return GPU_BACKENDS["cuda" if name == "auto" else name]()


def _missing():
    """One clause that says why kernels cannot run, or None."""
    try:
        from gpu_cuda.host import doctor
    except ImportError as error:  # if a part of numba-cuda is not installed
        return f"the kernels cannot be loaded: {error}"
    return doctor.missing()
