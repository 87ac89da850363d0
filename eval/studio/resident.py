"""Resident memory of processes, as Linux counts it."""

from pathlib import Path


def mebibytes(process):
    """Resident memory of a process, in MiB; 0 if it has ended.

    Parameters
    ----------
    process : int
        Its number.
    """
    try:
        lines = Path(f"/proc/{process}/status").read_text().splitlines()
    except OSError:
        return 0.0
    return sum(int(line.split()[1]) for line in lines if line.startswith("VmRSS:")) / 2**10


def children(process):
    """Numbers of the processes that a process has begun and that run; their own are not told."""
    try:
        tasks = list(Path(f"/proc/{process}/task").iterdir())
        return [int(child) for task in tasks for child in (task / "children").read_text().split()]
    except OSError:
        return []
