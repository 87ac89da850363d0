"""Compute a stage of stylization with the library."""

from oracle.families import STYLIZATION
from oracle.stages import run_case
from stylit_ref import passes


def answer(stage: str, parameters: dict, arrays: dict) -> dict:
    """The expected arrays of a case of the stage."""
    return run_case(STYLIZATION, stage, parameters, arrays, passes)
