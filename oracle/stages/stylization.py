"""The stages of SPEC.md, without those of StyLit and those of whole levels and runs."""

import numpy as np
from numba import njit

from oracle.compare import NotOfferedError
from oracle.stages.levels import level_of_case
from oracle.stages.stage import LEVEL, SEARCH, Stage
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
from stylit_ref.stylization.schedules import propose_commit


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


def _lower_bound(passes, parameters, arrays):
    if passes.moments_storage(1, 1, LINE_MOMENTS) is None:
        raise NotOfferedError
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


_IMAGES = "upload", "download"
_GUIDE_MAP = *LEVEL, "download", "means", "guide_map"

STAGES = {
    "philox": Stage(_philox),
    "weights": Stage(_weights),
    "random_nnf": Stage(_random_nnf, (*_IMAGES, "random_nnf")),
    "downsample": Stage(_downsample, (*_IMAGES, "downsample")),
    "upsample_nnf": Stage(_upsample_nnf, (*_IMAGES, "upsample_nnf")),
    "occurrence": Stage(_occurrence, (*_IMAGES, "zeros", "occurrence_map")),
    "delta": Stage(_delta, (*LEVEL, "download", "similarity")),
    "phi": Stage(_phi),
    "guide_map": Stage(_guide_map, _GUIDE_MAP),
    "white_delta": Stage(_white_delta, (*_GUIDE_MAP, "similarity")),
    "propagation": Stage(_propagation, (*LEVEL, "download", "propagation")),
    "random_search": Stage(_random_search, (*LEVEL, "download", "random_search")),
    "commit_order": Stage(_commit_order),
    "commit": Stage(_commit, (*_IMAGES, "zeros", "commit")),
    "iteration": Stage(_iteration, (*SEARCH, "download")),
    "vote": Stage(_vote, (*_IMAGES, "vote")),
    "lower_bound": Stage(_lower_bound, LEVEL),
}
