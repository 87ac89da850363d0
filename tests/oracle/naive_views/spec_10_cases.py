"""10. Cases: what is read and written."""

import numpy as np

from . import (
    spec_02_shift,
    spec_03_vectors,
    spec_04_splatting,
    spec_05_silhouettes,
    spec_06_motion,
    spec_07_folding,
    spec_08_order,
    spec_09_runs,
)

SECTIONS = (
    spec_02_shift,
    spec_03_vectors,
    spec_04_splatting,
    spec_05_silhouettes,
    spec_06_motion,
    spec_07_folding,
    spec_08_order,
    spec_09_runs,
)

STAGES = {stage: do for section in SECTIONS for stage, do in section.STAGES.items()}

TYPES = {
    "guide": np.uint8, "mixed": np.uint8, "spreads": np.uint8, "picture": np.uint8,
    "field": np.float32, "visible": np.bool_, "cancels": np.bool_, "rims": np.bool_,
    "beaten": np.bool_, "contested": np.bool_, "weights": np.int64,
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
    return {
        name: np.asarray(value, TYPES.get(name.split("_")[0], np.int32))
        for name, value in outputs.items()
    }
