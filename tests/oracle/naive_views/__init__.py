"""A naive port of coherent frames, written from oracle/views/SPEC.md (version 1) alone.

A file for each section, one pixel at a time. For the search and the vote of a single frame, which
that text leaves to the first one, it uses ``naive_port``. As a module it has ``run_case``.
"""

from .spec_10_cases import run_case

__all__ = ["run_case"]
