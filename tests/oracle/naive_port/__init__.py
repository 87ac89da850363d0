"""A naive port of the algorithm, written from SPEC.md (version 1) alone: a file for each section.

As a module it has ``run_case``; as a program it is ``python naive_port INPUT OUTPUT``, two folders.
"""

from .spec_17_cases import run_case

__all__ = ["run_case"]
