"""The stages of the real-time method (oracle/realtime/SPEC.md), up to those of a half iteration."""

import numpy as np

from oracle.stages.realtime_level import (
    LABELS,
    LEVEL,
    grid_of,
    level_of,
    params_of,
    style_image,
)
from oracle.stages.stage import Stage
from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.randomness.random_stream import REALTIME_NNF, REALTIME_SEARCH, random_stream
from stylit_ref.realtime.exemplar import Exemplar
from stylit_ref.realtime.formulae.feature_distance import term_weights
from stylit_ref.realtime.formulae.packed_nnf import entries_of, places_of
from stylit_ref.realtime.layout import Layout
from stylit_ref.realtime.packing import PrincipalPacking, StagePacking, UnpackedStage, pack
from stylit_ref.realtime.passes.image import Image, interior, make_image, whole
from stylit_ref.realtime.passes.moving import ALL
from stylit_ref.realtime.target import Target


def _features(packing, buffers):
    features, labels = pack(packing, buffers)
    return {"features": features, "labels": labels}


def _pack_stage(_, parameters, arrays):
    return _features(StagePacking(), arrays)


def _pack_all(_, parameters, arrays):
    return _features(UnpackedStage(), arrays)


def _pack_principal(_, parameters, arrays):
    numbers = range(1, len(arrays) + 1)
    names = [f"buffer_{k}" for k in numbers if f"buffer_{k}" in arrays]
    channels = [arrays[name].shape[2] if arrays[name].ndim == 3 else 1 for name in names]
    packing = PrincipalPacking(
        tuple(zip(names, channels, strict=True)), arrays["axes"], arrays["offsets"],
        arrays["colours"],
    )  # fmt: skip
    return _features(packing, {name: arrays[name] for name in ("IDMASK", *names)})


def _halve(passes, parameters, arrays):
    image = arrays["image"]
    layout = Layout(params_of({"levels": 2}), image.shape[2], passes)
    exemplar = Exemplar(*image.shape[:2], layout)
    exemplar.set_guides(image)
    return {"half": interior(exemplar.both[1], layout.lanes)[..., : layout.channels].copy()}


def _entry_labels(passes, parameters, arrays):
    level = parameters["level"]
    layout = Layout(params_of(parameters | {"levels": level + 1}), 1, passes)
    exemplar = Exemplar(*arrays["source_labels"].shape, layout)
    exemplar.set_labels(arrays["source_labels"])
    target = Target(*arrays["target_labels"].shape, layout)
    target.set_labels(arrays["target_labels"], exemplar.has_label)
    return {"labels": target.labels[level]}


def _random_nnf(passes, parameters, arrays):
    nnf = np.empty((parameters["rows"], parameters["columns"]), np.int32)
    stream = random_stream(parameters["seed"], REALTIME_NNF, parameters["level"])
    size = parameters["source_height"], parameters["source_width"]
    passes.random_nnf(nnf, *size, parameters["patch_width"] // 2, stream)
    return {"nnf": places_of(nnf)}


def _weights(_, parameters, arrays):
    numbers = parameters["mu"], parameters["guide_weights"], parameters["terms"]
    guides, style = term_weights(*numbers)
    return {"guides": np.array(guides, np.int32), "style": np.int32(style)}


def _records(passes, parameters, arrays):
    """A target has a record for every entry, a source for every pixel."""
    image, spacing = arrays["image"], parameters["spacing"]
    height, width, channels = image.shape
    depth = parameters["depth"]
    chosen = {"means": parameters["means"], "depth": depth, "levels": 1, "scale_space": True}
    if spacing > 1:
        params = params_of(chosen | {"patch_width": 2 * spacing - 1})
        layout = Layout(params, channels, passes)
        target = Target(height, width, layout)
        target.set_guides(image)
        records = target.guide_records[0]
    else:
        layout = Layout(params_of(chosen), channels, passes)
        exemplar = Exemplar(height, width, layout)
        exemplar.set_guides(image)
        exemplar.join()
        records = exemplar.records[0]
    found = interior(records, layout.lanes * depth)
    found = found.reshape(*found.shape[:2], depth, layout.lanes)
    return {"records": found[..., :channels].copy()}


def _read(image, y, x, shape, lanes):
    """The bytes of a patch, (rows, pixels, lanes); a record is a patch of one row."""
    rows, pixels = shape
    values = whole(image, lanes * pixels if rows == 1 else lanes)
    if rows == 1:
        return values[y, x].reshape(1, pixels, lanes).astype(np.int64)
    top, left = (image.border - rows // 2 + place for place in (y, x))
    return values[top : top + rows, left : left + pixels].astype(np.int64)


def _energy(passes, parameters, arrays):
    """From the bytes that a search reads, and its weights."""
    level = level_of(passes, parameters, arrays)
    layout = level.exemplar.layout
    guides, style, spacing = level.target.read_at(0, layout)
    shape, lanes = layout.patch_shape, layout.lanes_read(0)
    source = level.exemplar.read_at(0, layout)
    weights = level.refinement.by_level[0][: shape[1] * lanes].reshape(shape[1], lanes)
    energy = np.empty(level.target.grids[0], np.int32)
    for entry in np.ndindex(energy.shape):
        at = entry[0] * spacing, entry[1] * spacing
        patch = _read(style, *at, shape, STYLE_LANES)
        if lanes > STYLE_LANES:
            own = _read(guides, *at, shape, lanes)[..., :-STYLE_LANES]
            patch = np.concatenate([own, patch], axis=-1)
        there = _read(source, *arrays["nnf"][entry], shape, lanes)
        energy[entry] = (weights * (there - patch) ** 2).sum()
    return {"energy": energy}


def _search(passes, parameters, arrays):
    level = level_of(passes, parameters, arrays)
    layout = level.exemplar.layout
    lanes, nnf = layout.lanes_read(0), entries_of(arrays["nnf"])
    guides, style, _ = level.target.read_at(0, layout)
    stream = random_stream(
        parameters["seed"], REALTIME_SEARCH, parameters["level"], parameters["iteration"],
        parameters["half"],
    )  # fmt: skip
    passes.make_search(*layout.patch_shape, lanes)(
        nnf, level.exemplar.read_at(0, layout), guides, style, level.refinement.by_level[0],
        grid_of(level), stream, parameters["half"], parameters["radius"], np.zeros(1, np.uint8),
    )  # fmt: skip
    return {"nnf": places_of(nnf)}


def _blend(passes, parameters, arrays):
    params = params_of(parameters)
    style = style_image(passes, arrays["source_style"], Layout(params, 1, passes))
    height, width = parameters["height"], parameters["width"]
    picture = np.empty((height, width, 3), np.uint8)
    blend = passes.make_blend(params.patch_width, params.step, 3)
    out = Image(picture.reshape(-1), width, 0, height, width)
    blend(entries_of(arrays["nnf"]), style, out, ALL)
    return {"picture": picture}


def _upsample_nnf(passes, parameters, arrays):
    nnf = np.empty((parameters["rows"], parameters["columns"]), np.int32)
    passes.upsample_nnf(
        entries_of(arrays["nnf"]), nnf, parameters["source_height"], parameters["source_width"],
        parameters["patch_width"] // 2, parameters["spacing"],
    )  # fmt: skip
    return {"nnf": places_of(nnf)}


def _upsample_picture(passes, parameters, arrays):
    layout = Layout(params_of({}), 1, passes)
    fine = make_image(parameters["height"], parameters["width"], layout.border, STYLE_LANES)
    passes.upsample_picture(style_image(passes, arrays["picture"], layout), fine)
    return {"picture": interior(fine, STYLE_LANES)[..., :3].copy()}


def _dense_nnf(passes, parameters, arrays):
    level = level_of(passes, parameters, arrays)
    layout = level.exemplar.layout
    params, lanes = layout.params, layout.lanes_read(0)
    guides, style, _ = level.target.read_at(0, layout)
    labels = arrays.get("target_labels", np.zeros((0, 0), np.uint8))
    dense = np.empty(level.target.size, np.int32)
    passes.make_dense_nnf(params.patch_width, params.step, lanes)(
        entries_of(arrays["nnf"]), level.exemplar.read_at(0, layout), guides, style,
        level.refinement.by_level[0], labels, level.exemplar.labels[0], dense,
        np.zeros(1, np.uint8),
    )  # fmt: skip
    return {"dense": places_of(dense)}


def _vote(passes, parameters, arrays):
    params = params_of(parameters)
    style = style_image(passes, arrays["source_style"], Layout(params, 1, passes))
    picture = np.empty((*arrays["dense"].shape[:2], 3), np.uint8)
    passes.make_vote(params.patch_width)(
        entries_of(arrays["dense"]), style, picture, np.zeros(1, np.uint8)
    )
    return {"picture": picture}


STAGES = {
    "pack_stage": Stage(_pack_stage),
    "pack_all": Stage(_pack_all),
    "pack_principal": Stage(_pack_principal),
    "halve": Stage(_halve, ("make_fill", "make_halve")),
    "entry_labels": Stage(_entry_labels, LABELS),
    "random_nnf": Stage(_random_nnf, ("random_nnf",)),
    "weights": Stage(_weights),
    "records": Stage(_records, LEVEL),
    "energy": Stage(_energy, LEVEL),
    "search": Stage(_search, (*LEVEL, *LABELS, "make_search")),
    "blend": Stage(_blend, ("make_fill", "make_blend")),
    "dense_nnf": Stage(_dense_nnf, (*LEVEL, *LABELS, "make_dense_nnf")),
    "vote": Stage(_vote, ("make_fill", "make_vote")),
    "upsample_nnf": Stage(_upsample_nnf, ("upsample_nnf",)),
    "upsample_picture": Stage(_upsample_picture, ("make_fill", "upsample_picture")),
}
