"""Compiled kernels that are kept on disk and can never be stale.

Numba's own ``cache=True`` looks at the file of the cached function alone: an edited formula that a
kernel calls would go unnoticed. It also tells two kernels of one factory apart by pickles that
differ in every process. Here a stored kernel belongs to the code it can call
(:mod:`stylit_ref.machine.code_digest`), and the constants of its factory are named.
"""

import hashlib
import time
from collections.abc import Callable
from contextlib import suppress
from functools import cached_property
from pathlib import Path
from types import FunctionType
from typing import Any, NamedTuple

from numba import types
from numba.core.caching import FunctionCache, IndexDataCacheFile
from numba.core.registry import cpu_target
from numba.core.runtime import rtsys

from stylit_ref.machine.code_digest import code_digest, imported_files

STARTED = time.time_ns()
"""When this process came to know the code. A file changed later is not the one it runs."""


class KernelCache(FunctionCache):
    """Files of their own for every code, every set of constants and all types of arguments.

    They lie where Numba would put them: in NUMBA_CACHE_DIR, ``__pycache__`` or the user's cache
    folder. No file is ever written again for another kernel, so that processes that compile at the
    same time cannot give each other the wrong one.
    """

    def __init__(self, function: Callable[..., None], constants: tuple[int, ...]) -> None:
        self._function, self._constants = function, constants
        super().__init__(function)
        del self._cache_file  # Numba's own

    @cached_property
    def _cache_file(self):
        """Where the kernel lies; found out when it is first called, as most never are."""
        code = code_digest(*_files_of(self._function))
        return _KernelFiles(self._cache_path, self._impl.filename_base, code, self._constants)

    @cached_property
    def _is_as_it_ran(self):
        """Whether no file has changed since the process began, whose code another one may be.

        A cell of a notebook has no file at all.
        """
        try:
            files = imported_files(*_files_of(self._function))
            return all(file.stat().st_mtime_ns <= STARTED for file in files)
        except (OSError, SyntaxError):
            return False

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """None also for a damaged file, which is emptied: it is compiled and kept anew.

        Numba's own prepares for compiling first, by importing all that code may call, SciPy too.
        What is compiled already needs none of that, and most programs compile nothing.
        """
        if not self._is_as_it_ran:
            return None
        try:
            rtsys.initialize(target_context)
            return self._load_overload(sig, target_context)
        except Exception:  # whatever a pickle of random bytes brings about
            with suppress(OSError):
                self._cache_file.flush(self._index_key(sig, target_context.codegen()))
            return None

    def save_overload(self, *arguments: Any) -> None:
        """What does not fit on the disk is not kept, nor what LLVM did not hand over.

        Ctrl-C in its callback loses the compiled object, where a program lets it strike there.
        """
        with suppress(OSError, RuntimeError):
            if self._is_as_it_ran:
                super().save_overload(*arguments)

    def holds(self, types: tuple[types.Type, ...]) -> bool:
        """Whether the kernel for arguments of these types is on the disk."""
        key = self._index_key(types, cpu_target.target_context.codegen())
        try:
            return self._is_as_it_ran and self._cache_file.holds(key)
        except Exception:  # as in load_overload
            return False

    def number_of(self, types: tuple[types.Type, ...]) -> int | None:
        """A number that tells the kernel for arguments of these types from all others.

        None if it is not kept, since a file of it has changed or is missing.
        """
        if not self._is_as_it_ran:
            return None
        key = self._index_key(types, cpu_target.target_context.codegen())
        return int(self._cache_file.digest(key), 16)

    def _index_key(self, signature, codegen):
        return signature, codegen.magic_tuple()


class _KernelFiles(NamedTuple):
    """The files of the kernels of one function, by Numba's keys: types and processor."""

    folder: str
    name: str
    code: str
    constants: tuple[int, ...]

    def load(self, key):
        return self._of(key).load(key)

    def save(self, key, data):
        self._of(key).save(key, data)

    def holds(self, key):
        return key in self._of(key)._load_index()

    def flush(self, key):
        self._of(key).flush()

    def digest(self, key):
        identity = repr((self.code, self.constants, key))
        return hashlib.sha256(identity.encode()).hexdigest()[:16]

    def _of(self, key):
        return IndexDataCacheFile(self.folder, f"{self.name}-{self.digest(key)}", self.code)


def _files_of(function):
    """The files of a function and of all functions that its factory has put into it."""
    files, waiting, seen = set(), [function], set()
    while waiting:
        found = waiting.pop()
        found = getattr(found, "__wrapped__", getattr(found, "_defn", found))  # of Numba, and ours
        if not isinstance(found, FunctionType) or found in seen:
            continue
        seen.add(found)
        files.add(Path(found.__code__.co_filename))
        for cell in found.__closure__ or ():
            with suppress(ValueError):  # of a name that has no value yet
                content = cell.cell_contents
                waiting += content if isinstance(content, tuple | list) else [content]
    return files
