"""A whole level and a whole run: section 13 of SPEC.md, and 15 for StyLit's."""

import numpy as np

from oracle.stages.levels import level_of_case
from oracle.stages.stage import SEARCH, Stage
from oracle.stages.stylit import CLAIMS
from stylit_ref import Params
from stylit_ref.stylization.backends import Backend
from stylit_ref.stylization.problem import make_synthesis
from stylit_ref.stylization.schedules import propose_commit

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
        guide_influence=parameters["guide_influence"],
        guide_weights=parameters["guide_weights"],
        **{name: parameters[name] for name in METHODS_OWN if name in parameters},
    )
    mask = arrays.get("mask", np.zeros(size, bool))
    synthesis = make_synthesis(
        style, sources, targets, params,
        seed=parameters["seed"], mask=mask, backend=Backend(passes),
    )  # fmt: skip
    level = synthesis.finish()
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
    "stylit_run": Stage(_run, (*_RUN, *CLAIMS)),
}
