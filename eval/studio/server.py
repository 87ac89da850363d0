"""A studio that is served by the command."""

import os
import subprocess
import sys
from contextlib import contextmanager

from eval.studio.resident import children, mebibytes
from stylit_ref import InputError

_PATIENCE = 20
"""Seconds that it has to save and end."""


class Server:
    """A studio that is served.

    Attributes
    ----------
    address : str
        With its token.
    """

    def __init__(self, process, address):
        self._process, self.address = process, address

    def mebibytes(self):
        """Resident memory of the server, and of its process in the background.

        Raises
        ------
        InputError
            If it has ended by itself, which would else look as if it held nothing.
        """
        code = self._process.poll()
        if code is not None:
            raise InputError(f"the studio has ended by itself, with the code {code}")
        own = self._process.pid
        return mebibytes(own), sum(map(mebibytes, children(own)))


@contextmanager
def serve(folder, kernels=None):
    """Serve a studio of the bundled scenes, until the end of the block.

    Parameters
    ----------
    folder : Path
        Of the painting.
    kernels : Path, optional
        Folder of compiled kernels, instead of the usual one.

    Yields
    ------
    Server

    Raises
    ------
    InputError
        If it does not start.
    """
    command = [sys.executable, "-m", "stylit_ref", "studio"]
    command += ["--painting", str(folder), "--no-browser", "--port", "0"]
    environment = os.environ | ({"NUMBA_CACHE_DIR": str(kernels)} if kernels else {})
    log = folder.with_name(f"{folder.name}.log")
    with (
        log.open("w", encoding="utf-8") as errors,
        subprocess.Popen(
            command, env=environment, stdout=subprocess.PIPE, stderr=errors, text=True
        ) as process,
    ):
        try:
            line = process.stdout.readline()
            if "http" not in line:
                process.wait()
                raise InputError(f"the studio does not start: {log.read_text()[-300:].strip()}")
            yield Server(process, line.split()[-1])
        finally:
            process.terminate()
            try:
                process.wait(_PATIENCE)
            except subprocess.TimeoutExpired:
                process.kill()
