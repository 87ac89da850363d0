"""Measure the time, processor time and memory of a whole program."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

from stylit_ref import InputError

_MEASURED_PROCESS = str(Path(__file__).with_name("measured_process.py"))


class Cost(NamedTuple):
    """Wall seconds, processor seconds and MiB of memory of a finished process."""

    seconds: float
    processor_seconds: float
    mebibytes: float


def process_cost(command, environment=None):
    """Run a command to its end and measure it.

    Parameters
    ----------
    command : list of str
    environment : dict of str to str, optional

    Returns
    -------
    Cost

    Raises
    ------
    InputError
        If the command fails; the message contains the end of its output.
    """
    reading, writing = os.pipe()
    with open(reading) as report:
        try:
            launcher = subprocess.run(
                [sys.executable, "-S", _MEASURED_PROCESS, str(writing), *command],
                check=False,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                errors="replace",
                env=environment,
                pass_fds=[writing],
            )
        finally:
            os.close(writing)
        if launcher.returncode:
            raise InputError(
                f"{command[0]} failed with code {launcher.returncode}: "
                f"{launcher.stdout[-300:].strip()}"
            )
        return Cost(*json.load(report))
