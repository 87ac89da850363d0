"""How threads wait for each other."""

import os


def sleep_while_waiting():
    """Have threads sleep soon where they wait for each other, for a program to call at its start.

    GNU OpenMP spins for milliseconds before it sleeps. If another busy program holds the
    processor, the spinning thread keeps it from the very thread it waits for, and a run takes up
    to twenty times as long (``docs/performance.md``). The setting belongs to the process and its
    children, and is read when the first kernel runs: so programs make it, and the library does not.
    A value of GOMP_SPINCOUNT that is there already stays.
    """
    os.environ.setdefault("GOMP_SPINCOUNT", "3000")
