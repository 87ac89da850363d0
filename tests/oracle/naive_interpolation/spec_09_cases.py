"""9. Cases: what is read and written."""

import numpy as np

from . import (
    spec_02_around,
    spec_03_cameras,
    spec_04_seen,
    spec_05_shifting,
    spec_06_votes,
    spec_07_mixing,
    spec_08_frames,
)

SECTIONS = (
    spec_02_around,
    spec_03_cameras,
    spec_04_seen,
    spec_05_shifting,
    spec_06_votes,
    spec_07_mixing,
    spec_08_frames,
)

STAGES = {stage: do for section in SECTIONS for stage, do in section.STAGES.items()}

TYPES = {
    "picture": np.uint8, "masked": np.bool_, "seen": np.float64, "inverse": np.float64,
}  # fmt: skip
"""Types of the outputs; all others are int32."""


def widen(array):
    """Give integers 64 bits; leave truth and floats as they are."""
    return array.astype(np.int64) if array.dtype.kind in "iu" else array


def run_case(stage, parameters, arrays):
    """Compute one stage: a dictionary of the output arrays."""
    if stage not in STAGES:
        raise NotImplementedError(stage)
    outputs = STAGES[stage](parameters, {name: widen(array) for name, array in arrays.items()})
    return {name: np.asarray(value, TYPES.get(name, np.int32)) for name, value in outputs.items()}
