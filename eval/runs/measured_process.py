"""Run a command and report its time and memory; :mod:`eval.runs.process_cost` starts this program.

On Linux a new process inherits the peak memory of the process that started it. So commands are
started by this program, which imports nothing large.

Usage: ``measured_process.py DESCRIPTOR COMMAND...``; writes ``[wall seconds, processor seconds,
MiB]`` as JSON to an open file descriptor and exits as the command did.
"""

import json
import resource
import subprocess
import sys
import time

descriptor, *command = sys.argv[1:]
start = time.perf_counter()
code = subprocess.run(command, check=False).returncode
seconds = time.perf_counter() - start
used = resource.getrusage(resource.RUSAGE_CHILDREN)
with open(int(descriptor), "w") as report:
    json.dump((seconds, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024), report)
sys.exit(code if code >= 0 else 128 - code)
