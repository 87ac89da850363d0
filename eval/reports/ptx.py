"""Compile every kernel without a GPU: registers, shared memory and spills, as ptxas counts them.

This needs the packages of the extra "ptx"; 'make ptx' installs them.
"""

import re
import subprocess
import sys
import tempfile
from importlib.metadata import version

import pandas as pd
from tqdm import tqdm

from eval.pages.options import add_output, folder_of
from eval.pages.page import new_report
from eval.provenance import provenance
from gpu_cuda.host.ptx import BLOCKS, CAPABILITIES, compile_to_ptx, kernels
from stylit_ref import InputError


def assembled(ptxas, ptx, capability, block):
    """Registers a thread, bytes of shared memory a block, bytes of spills a thread.

    Parameters
    ----------
    ptxas : str
        Path of the assembler.
    ptx : str
    capability : (int, int)
    block : (int, int)
        A thread may take as many registers as allow a block of this size to start.
    """
    with tempfile.NamedTemporaryFile("w", suffix=".ptx", encoding="utf-8") as file:
        file.write(ptx)
        file.flush()
        command = [
            ptxas,
            "-v",
            "-arch=sm_{}{}".format(*capability),
            f"-maxrregcount={min(65536 // (block[0] * block[1]), 255)}",
            *["-c"] * (".extern .func" in ptx),  # a grid-wide barrier is a library's, linked later
            *[file.name, "-o", "/dev/null"],
        ]
        said = subprocess.run(command, check=True, capture_output=True, text=True).stderr
    registers = max(int(number) for number in re.findall(r"Used (\d+) registers", said))
    shared = sum(int(number) for number in re.findall(r"(\d+) bytes smem", said))
    spills = sum(int(number) for number in re.findall(r"(\d+) bytes spill", said))
    return registers, shared, spills


def add_options(parser):
    """Declare what the report may be told."""
    add_output(parser, "ptx")


def main(options):
    """Compile, assemble and write the table; returns 1 if a kernel spills in its default block."""
    try:
        from cuda.pathfinder import find_nvidia_binary_utility
    except ImportError:
        raise InputError("the assembler ptxas is not installed; 'make ptx' installs it") from None
    ptxas = find_nvidia_binary_utility("ptxas")
    rows, spilled = [], []
    tasks = [
        (name, make, arguments, block)
        for block in BLOCKS
        for name, make, arguments in kernels(block)
    ]
    for name, kernel, arguments, block in tqdm(tasks, unit="kernel", disable=None):
        row = {"kernel": name, "block": "{}x{}".format(*block)}
        for capability in CAPABILITIES:
            ptx = compile_to_ptx(kernel, arguments, capability)
            registers, shared, spills = assembled(ptxas, ptx, capability, block)
            target = "sm_{}{}".format(*capability)
            row[f"registers, {target}"] = registers
            row[f"spilled bytes, {target}"] = spills
            row["shared bytes"] = shared
            if spills and block == BLOCKS[0]:
                spilled.append(f"{name} on {target}")
        rows.append(row)
    frame = pd.DataFrame(rows)
    versions = ", ".join(
        f"{package} {version(package)}" for package in ("numba-cuda", "nvidia-cuda-nvcc")
    )
    with new_report(folder_of(options, "ptx")) as report:
        sections = [
            provenance(),
            f"Compiled without a GPU; {versions}. Patches of width 5, 32 packed channels, 3 of "
            "style.",
            report.table("ptx", frame, frame),
            "A multiprocessor has 65536 registers, so the 1024 threads of the thesis' blocks of "
            "32x32 get 64 each, and kernels that want more spill; blocks of 32x8, the default, "
            "leave 255. On a device Numba optimizes once more when it links, and may need fewer "
            "registers than these.",
        ]
        report.page("Kernels as PTX", sections)
    for what in spilled:
        print(f"spills: {what}", file=sys.stderr)
    return int(bool(spilled))
