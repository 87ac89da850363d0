"""Names of files that are read or written: what cannot be one is refused before the work begins."""

import os
from collections.abc import Iterable
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


def split_layer(path: str | Path) -> tuple[Path, str | None]:
    """Split ``file:LAYER`` into file and layer, unless a file has that whole name.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    file : Path
    layer : str or None

    Raises
    ------
    InputError
        If there is no such file.
    """
    real_path(path)
    text = str(path)
    colons = [place for place, sign in enumerate(text) if sign == ":"]
    splits = [(Path(text), None)]
    splits += [(Path(text[:place]), text[place + 1 :]) for place in reversed(colons)]
    for file, layer in splits:
        if file.is_file():
            return file, layer
    return existing_file(next((file for file, _ in reversed(splits) if file.suffix), text)), None


def is_there(path: str | Path) -> bool:
    """Whether there is such a file; a layer behind its name does not count."""
    try:
        split_layer(path)
    except InputError:
        return False
    return True


def existing_file(file: str | Path) -> Path:
    """Refuse what is no file.

    Raises
    ------
    InputError
    """
    real_path(file)
    if not Path(file).is_file():
        reason = "is a folder; name an image file" if Path(file).is_dir() else "no such file"
        raise InputError(f"{file}: {reason}")
    return Path(file)


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


def check_distinct(
    outputs: Iterable[str | Path | None], inputs: Iterable[str | Path | None] = ()
) -> None:
    """Refuse outputs that would overwrite each other or an input.

    Parameters
    ----------
    outputs, inputs : iterables of str, Path or None
        An input is there already; ``FILE:LAYER`` counts as its file.

    Raises
    ------
    InputError
    """
    taken = {}
    for path in filter(None, inputs):
        file, _ = split_layer(path)
        taken[real_path(file)] = "the output would overwrite this input"
    for path in filter(None, outputs):
        place = real_path(path)
        if place in taken:
            raise InputError(f"{path}: {taken[place]}; name another file")
        taken[place] = "two outputs have this name"
