"""Every stage of SPEC.md, done by a module of passes."""

import warnings

import numpy as np

from stylit_ref import Params, stylize
from stylit_ref.error_budget import correspondences_within_budget, knee
from stylit_ref.formulae.commit_classes import commit_order
from stylit_ref.formulae.guide_map import scaled_variance
from stylit_ref.formulae.philox import philox4x32
from stylit_ref.formulae.random_stream import (
    COMMIT_ORDER,
    RANDOM_NNF,
    RANDOM_SEARCH,
    random_stream,
)
from stylit_ref.formulae.row_differences import LANES
from stylit_ref.level import Level
from stylit_ref.packing import Packing, make_packing, occurrence_weight
from stylit_ref.patchmatch import propose_commit

METHODS = {"ref", "guide_map"}


def run_case(stage, parameters, arrays, passes, backend="cpu"):
    """Do a stage.

    Parameters
    ----------
    stage : str
        One of :data:`oracle.cases.STAGES`.
    parameters : dict
    arrays : dict of str to array
    passes : module
        :mod:`stylit_ref.passes`, or another that offers the same.
    backend : {"cpu", "cuda"}
        The name of these passes for :func:`stylit_ref.stylize`, which whole runs go through.

    Returns
    -------
    dict of str to array
    """
    if stage == "run":
        return _run(parameters, arrays, backend)
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
        level = _level(passes, parameters, arrays | {"weights": weights})
        level.update_similarity()
        found[name] = passes.download(level.delta)
    return found


def _phi(passes, parameters, arrays):
    nnf = arrays["nnf"]
    assigned = nnf[:, :, 0] >= 0
    sums = arrays["omega_sums"][nnf[:, :, 0], nnf[:, :, 1]].astype(np.int64)
    phi = arrays["delta"] + parameters["occurrence_weight"] * sums
    return {"phi": np.where(assigned, phi, 0)}


def _guide_map(passes, parameters, arrays):
    level = _level(passes, parameters, arrays)
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
    level = _level(passes, parameters | {"epsilon": 0.0}, arrays)
    level.textures = level.textures._replace(guide_map=passes.upload(arrays["white"]))
    level.update_similarity()
    return {"delta": passes.download(level.delta)}


def _propagation(passes, parameters, arrays):
    level = _level(passes, parameters, arrays)
    return _proposed(level, passes.propagation, parameters["distance"])


def _random_search(passes, parameters, arrays):
    level = _level(passes, parameters, arrays)
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
    level = _level(passes, parameters, arrays)
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
    level = _level(passes, parameters, given)
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


def _run(parameters, arrays, backend):
    splits = np.cumsum(parameters["guide_channels"])[:-1]
    sources, targets = (
        np.split(arrays[f"{side}_guides"], splits, axis=2) for side in ("source", "target")
    )
    params = Params(
        parameters["method"],
        patch_width=parameters["patch_width"],
        levels=parameters["levels"],
        votes=parameters["votes"],
        patchmatch_iterations=parameters["iterations"],
        uniformity=parameters["uniformity"],
        guide_influence=parameters["guide_influence"],
        guide_weights=tuple(parameters["guide_weights"]),
        epsilon=parameters["epsilon"],
    )
    mask = arrays.get("mask")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # fewer levels than asked for
        result = stylize(
            arrays["style"], sources, targets, params,
            seed=parameters["seed"], mask=mask, backend=backend,
        )  # fmt: skip
    image = result.image[:, :, : arrays["style"].shape[2]].copy()
    if mask is not None:
        image[mask] = 0
    return {"image": image, "nnf": result.nnf, "omega": result.omega}


def _budget(_, parameters, arrays):
    return {"count": np.int64(correspondences_within_budget(arrays["errors"], parameters["share"]))}


def _knee(_, parameters, arrays):
    pairs = zip(arrays["a"], arrays["b"], strict=True)
    return {"x": np.array([knee(a, b) for a, b in pairs], np.float64)}


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
    "budget": _budget,
    "knee": _knee,
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


def _packing(weights, guides):
    """A layout of channels of any weights, for the passes."""
    places, packed = [], []
    for channel, weight in enumerate(weights.tolist()):
        if channel == guides and len(packed) % 2:
            packed.append(0)
        if len(packed) % 2 and packed[-1] != weight:
            packed.append(0)
        places.append(len(packed))
        packed.append(weight)
    packed += [0] * (-len(packed) % LANES)
    return Packing(
        guide_channels=tuple(places[:guides]),
        style_channel=places[guides],
        style_channels=len(places) - guides,
        channels=len(packed),
        weights=np.array(packed, np.int64),
    )


def _level(passes, parameters, arrays):
    """A level of the library with the arrays of a case in it."""
    guides = parameters["guide_channels"]
    packing = _packing(arrays["weights"], guides)
    params = Params(patch_width=parameters["patch_width"])
    if "epsilon" in parameters:
        params = Params(
            "guide_map", patch_width=parameters["patch_width"], epsilon=parameters["epsilon"]
        )
    textures = []
    for name in ("source", "target"):
        channels = np.split(arrays[name], range(1, guides + 1), axis=2)
        textures.append(passes.upload(packing.pack(channels[:-1], channels[-1])))
    size = arrays["target"].shape[:2]
    synthesized = arrays["nnf"][:, :, 0] >= 0 if "nnf" in arrays else np.ones(size, bool)
    level = Level(passes, packing, params, *textures, synthesized)
    for name in ("nnf", "delta", "omega_sums"):
        if name in arrays:
            setattr(level, name, passes.upload(arrays[name].copy()))
    level.occurrence_weight = parameters.get("occurrence_weight", 0)
    return level
