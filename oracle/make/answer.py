"""What the library makes of a stage of stylization."""

from oracle.families import STYLIZATION
from oracle.stages import run_case
from stylit_ref import passes


def answer(stage: str, parameters: dict, arrays: dict) -> dict:
    """The arrays that a case of the stage must give."""
    return run_case(STYLIZATION, stage, parameters, arrays, passes)
