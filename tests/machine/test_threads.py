"""Settings of threads that wait: a program makes them, and keeps those of its user."""

import os
import subprocess
import sys

import pytest

NAMES = ("GOMP_SPINCOUNT", "NUMBA_THREADING_LAYER_PRIORITY")


def settings(*imports, **own):
    """Spins and layers of a process that imports these before it makes its settings."""
    lines = (
        *imports,
        "from stylit_ref.machine.threads import sleep_while_waiting",
        "sleep_while_waiting()",
        "import os, numba",
        "print(os.environ['GOMP_SPINCOUNT'], *numba.config.THREADING_LAYER_PRIORITY)",
    )
    environment = {name: value for name, value in os.environ.items() if name not in NAMES}
    done = subprocess.run(
        [sys.executable, "-c", "\n".join(lines)],
        env=environment | own, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


@pytest.mark.parametrize("imports", [(), ("import numba",)], ids=["first", "after-numba"])
def test_waiting_threads_sleep_and_openmp_comes_before_tbb(imports):
    assert settings(*imports) == ["3000", "omp", "tbb", "workqueue"]


def test_a_users_own_settings_are_kept():
    own = {"GOMP_SPINCOUNT": "77", "NUMBA_THREADING_LAYER_PRIORITY": "tbb workqueue omp"}
    assert settings("import numba", **own) == ["77", "tbb", "workqueue", "omp"]
