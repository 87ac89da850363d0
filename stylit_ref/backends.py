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
    if backend == "cpu":
        return passes
    reason = None
    if params.method == "stylit" or params.schedule == "scanline":
        what = "method 'stylit'" if params.method == "stylit" else "schedule 'scanline'"
        reason = f"there are no kernels for {what}"
    reason = reason or import_module("gpu_cuda.doctor").missing()
    if reason is None:
        return import_module("gpu_cuda")
    if backend == "auto":
        return passes
    raise InputError(f"backend is 'cuda' but {reason}; 'stylit-ref doctor' says what there is")


def cuda_report():
    """Lines of text: what of a GPU's software there is."""
    return import_module("gpu_cuda.doctor").report()
