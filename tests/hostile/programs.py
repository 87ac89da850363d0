"""Start programs of the checkout in a folder, and send them signals."""

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
    """Start ``python -m module`` in a folder; the end of the block ends it.

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
    """Exit code as a shell reports it, and stderr.

    If Ctrl-C strikes inside an exec, which Numba uses to make functions from text, ``python -m``
    ends by the signal although the exception was caught.
    """
    _, said = process.communicate(timeout=500)
    code = process.returncode
    return 130 if code == -signal.SIGINT else code, said


def wait_for(condition, process):
    """Wait until a running program has made the condition true."""
    limit = time.monotonic() + 300
    while not condition():
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < limit
        time.sleep(0.01)
