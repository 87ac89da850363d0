"""17. Cases: what is read and written."""

import json

import numpy as np

from . import (
    spec_01_names,
    spec_02_weights,
    spec_03_metric,
    spec_04_random_numbers,
    spec_05_random_nnf,
    spec_06_pyramid,
    spec_07_propagation,
    spec_08_random_search,
    spec_09_commit,
    spec_10_iteration,
    spec_11_vote,
    spec_12_guide_maps,
    spec_13_runs,
    spec_14_error_budget,
    spec_15_stylit,
    spec_16_lower_bound,
)

SECTIONS = (
    spec_01_names,
    spec_02_weights,
    spec_03_metric,
    spec_04_random_numbers,
    spec_05_random_nnf,
    spec_06_pyramid,
    spec_07_propagation,
    spec_08_random_search,
    spec_09_commit,
    spec_10_iteration,
    spec_11_vote,
    spec_12_guide_maps,
    spec_13_runs,
    spec_14_error_budget,
    spec_15_stylit,
    spec_16_lower_bound,
)

STAGES = {stage: do for section in SECTIONS for stage, do in section.STAGES.items()}

OUTPUT_TYPES = {
    "words": np.uint32,
    "weights": np.int64,
    "occurrence_weight": np.int64,
    "nnf": np.int32,
    "proposed_nnf": np.int32,
    "omega": np.int32,
    "omega_sums": np.int32,
    "order": np.int32,
    "image": np.uint8,
    "style": np.uint8,
    "delta": np.int64,
    "delta_guides": np.int64,
    "delta_style": np.int64,
    "proposed_delta": np.int64,
    "phi": np.int64,
    "source_sums": np.uint32,
    "target_sums": np.uint32,
    "variances": np.int64,
    "white": np.bool_,
    "moves": np.int64,
    "count": np.int64,
    "x": np.float64,
    "bound": np.int64,
    "claims": np.int32,
    "errors": np.int64,
    "claimed": np.bool_,
    "fixed_counts": np.int64,
}


def widen(array):
    """Give integers 64 bits; leave booleans and doubles as they are."""
    array = np.asarray(array)
    return array.astype(np.int64) if array.dtype.kind in "iu" else array


def run_case(stage, parameters, arrays):
    """Compute one stage: a dictionary of the output arrays."""
    if stage not in STAGES:
        raise NotImplementedError(stage)
    outputs = STAGES[stage](parameters, {name: widen(array) for name, array in arrays.items()})
    return {name: np.asarray(value, OUTPUT_TYPES[name]) for name, value in outputs.items()}


def read_case(folder):
    """Read stage, parameters and arrays of a case."""
    case = json.loads((folder / "case.json").read_text(encoding="utf-8"))
    arrays = {path.stem: np.load(path, allow_pickle=False) for path in folder.glob("*.npy")}
    return case["stage"], case["parameters"], arrays


def write_outputs(outputs, folder):
    """Write the output arrays of a case."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, array in outputs.items():
        np.save(folder / f"{name}.npy", array, allow_pickle=False)
