"""Make waiting threads sleep."""

import os


def sleep_while_waiting() -> None:
    """Let waiting threads sleep almost at once; a program calls this at its start.

    GNU OpenMP threads that wait for each other spin for milliseconds before they sleep. Beside
    another busy program, a spinning thread can occupy the processor that the awaited thread needs,
    and a run takes up to twenty times as long (``docs/performance.md``). The setting is the
    environment variable GOMP_SPINCOUNT, which the first kernel reads and child processes inherit.
    So programs set it, the library does not, and a user's own value is kept.
    """
    os.environ.setdefault("GOMP_SPINCOUNT", "3000")
