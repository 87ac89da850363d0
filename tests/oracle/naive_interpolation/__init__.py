"""A naive port of views between views, written from oracle/interpolation/SPEC.md (version 1) alone.

A file for each section, one pixel at a time. As a module it has ``run_case``.
"""

from .spec_09_cases import run_case

__all__ = ["run_case"]
