"""The device of a run: times of different devices must not be compared."""

import platform
from functools import cache
from pathlib import Path


@cache
def device(backend):
    """Name of the processor or the GPU that a backend runs on."""
    if backend == "cpu":
        return processor()
    from gpu_cuda.host.doctor import device_name

    return device_name()


def processor():
    """Name of the machine's processor."""
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()
