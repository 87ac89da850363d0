"""A whole level and a whole run: section 13 of SPEC.md, and 15 for StyLit's."""

import warnings
from dataclasses import replace

import numpy as np

from oracle.stages.levels import level_of_case
from oracle.stages.stage import SEARCH, Stage
from stylit_ref import Params
from stylit_ref.metric.packing import make_packing
from stylit_ref.stylization.checks import fit_levels
from stylit_ref.stylization.mask import active_patches
from stylit_ref.stylization.schedules import propose_commit
from stylit_ref.stylization.synthesis import texture_optimization

METHODS_OWN = "uniformity", "epsilon", "budget", "fixed_share", "error_limit"
"""Parameters that only some methods have."""


def _level(passes, parameters, arrays):
    guides = arrays["target_guides"]
    style_channels = arrays["source"].shape[2] - guides.shape[2]
    blank = np.zeros((*guides.shape[:2], style_channels), np.uint8)
    given = arrays | {"target": np.concatenate([guides, blank], axis=2)}
    level = level_of_case(passes, parameters, given)
    level.init_occurrence_map()
    for vote in range(1, parameters["votes"] + 1):
        level.vote()
        level.update_moments()
        for iteration in range(1, parameters["iterations"] + 1):
            propose_commit(level, parameters["seed"], parameters["level"], vote, iteration)
    level.vote()
    level.init_occurrence_map()
    found = {name: passes.download(getattr(level, name)) for name in ("nnf", "omega")}
    return found | {"style": np.ascontiguousarray(level.style)}


def _run(passes, parameters, arrays):
    splits = np.cumsum(parameters["guide_channels"])[:-1]
    sources, targets = (
        np.split(arrays[f"{side}_guides"], splits, axis=2) for side in ("source", "target")
    )
    style, size = arrays["style"], targets[0].shape[:2]
    params = Params(
        parameters.get("method", "stylit"),
        patch_width=parameters["patch_width"],
        levels=parameters["levels"],
        votes=parameters["votes"],
        patchmatch_iterations=parameters["iterations"],
        **{name: parameters[name] for name in METHODS_OWN if name in parameters},
    )
    if params.method == "stylit":
        params = replace(params, uniformity=0)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # fewer levels than asked for
        params = fit_levels(params, style.shape[:2], size)
    packing = make_packing(
        parameters["guide_channels"],
        style.shape[2],
        parameters["guide_influence"],
        parameters["guide_weights"],
    )
    mask = arrays.get("mask", np.zeros(size, bool))
    level = texture_optimization(
        passes,
        packing.pack(sources, style),
        packing.pack(targets),
        active_patches(mask, params.patch_width),
        packing,
        params,
        parameters["seed"],
        on_step=lambda step: None,
        on_level=lambda number, level: None,
    )
    image = level.style.copy()
    image[mask] = 0
    return {name: passes.download(getattr(level, name)) for name in ("nnf", "omega")} | {
        "image": image
    }


_RUN = (
    *SEARCH, "download", "random_nnf", "downsample", "upsample_nnf", "occurrence_map", "vote",
    "similarity", "energy",
)  # fmt: skip

STAGES = {
    "level": Stage(_level, (*SEARCH, "download", "occurrence_map", "vote", "similarity")),
    "run": Stage(_run, (*_RUN, "means", "guide_map")),
    "stylit_run": Stage(_run, (*_RUN, "invert_nnf", "settle_claims")),
}
