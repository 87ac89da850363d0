"""Kernels of different processes: they meet in a third one, and none is compiled twice."""

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
        return told(started(file, tmp_path, way, *constants))

    assert run(1) == [[1, 0]]
    assert run(2) == [[2, 0]]
    assert run(1, 2) == [[1, 1], [2, 1]]


def test_a_kernel_is_compiled_by_one_of_two_that_start_together(tmp_path):
    file = tmp_path / "filling.py"
    file.write_text(MODULE, encoding="utf-8")
    both = [started(file, tmp_path, "parallel", 1) for _ in range(2)]
    assert sorted(map(told, both)) == [[[1, 0]], [[1, 1]]]


def started(file, folder, way, *constants):
    """A process that fills with these constants."""
    return subprocess.Popen(
        [sys.executable, file, way, *map(str, constants)],
        env=os.environ | {"NUMBA_CACHE_DIR": str(folder / "kernels")},
        stdout=subprocess.PIPE, text=True,
    )  # fmt: skip


def told(process):
    """What a process filled with, and whether it had the kernel from the disk."""
    said, _ = process.communicate()
    assert process.returncode == 0
    return [list(map(int, line.split())) for line in said.splitlines()]
