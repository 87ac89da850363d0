"""Kernels that different processes have compiled meet in a third one."""

import os
import subprocess
import sys

STEPS = 100
"""So many that LLVM does not inline the loop, which would hide its name."""

MODULE = f"""
import sys
import numpy as np
from numba import prange
from stylit_ref.machine.kernel import kernel

def make(constant):
    @kernel(constant)
    def fill(array):
        for y in prange(array.shape[0]):
            for x in range(array.shape[1]):
                {"; ".join(f"array[y, array[y, x] % {k}] += x" for k in range(2, STEPS))}
            for x in range(array.shape[1]):
                array[y, x] = constant
    return fill

array = np.zeros((2, {STEPS}), np.int64)
for constant in map(int, sys.argv[1:]):
    fill = make(constant)
    fill(array)
    print(*np.unique(array), sum(fill.dispatcher.stats.cache_hits.values()))
"""


def test_each_runs_its_own_loop(tmp_path):
    """Numba numbers functions from 1 in each process, so both loops have the same name."""
    file = tmp_path / "filling.py"
    file.write_text(MODULE, encoding="utf-8")

    def run(*constants):
        done = subprocess.run(
            [sys.executable, file, *map(str, constants)],
            env=os.environ | {"NUMBA_CACHE_DIR": str(tmp_path / "kernels")},
            capture_output=True, text=True, check=True,
        )  # fmt: skip
        return [list(map(int, line.split())) for line in done.stdout.splitlines()]

    assert run(1) == [[1, 0]]
    assert run(2) == [[2, 0]]
    assert run(1, 2) == [[1, 1], [2, 1]]
