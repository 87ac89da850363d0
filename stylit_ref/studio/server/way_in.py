"""A file that leads a browser to the studio.

The address has the token in it, and what a program is started with can be read by everybody on a
machine. So the browser is started with the file, which its owner alone can read.
"""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from stylit_ref.errors import InputError

_NAME = "open_studio.html"

_PAGE = """\
<!doctype html>
<meta charset="utf-8">
<title>Studio</title>
<meta http-equiv="refresh" content="0; url={address}">
<p><a href="{address}">Open the studio</a></p>
"""


@contextmanager
def way_in(folder: Path, address: str) -> Iterator[str]:
    """Write it, and take it away in the end.

    Parameters
    ----------
    folder : Path
        One that no other studio has open.
    address : str
        Where it leads.

    Yields
    ------
    str
        Its own address.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    file = folder / _NAME
    try:
        file.unlink(missing_ok=True)  # of a studio that was killed
        with open(file, "x", encoding="utf-8", opener=_for_owner_alone) as page:
            page.write(_PAGE.format(address=address))
    except OSError as error:
        raise InputError(f"{file}: cannot be written: {error.strerror}") from None
    try:
        yield file.resolve().as_uri()
    finally:
        file.unlink(missing_ok=True)


def _for_owner_alone(path: str, flags: int) -> int:
    return os.open(path, flags, 0o600)
