"""Compiled kernels that are kept on disk and can never be stale.

Numba's own ``cache=True`` looks at the file of the cached function alone: an edited
formula that a kernel calls would go unnoticed. It also tells two kernels of one factory
apart by pickles that differ in every process. Here a stored kernel belongs to the
source of the whole library, and the constants of its factory are named.
"""

import hashlib
import os
from contextlib import suppress
from pathlib import Path

from numba import njit
from numba.core.caching import FunctionCache, IndexDataCacheFile


def _library_digest():
    library = Path(__file__).parents[1]
    digest = hashlib.sha256()
    for file in sorted(library.rglob("*.py")):
        source = file.read_bytes()
        digest.update(f"{file.relative_to(library)} {len(source)} ".encode() + source)
    return digest.hexdigest()


# Where threads wait for each other, GNU OpenMP spins for milliseconds before it sleeps. Beside
# another busy program that takes the processor from the very thread waited for, and a run
# takes twenty times as long (docs/performance.md). Read when the first kernel runs.
os.environ.setdefault("GOMP_SPINCOUNT", "3000")

LIBRARY_DIGEST = _library_digest()
"""Identifies the source of the library, on which every result depends."""


class _Cache(FunctionCache):
    """Files of their own for every source and every set of constants.

    They lie where Numba would put them: in NUMBA_CACHE_DIR, ``__pycache__`` or the
    user's cache folder. No file is ever written again with other contents, so that
    processes of different sources or constants cannot read each other's.
    """

    def __init__(self, function, constants):
        super().__init__(function)
        identity = hashlib.sha256(repr((LIBRARY_DIGEST, constants)).encode()).hexdigest()[:16]
        self._cache_file = IndexDataCacheFile(
            self._cache_path, f"{self._impl.filename_base}-{identity}", LIBRARY_DIGEST
        )

    def load_overload(self, *arguments):
        """None also for a damaged file, which is emptied: it is compiled and kept anew."""
        try:
            return super().load_overload(*arguments)
        except Exception:  # whatever a pickle of random bytes brings about
            with suppress(OSError):
                self._cache_file.flush()
            return None

    def save_overload(self, *arguments):
        """What does not fit on the disk is not kept, nor what LLVM did not hand over.

        Ctrl-C in its callback loses the compiled object, where a program lets it strike there.
        """
        with suppress(OSError, RuntimeError):
            super().save_overload(*arguments)

    def _index_key(self, signature, codegen):
        return signature, codegen.magic_tuple()


# Only loops that say prange run in parallel: no array expression is worth a loop of its own.
_PRANGE_ALONE = dict.fromkeys(
    ("comprehension", "reduction", "inplace_binop", "setitem", "numpy", "stencil", "fusion"), False
) | {"prange": True}


def kernel(*constants, parallel=True):
    """Compile a loop over a whole array, once for each machine and source.

    Parameters
    ----------
    *constants : int
        What the factory that defines the kernel was called with: the arguments'
        types do not tell these kernels apart.
    parallel : bool
        Whether ``prange`` loops run in parallel.

    Returns
    -------
    callable
        Decorator of a function that Numba can compile.
    """

    def decorate(function):
        dispatcher = njit(parallel=_PRANGE_ALONE if parallel else False, error_model="numpy")(
            function
        )
        with suppress(RuntimeError):  # no folder can be written: every process compiles anew
            dispatcher._cache = _Cache(function, constants)
        return dispatcher

    return decorate
