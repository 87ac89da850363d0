"""Compiled kernels that are kept on disk and can never be stale.

Numba's own ``cache=True`` looks at the file of the cached function alone: an edited
formula that a kernel calls would go unnoticed. It also tells two kernels of one factory
apart by pickles that differ in every process. Here a stored kernel belongs to the
source of the whole library, and the constants of its factory are named.
"""

import hashlib
from pathlib import Path

from numba import njit
from numba.core.caching import CompileResultCacheImpl, FunctionCache


def _library_digest():
    digest = hashlib.sha256()
    for file in sorted(Path(__file__).parent.rglob("*.py")):
        digest.update(file.read_bytes())
    return digest.hexdigest()


LIBRARY_DIGEST = _library_digest()
"""Identifies the source of the library, on which every result depends."""


class _OfThisSource:
    def get_source_stamp(self):
        return LIBRARY_DIGEST


class _Storage(CompileResultCacheImpl):
    """Numba's places for caches: NUMBA_CACHE_DIR, ``__pycache__``, the user's cache folder."""

    _locator_classes = tuple(
        type(locator.__name__, (_OfThisSource, locator), {})
        for locator in CompileResultCacheImpl._locator_classes
    )


class _Cache(FunctionCache):
    _impl_class = _Storage

    def __init__(self, function, constants):
        super().__init__(function)
        self._constants = constants

    def _index_key(self, signature, codegen):
        return signature, codegen.magic_tuple(), self._constants


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
        dispatcher._cache = _Cache(function, constants)
        return dispatcher

    return decorate
