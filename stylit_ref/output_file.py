"""Output files that appear whole or not at all."""

import os
from contextlib import contextmanager
from pathlib import Path

from stylit_ref.errors import InputError


def check_writable(path):
    """Refuse a path where no file can be made.

    Raises
    ------
    InputError
    """
    path = Path(path)
    folder = path.parent
    if not folder.is_dir():
        raise InputError(f"{path}: the folder {folder} does not exist")
    if path.is_dir():
        raise InputError(f"{path}: is a folder; name a file")
    if not os.access(folder, os.W_OK) or (path.exists() and not os.access(path, os.W_OK)):
        raise InputError(f"{path}: cannot be written: permission denied")


@contextmanager
def whole_file(path):
    """A temporary name beside ``path`` that replaces it when the block succeeds.

    Whatever interrupts the block, no partial file is left.
    """
    path = Path(path)
    partial = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
    try:
        yield partial
        os.replace(partial, path)
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from error
    finally:
        partial.unlink(missing_ok=True)
