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
    claims, errors = _claims(parameters, arrays)
    passes.invert_nnf(arrays["nnf"], arrays["delta"], parameters["patch_width"], claims, errors)
    return {"claims": claims - parameters["patch_width"] // 2, "errors": errors}


def _claims(parameters, arrays):
    """Claims as the passes take them: in coordinates of the padded target."""
    return arrays["claims"] + np.int32(parameters["patch_width"] // 2), arrays["errors"].copy()


def _settle(passes, parameters, arrays):
    radius = parameters["patch_width"] // 2
    claims, errors = _claims(parameters, arrays)
    nnf, delta = arrays["nnf"].copy(), arrays["delta"].copy()
    fixed = np.pad(arrays["fixed"], radius, constant_values=True)
    taken = np.where(fixed, stylit.FIXED, stylit.FREE).astype(np.int32)
    passes.settle_claims(
        claims, errors, parameters["last_error"], parameters["last_claims"], arrays["limits"],
        taken, parameters["patch_width"], nnf, delta,
    )  # fmt: skip
    inside = taken[radius:-radius, radius:-radius]
    return {"nnf": nnf, "delta": delta, "claimed": inside == stylit.CLAIMED}


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


STAGES = {
    "budget": Stage(_budget),
    "knee": Stage(_knee),
    "invert_nnf": Stage(_invert_nnf, ("invert_nnf",)),
    "settle": Stage(_settle, ("settle_claims",)),
    "stylit_search": Stage(
        _search, (*SEARCH, "download", "random_nnf", "similarity", "invert_nnf", "settle_claims")
    ),
}
