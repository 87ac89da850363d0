"""Memory of the machine, and of this process."""

import ctypes
import os
import sys


def physical_memory() -> int | None:
    """Bytes of memory that the machine has; None where the system does not say."""
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, OSError, ValueError):  # on Windows, and where the names are not known
        return None


def return_free_memory() -> None:
    """Give the system back what this process has freed, where its C library keeps that.

    It keeps the room of freed arrays for new ones, also where it then lies scattered among others.
    A program that runs for hours and makes arrays of many sizes so grows far beyond what it needs.
    """
    if sys.platform == "linux":
        trim = getattr(ctypes.CDLL(None), "malloc_trim", None)  # of glibc alone
        if trim:
            trim(0)
