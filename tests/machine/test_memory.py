"""Memory that this process has freed goes back to the system."""

import platform
import subprocess
import sys

import pytest

FRAGMENTS = """
from pathlib import Path
from stylit_ref.machine.memory import return_free_memory

def resident():
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096

arrays = [bytearray(b"a" * 50_000) for _ in range(2000)]
full = resident()
kept = arrays[::10]
del arrays
scattered = resident()
return_free_memory()
print(full - scattered, full - resident())
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="other C libraries keep less")
def test_what_lies_scattered_among_other_arrays_goes_back():
    done = subprocess.run(
        [sys.executable, "-c", FRAGMENTS], capture_output=True, text=True, check=True
    )
    by_itself, returned = map(int, done.stdout.split())
    assert by_itself < 10_000_000
    assert returned > 70_000_000
