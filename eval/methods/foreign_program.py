"""Programs of other people: where they are, and which version."""

import hashlib
import shutil
from pathlib import Path

from stylit_ref import InputError


def find_program(program, name):
    """Path of a program.

    Parameters
    ----------
    program : str
        Its path, or its name if it is on PATH.
    name : str
        What it is called, for the message.

    Raises
    ------
    InputError
        If it cannot be started.
    """
    found = shutil.which(program)
    if not found:
        raise InputError(
            f"{program}: is not a program that can be started; give the path of {name}"
        )
    return found


def digest_of(binary):
    """Digest of a program's file."""
    return hashlib.sha256(Path(binary).read_bytes()).hexdigest()
