"""What of a GPU's software there is, and what is missing."""

from importlib.metadata import PackageNotFoundError, version

from numba import cuda

from gpu_cuda.device import SIMULATED

INSTALL = "pip install -e '.[gpu]' in the checkout, with an NVIDIA driver of version 580 or newer"


def missing():
    """One clause that says why kernels cannot run, or None."""
    if SIMULATED:
        return None
    if _version("numba-cuda") is None:
        return f"numba-cuda is not installed ({INSTALL})"
    try:
        cuda.current_context()
    except Exception as error:  # what a driver, or a library it needs, may raise is anything
        said = " ".join(str(error).split()).rstrip(" :.")
        return f"there is no GPU that CUDA can use: {said[:200]} ({INSTALL})"
    return None


def report():
    """Lines of text: what is installed, and what to install for a GPU."""
    lines = [f"{name:12} {_version(name) or 'not installed'}" for name in ("numba", "numba-cuda")]
    reason = missing()
    if reason:
        return [*lines, f"GPU          none: {reason}"]
    if SIMULATED:
        return [*lines, "GPU          Numba's simulator (NUMBA_ENABLE_CUDASIM)"]
    device = cuda.get_current_device()
    name = device.name.decode() if isinstance(device.name, bytes) else device.name
    _, total = cuda.current_context().get_memory_info()
    driver = ".".join(map(str, cuda.cudadrv.driver.driver.get_version()))
    capability = ".".join(map(str, device.compute_capability))
    return [
        *lines,
        f"driver       CUDA {driver}",
        f"GPU          {name}, compute capability {capability}, {total >> 20} MiB",
    ]


def _version(package):
    try:
        return version(package)
    except PackageNotFoundError:
        return None
