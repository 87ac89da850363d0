"""Programs that keep processors busy while something is measured beside them."""

import subprocess
import sys
from contextlib import contextmanager


@contextmanager
def spinning_processes(count):
    """Programs that do nothing but keep processors busy, while the block runs."""
    program = [sys.executable, "-c", "print(flush=True)\nwhile True: pass"]
    running = [subprocess.Popen(program, stdout=subprocess.PIPE) for _ in range(count)]
    try:
        for each in running:
            each.stdout.readline()  # it has begun
        yield running
    finally:
        for each in running:
            each.kill()
        for each in running:
            each.communicate()
