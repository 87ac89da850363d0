"""Make waiting threads sleep."""

import os
import sys


def sleep_while_waiting() -> None:
    """Let waiting threads sleep almost at once; a program calls this at its start.

    GNU OpenMP threads that wait for each other spin for milliseconds before they sleep. Beside
    another busy program, a spinning thread can occupy the processor that the awaited thread needs,
    and a run takes up to twenty times as long (``docs/performance.md``). Numba prefers TBB where it
    is there, but a short loop takes longer with it, and a thread of it can spin for ever. So OpenMP
    comes first. The settings are the environment variables GOMP_SPINCOUNT and
    NUMBA_THREADING_LAYER_PRIORITY, which the first kernel reads and child processes inherit. So
    programs set them, the library does not, and a user's own values are kept.
    """
    os.environ.setdefault("GOMP_SPINCOUNT", "3000")
    os.environ.setdefault("NUMBA_THREADING_LAYER_PRIORITY", "omp tbb workqueue")
    if "numba" in sys.modules:  # it has read its settings already
        sys.modules["numba"].config.reload_config()
