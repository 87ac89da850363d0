"""11. Cases: what is read and written."""

import numpy as np

from . import (
    spec_02_packing,
    spec_03_levels,
    spec_04_random_numbers,
    spec_05_energy,
    spec_06_search,
    spec_07_blend,
    spec_08_upsampling,
    spec_09_frame,
    spec_10_dense_finish,
)

SECTIONS = (
    spec_02_packing,
    spec_03_levels,
    spec_04_random_numbers,
    spec_05_energy,
    spec_06_search,
    spec_07_blend,
    spec_08_upsampling,
    spec_09_frame,
    spec_10_dense_finish,
)

STAGES = {stage: do for section in SECTIONS for stage, do in section.STAGES.items()}

BYTES = {"features", "half", "records", "picture", "replayed"}


def type_of(stage, name):
    """Give the type of an output."""
    if name == "labels":
        return np.int16 if stage == "entry_labels" else np.uint8
    return np.uint8 if name in BYTES else np.int32


def run_case(stage, parameters, arrays):
    """Compute one stage: a dictionary of the output arrays."""
    if stage not in STAGES:
        raise NotImplementedError(stage)
    given = {name: array.astype(np.int64) for name, array in arrays.items()}
    outputs = STAGES[stage](parameters, given)
    return {name: np.asarray(value, type_of(stage, name)) for name, value in outputs.items()}
