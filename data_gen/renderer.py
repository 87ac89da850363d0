"""Start the renderer, or name in one sentence the package that is missing.

Everything that imports Mitsuba is imported after :func:`start`.
"""

import ctypes.util
import os
import re
from glob import glob

VARIANT = "llvm_ad_rgb"
OLDEST_LLVM = 17
_BUNDLED_WORKS = "the scenes bundled with the project work without it"


class MissingRendererError(Exception):
    """The renderer, or a library it needs, is missing; the message says what to install."""


def start():
    """Select the renderer's variant; afterwards its modules can be imported.

    Raises
    ------
    MissingRendererError
    """
    os.environ["OIDN_DEFAULT_DEVICE"] = "cpu"  # gives the same bytes with and without a GPU
    if "DRJIT_LIBLLVM_PATH" not in os.environ:
        os.environ["DRJIT_LIBLLVM_PATH"] = _newest_llvm()
    try:
        import matplotlib  # noqa: F401
        import mitsuba
        import mitsuba_oidn  # noqa: F401
        import scipy  # noqa: F401
    except ImportError as error:
        raise MissingRendererError(
            f"rendering needs packages that are not installed ({error}): install them with "
            f"pip install '.[render]'; {_BUNDLED_WORKS}"
        ) from error
    try:
        mitsuba.set_variant(VARIANT)
        mitsuba.Float([0.0]) + 1
    except Exception as error:  # an unusable library can raise anything
        raise MissingRendererError(
            f"rendering cannot use {os.environ['DRJIT_LIBLLVM_PATH']} as LLVM library; set "
            f"DRJIT_LIBLLVM_PATH to one of version {OLDEST_LLVM} or newer; {_BUNDLED_WORKS}"
        ) from error


def _newest_llvm():
    """Path of the newest LLVM library that is new enough."""
    patterns = (
        "/usr/lib/*/libLLVM*.so*", "/usr/lib/llvm-*/lib/libLLVM*.so*", "/usr/lib64/libLLVM*.so*",
        "/opt/homebrew/opt/llvm*/lib/libLLVM*.dylib", "/usr/local/opt/llvm*/lib/libLLVM*.dylib",
    )  # fmt: skip
    found = [path for pattern in patterns for path in glob(pattern)]
    found += filter(None, [ctypes.util.find_library("LLVM")])
    newest = max(found, key=_version, default=None)
    if newest is None or _version(newest) < OLDEST_LLVM:
        have = f"the newest found is {newest}" if newest else "none was found"
        raise MissingRendererError(
            f"rendering needs the LLVM library, version {OLDEST_LLVM} or newer, and {have}: "
            "install it (Debian: apt install libllvm19; macOS: brew install llvm) or set "
            f"DRJIT_LIBLLVM_PATH to its path; {_BUNDLED_WORKS}"
        )
    return newest


def _version(path):
    """Major version in a library's path; a path without one is taken for recent."""
    numbers = re.search(r"(?:LLVM-|LLVM\.so\.|llvm-|llvm@)(\d+)", path)
    return int(numbers[1]) if numbers else OLDEST_LLVM
