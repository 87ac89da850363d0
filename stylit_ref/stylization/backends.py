"""Where the passes run: on the CPU, or as CUDA kernels.

The library does not know the kernels: it finds them by name where someone asks for them.
"""

from importlib import import_module

from stylit_ref import passes
from stylit_ref.errors import InputError

BACKENDS = ("cpu", "cuda", "auto")


def passes_of(backend, params):
    """The module of passes of a backend.

    Parameters
    ----------
    backend : {"cpu", "cuda", "auto"}
        ``auto`` is ``cuda`` where there is a GPU for the method, otherwise ``cpu``.
    params : Params

    Returns
    -------
    module

    Raises
    ------
    InputError
        If there is no such backend, no GPU, or no kernels for the method.
    """
    if backend not in BACKENDS:
        raise InputError(f"backend is {backend!r}; it must be 'cpu', 'cuda' or 'auto'")
    gpu_alone = params.method == "shared_memory" or params.schedule.startswith("live")
    cpu_alone = params.method == "stylit" or params.schedule == "scanline"
    what = f"method {params.method!r} in schedule {params.schedule!r}"
    if backend == "cpu" and gpu_alone:
        raise InputError(f"{what} is a GPU's; backend must be 'cuda'")
    if backend == "cpu" or (backend == "auto" and cpu_alone):
        return passes
    if cpu_alone:
        raise InputError(f"there are no kernels for {what}; backend must be 'cpu'")
    missing = _missing()
    if missing and backend == "auto" and not gpu_alone:
        return passes
    if missing:
        raise InputError(
            f"backend is {backend!r} but {missing}; 'stylit-ref doctor' says what there is"
        )
    shared = params.method == "shared_memory"
    return import_module("gpu_cuda.variants.shared_memory" if shared else "gpu_cuda")


def _missing():
    """One clause that says why kernels cannot run, or None."""
    try:
        return import_module("gpu_cuda.host.doctor").missing()
    except ImportError as error:  # of numba-cuda, where a part of it is not installed
        return f"the kernels cannot be loaded: {error}"


def cuda_report():
    """Lines of text: what of a GPU's software there is."""
    try:
        return import_module("gpu_cuda.host.doctor").report()
    except ImportError as error:
        return [f"GPU           none: the kernels cannot be loaded: {error}"]
