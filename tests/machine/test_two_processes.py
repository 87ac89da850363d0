"""Kernels that different processes have compiled meet in a third one."""

import os
import subprocess
import sys

import pytest

STEPS = 100
"""So many that LLVM does not inline the function, which would hide its name."""

MODULE = f"""
import sys
import numpy as np
from numba import prange
from stylit_ref.machine.inlined import subroutine
from stylit_ref.machine.kernel import kernel

def make(constant):
    @subroutine
    def fill_row(row):
        for x in range(row.size):
            {"; ".join(f"row[row[x] % {k}] += x" for k in range(2, STEPS))}
        for x in range(row.size):
            row[x] = constant

    @kernel(constant, parallel="parallel" in sys.argv)
    def fill(array):
        for y in prange(array.shape[0]):
            fill_row(array[y])
        fill_row(array[0])

    return fill

array = np.zeros((2, {STEPS}), np.int64)
for constant in map(int, sys.argv[2:]):
    fill = make(constant)
    fill(array)
    print(*np.unique(array), sum(fill.dispatcher.stats.cache_hits.values()))
"""


@pytest.mark.parametrize("way", ["serial", "parallel"])
def test_each_calls_its_own_function(tmp_path, way):
    """Both have the same name, by which LLVM finds what another kernel has loaded already."""
    file = tmp_path / "filling.py"
    file.write_text(MODULE, encoding="utf-8")

    def run(*constants):
        done = subprocess.run(
            [sys.executable, file, way, *map(str, constants)],
            env=os.environ | {"NUMBA_CACHE_DIR": str(tmp_path / "kernels")},
            capture_output=True, text=True, check=True,
        )  # fmt: skip
        return [list(map(int, line.split())) for line in done.stdout.splitlines()]

    assert run(1) == [[1, 0]]
    assert run(2) == [[2, 0]]
    assert run(1, 2) == [[1, 1], [2, 1]]
