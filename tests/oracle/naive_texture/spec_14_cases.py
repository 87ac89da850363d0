"""14. Cases: what is read and written."""

import numpy as np

from . import (
    spec_03_exemplars,
    spec_04_random_numbers,
    spec_05_seams,
    spec_06_candidates,
    spec_07_costs,
    spec_08_cut,
    spec_09_alignment,
    spec_10_raster,
    spec_11_change,
    spec_12_iteration,
)

SECTIONS = (
    spec_03_exemplars,
    spec_04_random_numbers,
    spec_05_seams,
    spec_06_candidates,
    spec_07_costs,
    spec_08_cut,
    spec_09_alignment,
    spec_10_raster,
    spec_11_change,
    spec_12_iteration,
)

STAGES = {stage: do for section in SECTIONS for stage, do in section.STAGES.items()}

LARGE = {"cells", "outcomes", "changes", "change", "inner"}
"""Outputs of 64 bits."""


def widen(array):
    """Give integers 64 bits; leave booleans as they are."""
    return array.astype(np.int64) if array.dtype.kind in "iu" else array


def type_of(stage, name):
    """Give the type of an output."""
    if name == "clearance":
        return np.uint16
    large = name in LARGE or (stage, name) in {("guide_costs", "costs"), ("run", "totals")}
    return np.int64 if large else np.int32


def run_case(stage, parameters, arrays):
    """Compute one stage: a dictionary of the output arrays."""
    if stage not in STAGES:
        raise NotImplementedError(stage)
    outputs = STAGES[stage](parameters, {name: widen(array) for name, array in arrays.items()})
    return {name: np.asarray(value, type_of(stage, name)) for name, value in outputs.items()}
