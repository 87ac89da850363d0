"""A folder that one studio alone has open: two would save over each other's paint."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from stylit_ref.errors import InputError

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl

_LOCK = ".studio.lock"


@contextmanager
def held(folder: Path) -> Iterator[None]:
    """Hold a folder while the block runs; a program that is killed lets go of it, too.

    Parameters
    ----------
    folder : Path
        Is made, if need be; if nothing was saved in it, it is taken away in the end.

    Raises
    ------
    InputError
        If another studio has it open, or it cannot be written.
    """
    file = folder / _LOCK
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock = file.open("ab")
    except OSError as error:
        raise InputError(f"{folder}: cannot be written: {error.strerror}") from None
    with lock:
        try:
            _lock(lock)
        except OSError:
            raise InputError(
                f"{folder}: another studio has it open; go on in its page, or name another folder "
                "by --painting"
            ) from None
        try:
            yield
        finally:
            with suppress(OSError):
                if list(folder.iterdir()) == [file]:  # nothing was painted
                    file.unlink()
                    folder.rmdir()


def _lock(file: IO[bytes]) -> None:
    if sys.platform == "win32":
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
    else:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
