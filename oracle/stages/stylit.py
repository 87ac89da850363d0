"""StyLit's stages: sections 14 and 15 of SPEC.md."""

import numpy as np

from oracle.stages.levels import level_of_case
from oracle.stages.stage import SEARCH, Stage
from stylit_ref import Params
from stylit_ref.stylization import stylit
from stylit_ref.stylization.error_budget import correspondences_within_budget, knee
from stylit_ref.stylization.schedules import propose_commit


def _budget(_, parameters, arrays):
    return {"count": np.int64(correspondences_within_budget(arrays["errors"], parameters["share"]))}


def _knee(_, parameters, arrays):
    pairs = zip(arrays["a"], arrays["b"], strict=True)
    return {"x": np.array([knee(a, b) for a, b in pairs], np.float64)}


def _invert_nnf(passes, parameters, arrays):
    claims, errors = arrays["claims"].copy(), arrays["errors"].copy()
    passes.invert_nnf(arrays["nnf"], arrays["delta"], parameters["patch_width"], claims, errors)
    return {"claims": claims, "errors": errors}


def _settle(passes, parameters, arrays):
    nnf, delta = arrays["nnf"].copy(), arrays["delta"].copy()
    taken = np.where(arrays["fixed"], np.uint8(stylit.FIXED), np.uint8(stylit.FREE))
    passes.settle_claims(
        arrays["claims"], arrays["errors"],
        parameters["last_error"], parameters["last_claims"], arrays["limits"],
        taken, parameters["patch_width"], nnf, delta,
    )  # fmt: skip
    return {"nnf": nnf, "delta": delta, "claimed": taken == stylit.CLAIMED}


def _search(passes, parameters, arrays):
    level = level_of_case(passes, parameters, arrays)
    params = Params(
        "stylit",
        patch_width=parameters["patch_width"],
        patchmatch_iterations=parameters["iterations"],
        budget=parameters["budget"],
        fixed_share=parameters["fixed_share"],
        error_limit=parameters["error_limit"],
    )
    place = parameters["seed"], parameters["level"], parameters["vote"]
    steps = list(stylit.search(level, params, propose_commit, *place))
    fixed = [step.moves for step in steps if step.retrieval]
    return {"nnf": level.nnf, "delta": level.delta, "fixed_counts": np.array(fixed, np.int64)}


CLAIMS = (
    "claim_errors", "invert_nnf", "lose_claims", "propagate_claims", "search_claims",
    "settle_claims",
)  # fmt: skip
"""Passes of the retrievals."""

STAGES = {
    "budget": Stage(_budget),
    "knee": Stage(_knee),
    "invert_nnf": Stage(_invert_nnf, ("invert_nnf",)),
    "settle": Stage(_settle, ("settle_claims",)),
    "stylit_search": Stage(
        _search,
        (*SEARCH, "download", "random_nnf", *CLAIMS),
    ),
}
