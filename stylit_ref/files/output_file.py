"""Output files that appear whole or not at all."""

import os
import secrets
import shutil
from contextlib import contextmanager
from pathlib import Path

from stylit_ref.errors import InputError


def real_path(path):
    """Where a path leads, links followed.

    Raises
    ------
    InputError
        If no file can be there: too long a name, a link to itself, bytes that are no text.
    """
    try:
        os.fsencode(path).decode()
        place = Path(path).resolve()
        place.exists()
    except OSError as error:
        raise InputError(f"{path}: cannot be a file: {error.strerror}") from None
    except RuntimeError:
        raise InputError(f"{path}: cannot be a file: it is a link to itself") from None
    except ValueError:
        raise InputError(f"{path!r}: cannot be a file: it is no text in UTF-8") from None
    return place


def check_writable(path):
    """Refuse a path where no file can be made.

    Raises
    ------
    InputError
    """
    place = real_path(path)
    if not place.parent.is_dir():
        raise InputError(f"{path}: the folder {place.parent} does not exist")
    if place.is_dir():
        raise InputError(f"{path}: is a folder; name a file")
    check_regular(path)
    if not os.access(place.parent, os.W_OK) or (place.exists() and not os.access(place, os.W_OK)):
        raise InputError(f"{path}: cannot be written: permission denied")


def check_regular(path):
    """Refuse a device or a pipe: one can wait for ever, and writing would replace it by a file.

    Raises
    ------
    InputError
    """
    if Path(path).exists() and not Path(path).is_file():
        raise InputError(f"{path}: is no regular file")


def check_folder(folder):
    """Refuse a folder that neither exists nor can be made; what it makes to see, it removes.

    Raises
    ------
    InputError
    """
    folder, made = Path(folder), []
    try:
        missing = [part for part in (folder, *folder.absolute().parents) if not part.exists()]
        for part in reversed(missing):
            part.mkdir()
            made.append(part)
        if not folder.is_dir():
            raise InputError(f"{folder}: cannot be made: it is a file")
        if not os.access(folder, os.W_OK):
            raise InputError(f"{folder}: cannot be written: permission denied")
    except OSError as error:
        raise InputError(f"{folder}: cannot be made: {error.strerror}") from None
    finally:
        for part in reversed(made):
            part.rmdir()


@contextmanager
def temporary_name(path):
    """A name beside ``path`` with its suffix; the file of that name is gone afterwards."""
    path = Path(path)
    name = path.with_name(f".{secrets.token_hex(8)}{path.suffix}")
    try:
        yield name
    finally:
        name.unlink(missing_ok=True)


def check_distinct(outputs, inputs=()):
    """Refuse outputs that would overwrite each other or what is read.

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
        taken[place if place.exists() else real_path(str(path).rpartition(":")[0])] = "read too"
    for path in filter(None, outputs):
        place = real_path(path)
        if place in taken:
            raise InputError(f"{path}: is {taken[place]}; name another file")
        taken[place] = "named twice"


@contextmanager
def whole_file(path, size):
    """A temporary name that becomes ``path`` when the block succeeds.

    Whatever interrupts the block, no partial file is left. A link is followed.

    Parameters
    ----------
    path : str or Path
    size : int
        Bytes that the file may need. Asked for beforehand: some image libraries write a
        broken file to a full disk without a word.

    Raises
    ------
    InputError
        If there is no room, or the file cannot be written.
    """
    path, place = Path(path), real_path(path)
    try:
        free = shutil.disk_usage(place.parent).free
        if free < size:
            raise InputError(
                f"{path}: cannot be written: it may need {size / 2**20:.1f} MiB and "
                f"{free / 2**20:.1f} MiB are free"
            )
        with temporary_name(place) as partial:
            yield partial
            os.replace(partial, place)
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror or error}") from error


def write_text(path, text):
    """Write a text in UTF-8, whole or not at all.

    Raises
    ------
    InputError
        As :func:`whole_file`.
    """
    content = text.encode()
    with whole_file(path, len(content)) as partial:
        partial.write_bytes(content)
