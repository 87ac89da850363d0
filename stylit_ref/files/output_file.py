"""Write files so that a failure never leaves a partial file behind."""

import os
import secrets
import shutil
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from tempfile import TemporaryDirectory

from stylit_ref.errors import InputError


def real_path(path: str | Path) -> Path:
    """The absolute path that a path leads to when its links are followed.

    Raises
    ------
    InputError
        If the path cannot name a file: it is too long, leads back to itself, or is not UTF-8.
    """
    try:
        os.fsencode(path).decode()
        place = Path(path).resolve()
        place.exists()
    except OSError as error:
        raise InputError(f"{path}: cannot be used: {error.strerror}") from None
    except RuntimeError:
        raise InputError(f"{path}: is a link that leads back to itself; name a file") from None
    except ValueError:
        raise InputError(f"{path!r}: is not valid UTF-8; give the file another name") from None
    return place


def check_writable(path: str | Path) -> None:
    """Refuse a path where no file can be written. Its folder need not exist.

    Raises
    ------
    InputError
    """
    place = real_path(path)
    if not place.parent.is_dir():
        check_folder(place.parent)
        return
    if place.is_dir():
        raise InputError(f"{path}: is a folder; name a file")
    check_regular(path)
    if not os.access(place.parent, os.W_OK) or (place.exists() and not os.access(place, os.W_OK)):
        raise InputError(f"{path}: cannot be written: permission denied")


def check_regular(path: str | Path) -> None:
    """Refuse a device or a pipe: reading it may never end, and writing would replace it.

    Raises
    ------
    InputError
    """
    if Path(path).exists() and not Path(path).is_file():
        raise InputError(f"{path}: is a device or a pipe; name an ordinary file")


def check_folder(folder: str | Path) -> None:
    """Refuse a folder that cannot be written, or neither exists nor can be made.

    Raises
    ------
    InputError
    """
    nearest = nearest_folder(folder)
    if not nearest.is_dir():
        raise InputError(f"{nearest}: is a file; name a folder")
    try:  # a name of its own: other processes may check the same folder
        with TemporaryDirectory(prefix=".", dir=nearest):
            pass
    except OSError as error:
        raise InputError(f"{folder}: cannot be written: {error.strerror}") from None


def nearest_folder(folder: str | Path) -> Path:
    """The folder itself, or the innermost of those it lies in that exists."""
    place = real_path(folder)
    return next(part for part in (place, *place.parents) if part.exists())


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


@contextmanager
def temporary_name(path: str | Path) -> Iterator[Path]:
    """A new name beside ``path``, with its suffix; a file of that name is removed at the end."""
    path = Path(path)
    name = path.with_name(f".{secrets.token_hex(8)}{path.suffix}")
    try:
        yield name
    finally:
        name.unlink(missing_ok=True)


def check_distinct(
    outputs: Iterable[str | Path | None], inputs: Iterable[str | Path | None] = ()
) -> None:
    """Refuse outputs that would overwrite each other or an input.

    Parameters
    ----------
    outputs, inputs : iterables of str, Path or None
        ``FILE:LAYER`` counts as its file.

    Raises
    ------
    InputError
    """
    taken = {}
    for path in filter(None, inputs):
        place = real_path(path)
        place = place if place.exists() else real_path(str(path).rpartition(":")[0])
        taken[place] = "the output would overwrite this input"
    for path in filter(None, outputs):
        place = real_path(path)
        if place in taken:
            raise InputError(f"{path}: {taken[place]}; name another file")
        taken[place] = "two outputs have this name"


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
    content = text.encode()
    with whole_file(path, len(content)) as partial:
        partial.write_bytes(content)
