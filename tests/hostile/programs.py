"""Programs of the checkout at work in a folder, and signals to them."""

import os
import resource
import signal
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path

CHECKOUT = Path(__file__).parents[2]


@contextmanager
def started(module, *arguments, folder, largest_file=None, **environment):
    """Start ``python -m module`` in a folder; it has ended when the block ends.

    Parameters
    ----------
    module : str
    *arguments : objects
    folder : Path
    largest_file : int, optional
        Bytes after which writing a file fails, as on a full disk.
    **environment : str
        Variables in addition to those of this process.
    """

    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))

    process = subprocess.Popen(
        [sys.executable, "-m", module, *map(str, arguments)],
        cwd=folder, env=os.environ | {"PYTHONPATH": str(CHECKOUT)} | environment,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        preexec_fn=limit if largest_file is not None else None,
    )  # fmt: skip
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def done(process):
    """Exit code, as a shell has it, and stderr.

    Where Ctrl-C strikes inside an exec, as when Numba makes a function of text, ``python -m`` ends
    by the signal, though the exception was caught.
    """
    _, said = process.communicate(timeout=500)
    code = process.returncode
    return 130 if code == -signal.SIGINT else code, said


def wait_for(condition, process):
    """Wait until something is so that a program at work brings about."""
    limit = time.monotonic() + 300
    while not condition():
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < limit
        time.sleep(0.01)
