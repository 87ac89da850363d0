"""Every stage of SPEC.md, done by a module of passes."""

import warnings
from dataclasses import replace

import numpy as np
from numba import njit

from oracle import stylit_stages
from oracle.levels import level_of_case
from stylit_ref import Params
from stylit_ref import passes as library_passes
from stylit_ref.formulae.guide_map import scaled_variance
from stylit_ref.formulae.patch_penalization import penalization
from stylit_ref.machine.vector_ssd import LANES
from stylit_ref.metric.fast_metric import make_delta_bound
from stylit_ref.metric.lower_bound import LINE_MOMENTS
from stylit_ref.metric.packing import make_packing, occurrence_weight
from stylit_ref.randomness.commit_classes import commit_order
from stylit_ref.randomness.philox import philox4x32
from stylit_ref.randomness.random_stream import (
    COMMIT_ORDER,
    RANDOM_NNF,
    RANDOM_SEARCH,
    random_stream,
)
from stylit_ref.stylization.checks import fit_levels
from stylit_ref.stylization.mask import active_patches
from stylit_ref.stylization.schedules import propose_commit
from stylit_ref.stylization.synthesis import texture_optimization

METHODS_OWN = "uniformity", "epsilon", "budget", "fixed_share", "error_limit"
"""Parameters that only some methods have."""

_LEVEL = "upload", "zeros", "repeat_edge", "moments_storage", "patch_moments"
_GUIDE_MAP = *_LEVEL, "download", "means", "guide_map"
_SEARCH = *_LEVEL, "propagation", "random_search", "commit"
_RUN = (
    *_SEARCH, "download", "random_nnf", "downsample", "upsample_nnf", "occurrence_map", "vote",
    "similarity", "energy",
)  # fmt: skip

NEEDS = {
    "random_nnf": ("upload", "download", "random_nnf"),
    "downsample": ("upload", "download", "downsample"),
    "upsample_nnf": ("upload", "download", "upsample_nnf"),
    "occurrence": ("upload", "download", "zeros", "occurrence_map"),
    "delta": (*_LEVEL, "download", "similarity"),
    "guide_map": _GUIDE_MAP,
    "white_delta": (*_GUIDE_MAP, "similarity"),
    "propagation": (*_LEVEL, "download", "propagation"),
    "random_search": (*_LEVEL, "download", "random_search"),
    "commit": ("upload", "download", "zeros", "commit"),
    "iteration": (*_SEARCH, "download"),
    "vote": ("upload", "download", "vote"),
    "level": (*_SEARCH, "download", "occurrence_map", "vote", "similarity"),
    "run": (*_RUN, "means", "guide_map"),
    "lower_bound": _LEVEL,
    "invert_nnf": ("invert_nnf",),
    "settle": ("settle_claims",),
    "stylit_search": (*_SEARCH, "random_nnf", "similarity", "invert_nnf", "settle_claims"),
    "stylit_run": (*_RUN, "invert_nnf", "settle_claims"),
}
"""Passes of every stage; what is not here is done by formulae of the library alone."""


def is_offered(stage, passes):
    """Whether a stage checks this module: it has the passes, or all of it is the library's own."""
    if passes is library_passes:
        return True
    if stage not in NEEDS or not all(hasattr(passes, name) for name in NEEDS[stage]):
        return False
    return stage != "lower_bound" or passes.moments_storage(1, 1, LINE_MOMENTS) is not None


def run_case(stage, parameters, arrays, passes):
    """Do a stage.

    Parameters
    ----------
    stage : str
        One of :data:`oracle.cases.STAGES`.
    parameters : dict
    arrays : dict of str to array
    passes : module
        :mod:`stylit_ref.passes`, or another that offers the same.

    Returns
    -------
    dict of str to array
    """
    return _STAGES[stage](passes, parameters, arrays)


def _philox(_, parameters, arrays):
    pairs = zip(arrays["counters"], arrays["keys"], strict=True)
    return {"words": np.array([philox4x32(*counter, *key) for counter, key in pairs], np.uint32)}


def _weights(_, parameters, arrays):
    packing = make_packing(
        parameters["guide_channels"],
        parameters["style_channels"],
        parameters["guide_influence"],
        parameters["guide_weights"],
    )
    guides = zip(packing.guide_channels, parameters["guide_channels"], strict=True)
    places = [first + k for first, count in guides for k in range(count)]
    places += [packing.style_channel + k for k in range(packing.style_channels)]
    weight = occurrence_weight(
        parameters["uniformity"],
        parameters["patch_width"],
        parameters["source_pixels"],
        parameters["target_patches"],
    )
    return {"weights": packing.weights[places], "occurrence_weight": np.int64(weight)}


def _random_nnf(passes, parameters, arrays):
    nnf = passes.upload(arrays["nnf"].copy())
    stream = random_stream(parameters["seed"], RANDOM_NNF, parameters["level"])
    passes.random_nnf(nnf, *_sizes(parameters), stream)
    return {"nnf": passes.download(nnf)}


def _downsample(passes, parameters, arrays):
    return {"image": passes.download(passes.downsample(passes.upload(arrays["image"])))}


def _upsample_nnf(passes, parameters, arrays):
    coarse, nnf = (passes.upload(arrays[name].copy()) for name in ("coarse_nnf", "nnf"))
    passes.upsample_nnf(coarse, nnf, *_sizes(parameters))
    return {"nnf": passes.download(nnf)}


def _occurrence(passes, parameters, arrays):
    width, *size = _sizes(parameters)
    omega, omega_sums = (passes.zeros(tuple(size), np.int32) for _ in range(2))
    passes.occurrence_map(passes.upload(arrays["nnf"]), omega, omega_sums, width)
    return {"omega": passes.download(omega), "omega_sums": passes.download(omega_sums)}


def _delta(passes, parameters, arrays):
    guides = parameters["guide_channels"]
    found = {}
    for name, part in (("delta_guides", np.s_[:guides]), ("delta_style", np.s_[guides:])):
        weights = np.zeros_like(arrays["weights"])
        weights[part] = arrays["weights"][part]
        level = level_of_case(passes, parameters, arrays | {"weights": weights})
        level.update_similarity()
        found[name] = passes.download(level.delta)
    return found


def _phi(_, parameters, arrays):
    nnf, weight = arrays["nnf"], parameters["occurrence_weight"]
    phi = np.zeros_like(arrays["delta"])
    for y, x in np.argwhere(nnf[:, :, 0] >= 0):
        penalty = penalization(arrays["omega_sums"], weight, *nnf[y, x])
        phi[y, x] = penalty + arrays["delta"][y, x]
    return {"phi": phi}


def _guide_map(passes, parameters, arrays):
    level = level_of_case(passes, parameters, arrays)
    used = list(level.packing.guide_channels)
    textures, width = level.textures, level.patch_width
    sums = {
        f"{side}_sums": passes.download(getattr(textures, f"{side}_sums"))
        for side in ("source", "target")
    }
    target, weights = (passes.download(array) for array in (textures.target, textures.weights))
    white = passes.download(textures.guide_map)
    variances = np.zeros(white.shape, np.int64)
    for y, x in np.ndindex(white.shape):
        row = sums["target_sums"][y, x]
        variances[y, x] = scaled_variance(target, row, weights, y, x, width)
    sums = {name: array[:, :, used].astype(np.uint32) for name, array in sums.items()}
    return sums | {"variances": variances, "white": white}


def _white_delta(passes, parameters, arrays):
    level = level_of_case(passes, parameters | {"epsilon": 0.0}, arrays)
    level.textures = level.textures._replace(guide_map=passes.upload(arrays["white"]))
    level.update_similarity()
    return {"delta": passes.download(level.delta)}


def _propagation(passes, parameters, arrays):
    level = level_of_case(passes, parameters, arrays)
    return _proposed(level, passes.propagation, parameters["distance"])


def _random_search(passes, parameters, arrays):
    level = level_of_case(passes, parameters, arrays)
    return _proposed(level, passes.random_search, _stream(parameters, RANDOM_SEARCH))


def _commit_order(passes, parameters, arrays):
    order = np.zeros((16, 2), np.int32)
    commit_order(_stream(parameters, COMMIT_ORDER), order)
    return {"order": order}


def _commit(passes, parameters, arrays):
    names = "nnf", "delta", "proposed_nnf", "proposed_delta", "omega_sums"
    device = {name: passes.upload(arrays[name].copy()) for name in names}
    moves = passes.zeros(1, np.int64)
    passes.commit(
        *device.values(), parameters["occurrence_weight"], parameters["patch_width"],
        _stream(parameters, COMMIT_ORDER), moves,
    )  # fmt: skip
    found = {name: passes.download(device[name]) for name in ("nnf", "delta", "omega_sums")}
    return found | {"moves": passes.download(moves)[0]}


def _iteration(passes, parameters, arrays):
    level = level_of_case(passes, parameters, arrays)
    place = (parameters[name] for name in ("seed", "level", "vote", "iteration"))
    propose_commit(level, *place)
    names = "nnf", "delta", "omega_sums"
    return {name: passes.download(getattr(level, name)) for name in names}


def _vote(passes, parameters, arrays):
    style, nnf, radius = arrays["style"], arrays["nnf"], parameters["patch_width"] // 2
    channels = style.shape[2]
    padded = (nnf.shape[0] + 2 * radius, nnf.shape[1] + 2 * radius, LANES)
    source = np.zeros((*style.shape[:2], LANES), np.uint8)
    source[:, :, :channels] = style
    target = passes.upload(np.zeros(padded, np.uint8))
    passes.vote(
        passes.upload(source), target, passes.upload(nnf), parameters["patch_width"], 0, channels,
        parameters["outliers"],
    )  # fmt: skip
    inside = passes.download(target)[radius:-radius, radius:-radius, :channels]
    return {"style": np.ascontiguousarray(inside)}


def _whole_level(passes, parameters, arrays):
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


def _lower_bound(passes, parameters, arrays):
    level = level_of_case(passes, parameters, arrays)
    bound = np.zeros(level.nnf.shape[:2], np.int64)
    _fill_bounds(make_delta_bound(len(level.packing.moments)), level.textures, level.nnf, bound)
    return {"bound": bound}


@njit
def _fill_bounds(delta_bound, textures, nnf, bound):
    for y in range(bound.shape[0]):
        for x in range(bound.shape[1]):
            if nnf[y, x, 0] >= 0:
                bound[y, x] = delta_bound(textures, y, x, nnf[y, x, 0], nnf[y, x, 1])


_STAGES = {
    "philox": _philox,
    "weights": _weights,
    "random_nnf": _random_nnf,
    "downsample": _downsample,
    "upsample_nnf": _upsample_nnf,
    "occurrence": _occurrence,
    "delta": _delta,
    "phi": _phi,
    "guide_map": _guide_map,
    "white_delta": _white_delta,
    "propagation": _propagation,
    "random_search": _random_search,
    "commit_order": _commit_order,
    "commit": _commit,
    "iteration": _iteration,
    "vote": _vote,
    "level": _whole_level,
    "run": _run,
    "stylit_run": _run,
    "lower_bound": _lower_bound,
    **stylit_stages.STAGES,
}


def _sizes(parameters):
    return tuple(parameters[name] for name in ("patch_width", "source_height", "source_width"))


def _stream(parameters, purpose):
    place = (parameters[name] for name in ("level", "vote", "iteration"))
    return random_stream(parameters["seed"], purpose, *place)


def _proposed(level, propose, *parameters):
    propose(
        level.textures, level.omega_sums, level.occurrence_weight, level.patch_width,
        level.nnf, level.delta, level.proposed_nnf, level.proposed_delta, *parameters,
    )  # fmt: skip
    names = "proposed_nnf", "proposed_delta"
    return {name: level.passes.download(getattr(level, name)) for name in names}
