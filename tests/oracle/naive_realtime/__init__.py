"""A naive port of stylization in real time, written from oracle/realtime/SPEC.md (version 1) alone.

A file for each section, one pixel at a time. As a module it has ``run_case``.
"""

from .spec_11_cases import run_case

__all__ = ["run_case"]
