"""Find out whether kernels can run here, and what is missing."""

import shutil
import subprocess
from importlib.metadata import PackageNotFoundError, version

from numba import cuda

from gpu_cuda.host.device import SIMULATED

DRIVER = 13, 0
"""CUDA version of the libraries of numba-cuda: an older driver cannot load their code."""

CAPABILITY = 7, 5
"""The lowest compute capability that CUDA 13 supports."""

INSTALL = "pip install 'stylit-ref[gpu]', with an NVIDIA driver of version 580 or newer"


def missing():
    """One clause that says why kernels cannot run, or None."""
    if SIMULATED:
        return None
    if _version("numba-cuda") is None:
        return f"numba-cuda is not installed ({INSTALL})"
    try:
        driver = cuda.cudadrv.driver.driver.get_version()
        if driver < DRIVER:
            return (
                f"the NVIDIA driver supports CUDA {_dotted(driver)}, "
                f"but {_dotted(DRIVER)} is needed ({INSTALL})"
            )
        cuda.current_context()
        device = cuda.get_current_device()
        cuda.cudadrv.nvvm.NVVM()
        cuda.cudadrv.libs.get_cudalib("cudadevrt", static=True)
    except Exception as error:  # a driver, or a library it needs, can raise anything
        said = " ".join(str(error).split()).rstrip(" :.")
        return f"there is no GPU that CUDA can use: {said[:200]} ({INSTALL})"
    if device.compute_capability < CAPABILITY:
        return (
            f"{device_name()} has compute capability {_dotted(device.compute_capability)}, "
            f"but {_dotted(CAPABILITY)} is needed"
        )
    return None


def device_name():
    """The GPU's name."""
    if SIMULATED:
        return "Numba's simulator"
    name = cuda.get_current_device().name
    return name.decode() if isinstance(name, bytes) else name


def report():
    """Lines of text: the installed packages, and what to install for a GPU."""
    packages = "numba", "numba-cuda", "cuda-bindings"
    lines = [f"{name:13} {_version(name) or 'not installed'}" for name in packages]
    reason = missing()
    if reason:
        return [*lines, f"GPU           none: {reason}"]
    if SIMULATED:
        return [*lines, f"GPU           {device_name()} (NUMBA_ENABLE_CUDASIM)"]
    _, total = cuda.current_context().get_memory_info()
    capability = _dotted(cuda.get_current_device().compute_capability)
    of_cuda = _dotted(cuda.cudadrv.driver.driver.get_version())
    return [
        *lines,
        f"driver        {_driver_version()}, CUDA {of_cuda}",
        f"GPU           {device_name()}, compute capability {capability}, {total >> 20} MiB",
    ]


def _driver_version():
    """Version of the driver, from nvidia-smi."""
    program = shutil.which("nvidia-smi")
    if program is None:
        return "unknown version"
    command = [program, "--query-gpu=driver_version", "--format=csv,noheader"]
    said = subprocess.run(command, check=False, capture_output=True, text=True).stdout.split()
    return said[0] if said else "unknown version"


def _dotted(numbers):
    return ".".join(map(str, numbers))


def _version(package):
    try:
        return version(package)
    except PackageNotFoundError:
        return None
