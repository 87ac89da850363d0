"""Write files so that a failure never leaves a partial file behind."""

import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import real_path


@contextmanager
def whole_file(path: str | Path, size: int) -> Iterator[Path]:
    """Write to a temporary name, which becomes ``path`` when the block succeeds.

    If the block fails, no partial file is left, nor a folder that was made for it. A link is
    followed.

    Parameters
    ----------
    path : str or Path
    size : int
        Bytes that the file may need. The free space is checked first, since some image libraries
        report no error when the disk is full.

    Raises
    ------
    InputError
        If the disk has too little space, or the file cannot be written.
    """
    path, place = Path(path), real_path(path)
    made = _make_folder(place.parent)
    try:
        free = shutil.disk_usage(place.parent).free
        if free < size:
            raise InputError(
                f"{path}: cannot be written: it may need {size / 2**20:.1f} MiB, and the disk has "
                f"{free / 2**20:.1f} MiB free"
            )
        with temporary_name(place) as partial:
            yield partial
            os.replace(partial, place)
    except BaseException as error:
        _remove_folders(made)
        if isinstance(error, OSError):
            raise InputError(f"{path}: cannot be written: {error.strerror or error}") from error
        raise


def write_text(path: str | Path, text: str) -> None:
    """Write a text in UTF-8; a failure leaves no partial file.

    Raises
    ------
    InputError
        As :func:`whole_file`.
    """
    write_bytes(path, text.encode())


def write_bytes(path: str | Path, content: bytes) -> None:
    """Write bytes; a failure leaves no partial file.

    Raises
    ------
    InputError
        As :func:`whole_file`.
    """
    with whole_file(path, len(content)) as partial:
        partial.write_bytes(content)


@contextmanager
def temporary_name(path: str | Path) -> Iterator[Path]:
    """A new name beside ``path``, with its suffix; a file of that name is removed at the end."""
    path = Path(path)
    name = path.with_name(f".{secrets.token_hex(8)}{path.suffix}")
    try:
        yield name
    finally:
        name.unlink(missing_ok=True)


def _make_folder(folder):
    """Make a folder and those it lies in; returns what was made, the innermost first."""
    made = []
    try:
        for part in reversed([folder, *folder.parents]):
            if not part.exists():
                with suppress(FileExistsError):  # another process was faster
                    part.mkdir()
                    made.insert(0, part)
    except OSError as error:
        _remove_folders(made)
        raise InputError(f"{folder}: the folder cannot be made: {error.strerror}") from None
    return made


def _remove_folders(folders):
    for folder in folders:
        with suppress(OSError):  # another process has put something there
            folder.rmdir()
