"""A folder that holds states by their keys, so that a run can go on where one was interrupted."""

import time
from contextlib import suppress
from pathlib import Path

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import check_folder
from stylit_ref.files.disk.whole_file import whole_file
from stylit_ref.views.work.state import State

_SUFFIX = ".state"
_STALE = 3600
"""Seconds after which nobody writes to a temporary file any more."""


class WorkFolder:
    """States on the disk, each in a file of its own.

    A file is written to a temporary name first. One that is damaged all the same, as after a loss
    of power, counts as missing. Several processes may use the folder at once: whoever makes a state
    makes the same bytes.

    Parameters
    ----------
    folder : str or Path
        It is made if it does not exist.

    Raises
    ------
    InputError
        If it cannot be written.
    """

    folder: Path

    def __init__(self, folder: str | Path) -> None:
        check_folder(folder)
        self.folder = Path(folder)
        for left in self.folder.glob(f".*{_SUFFIX}"):  # by a process that was killed as it wrote
            with suppress(OSError):
                if time.time() - left.stat().st_mtime > _STALE:
                    left.unlink()

    def get(self, key: str) -> State | None:
        """The state of a key, or None if it is missing or damaged."""
        try:
            data = self._file(key).read_bytes()
        except FileNotFoundError:
            return None
        except OSError as error:
            raise InputError(f"{self._file(key)}: cannot be read: {error.strerror}") from None
        return State.from_bytes(data)

    def put(self, key: str, state: State) -> None:
        """Keep a state.

        Raises
        ------
        InputError
            If the disk is full, or the folder can no longer be written.
        """
        data = state.to_bytes()
        with whole_file(self._file(key), len(data)) as partial:
            partial.write_bytes(data)

    def forget(self, key: str) -> None:
        """Remove a state, if it is there."""
        with suppress(OSError):
            self._file(key).unlink(missing_ok=True)

    def _file(self, key):
        return self.folder / f"{key}{_SUFFIX}"
