"""The stages of texture synthesis (oracle/texture/SPEC.md), up to those of a patch."""

import numpy as np

from oracle.stages.stage import Stage
from oracle.stages.texture_level import (
    centres_of,
    context_of,
    half_widths,
    hidden_by,
    padded_crossing,
    padded_steps,
    scene_of,
    stream_of,
)
from stylit_ref.randomness.philox import philox4x32, uniform_below
from stylit_ref.randomness.random_stream import GRID, PATCHES, WHITE_NOISE
from stylit_ref.texture.exemplars import make_exemplars
from stylit_ref.texture.formulae.polar import BLOCKED
from stylit_ref.texture.passes.acceptance import cost_change, inner_cost, write_patch
from stylit_ref.texture.passes.alignment import alignment_costs
from stylit_ref.texture.passes.candidates import find_candidate
from stylit_ref.texture.passes.cut_costs import cut_costs, end_rays, existing_seams
from stylit_ref.texture.passes.deformation import rasterize
from stylit_ref.texture.passes.guide_costs import guide_costs
from stylit_ref.texture.passes.lock import free_locked_edges
from stylit_ref.texture.passes.new_seams import new_seams
from stylit_ref.texture.passes.seam_maps import seam_maps
from stylit_ref.texture.passes.use import price_use
from stylit_ref.texture.passes.white_noise import white_noise


def _white_noise(_, parameters, arrays):
    addresses = np.empty((parameters["height"], parameters["width"]), np.int32)
    white_noise(addresses, arrays["pixels"], stream_of(parameters, WHITE_NOISE))
    return {"addresses": addresses}


def cells_of(parameters):
    """Centres of the cells of an iteration."""
    height, width, radius = (parameters[name] for name in ("height", "width", "radius"))
    words = philox4x32(0, 0, *stream_of(parameters, GRID))
    axes = []
    for word, side in zip(words, (height, width), strict=False):
        number = max(1, side // (2 * radius))
        axes.append((uniform_below(word, side) + np.arange(number) * side // number) % side)
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 2).astype(np.int64)


def _grid(_, parameters, arrays):
    return {"cells": cells_of(parameters)}


def numbered(arrays, name):
    """Arrays NAME_1, NAME_2 ... in order."""
    return [arrays[f"{name}_{k}"] for k in range(1, len(arrays) + 1) if f"{name}_{k}" in arrays]


def _exemplars(_, parameters, arrays):
    known = numbered(arrays, "known") or None
    made = make_exemplars(
        numbered(arrays, "image"), parameters["radius"], known=known,
        fractions=parameters["fractions"],
    )  # fmt: skip
    return {
        "colours": made.colours,
        "clearance": made.clearance,
        "centres": centres_of(made.clearance, parameters["radius"]),
    }


def _seams(_, parameters, arrays):
    seams = np.empty((2, *arrays["addresses"].shape), np.int32)
    numbers = (parameters[name] for name in ("stride", "eta", "exponent"))
    seam_maps(arrays["addresses"], arrays["colours"], *numbers, *seams)
    return {"seams_x": seams[0], "seams_y": seams[1]}


def _guide_costs(_, parameters, arrays):
    costs = np.empty(arrays["addresses"].shape, np.int64)
    guide_costs(
        arrays["addresses"], arrays["guide_colours"], arrays["guide"], parameters["guide_weight"],
        costs,
    )  # fmt: skip
    return {"costs": costs}


def _candidates(_, parameters, arrays):
    scene = scene_of(parameters, arrays)
    _, sources, _, settings = scene
    price_use(arrays["addresses"], sources.clearance, sources.centres, settings, sources.prices)
    found = []
    for cell, (y, x) in enumerate(arrays["cells"].tolist()):
        draw = parameters["attempt"] * parameters["prescreened"]
        found.append(
            find_candidate(
                scene.texture, scene.sources, scene.settings, context_of(scene, y, x),
                stream_of(parameters, PATCHES), cell, draw, -1, y, x,
            )
        )  # fmt: skip
    return {"candidates": np.array(found, np.int32)}


def _costs(_, parameters, arrays):
    scene = scene_of(parameters, arrays)
    _, sources, polar, settings = scene
    y, x, source = (parameters[name] for name in ("y", "x", "source"))
    context, half_width = context_of(scene, y, x), polar.half_width
    hidden, halved = hidden_by(scene, context, source, y, x)
    new_x, new_y = (np.zeros(half_width.size**2, np.int32) for _ in range(2))
    new_seams(
        sources.colours, settings.stride, source, half_width, context, settings.eta,
        settings.exponent, halved, settings.new_limit, new_x, new_y,
    )  # fmt: skip
    if settings.has_lock:
        free_locked_edges(half_width, context, new_x, new_y)
    rows, columns = polar.inside.shape
    saved, crossing, steps = (np.zeros((rows, columns + 2), np.int32) for _ in range(3))
    saved = saved[:, :columns].copy()
    existing_seams(hidden, polar, halved, settings.existing_limit, saved)
    edges = np.zeros((2, columns), np.int32)
    cut_costs(new_x, new_y, saved, polar, 1, edges, crossing, steps)
    end_rays(sources.clearance, settings.stride, source, polar, 1, crossing)
    tables = {"crossing": crossing[:, 1:-1].copy(), "steps": steps[:, 1:-1].copy()}
    return tables | {"saved": saved, "halved": np.int32(halved)}


def best_cuts(passes, crossing, steps, max_jump, arrivals):
    """T, the paths and their costs, for tables of (n, H, W) and arrivals of (n, W)."""
    number, rows, columns = crossing.shape
    wide = padded_crossing(crossing, max_jump), padded_steps(steps, max_jump)
    arrivals = np.pad(arrivals, ((0, 0), (max_jump, max_jump))).ravel()
    given = [passes.upload(array) for array in (*wide, arrivals)]
    shapes = (rows + 1, wide[0].shape[1]), (number, rows), (number,)
    room = [passes.zeros(shape, np.int32) for shape in shapes]
    passes.best_cuts(*given[:2], max_jump, given[2], *room)
    totals, paths, costs = map(passes.download, room)
    totals = totals.reshape(rows + 1, number, -1)[:, :, max_jump : max_jump + columns]
    return totals.transpose(1, 0, 2).copy(), paths, costs


def _cut(passes, parameters, arrays):
    found = best_cuts(
        passes, arrays["crossing"], arrays["steps"], parameters["max_jump"], arrays["arrivals"]
    )
    return dict(zip(("totals", "paths", "costs"), found, strict=True))


def _closed_cut(passes, parameters, arrays):
    crossing, steps, max_jump = arrays["crossing"], arrays["steps"], parameters["max_jump"]
    arrivals = np.zeros_like(crossing[:, 0])
    totals, paths, costs = best_cuts(passes, crossing, steps, max_jump, arrivals)
    if parameters["second_pass"]:
        ends = totals[:, -1].astype(np.int64)
        arrivals = np.minimum(ends - ends.min(axis=1, keepdims=True), BLOCKED).astype(np.int32)
        _, paths, costs = best_cuts(passes, crossing, steps, max_jump, arrivals)
        smallest = crossing[:, :, 0].sum(axis=1, dtype=np.int64)
        least = smallest < costs
        paths[least], costs[least] = 0, smallest[least]
    return {"paths": paths, "costs": costs}


def _alignment(passes, parameters, arrays):
    scene = scene_of(parameters, arrays)
    rows, shifts = arrays["path"].size, 2 * parameters["max_shift"] + 1
    line = np.zeros((9, rows + shifts - 1), np.int32)
    costs, steps = (np.zeros((rows, shifts + 2), np.int32) for _ in range(2))
    alignment_costs(
        scene.sources.colours, scene.settings, parameters["source"], scene.polar, arrays["path"],
        context_of(scene, parameters["y"], parameters["x"]), parameters["halved"], line, costs,
        steps,
    )  # fmt: skip
    inside = costs[None, :, 1:-1].copy()
    arrivals = np.zeros_like(inside[:, 0])
    _, paths, cost = best_cuts(passes, inside, steps[None, :, 1:-1].copy(), 1, arrivals)
    return {"costs": inside[0], "shifts": paths[0] - parameters["max_shift"], "cost": cost[0]}


def _raster(_, parameters, arrays):
    scene = scene_of(parameters, arrays)
    patch = np.empty(scene.polar.half_width.size**2, np.int32)
    rasterize(
        parameters["source"], scene.settings, scene.polar, arrays["path"],
        arrays.get("shifts", arrays["path"]), arrays.get("powers", patch).astype(np.int32),
        "shifts" in arrays, scene.sources.clearance,
        context_of(scene, parameters["y"], parameters["x"]), patch,
    )  # fmt: skip
    return {"patch": patch}


def _change(_, parameters, arrays):
    texture, sources, _, settings = scene_of(parameters, arrays)
    patch, half_width = arrays["patch"], half_widths(settings.radius)
    place = parameters["y"], parameters["x"]
    change = cost_change(texture, sources, settings, *place, half_width, patch)
    inner = inner_cost(patch, half_width, sources.colours, settings)
    write_patch(texture, sources, settings, *place, half_width, patch)
    written = {name: getattr(texture, name) for name in ("addresses", "seams_x", "seams_y")}
    return written | {"change": np.int64(change), "inner": np.int64(inner)}


STAGES = {
    "white_noise": Stage(_white_noise),
    "grid": Stage(_grid),
    "exemplars": Stage(_exemplars),
    "seams": Stage(_seams),
    "guide_costs": Stage(_guide_costs),
    "candidates": Stage(_candidates),
    "costs": Stage(_costs),
    "cut": Stage(_cut, ("upload", "zeros", "download", "best_cuts")),
    "closed_cut": Stage(_closed_cut, ("upload", "zeros", "download", "best_cuts")),
    "alignment": Stage(_alignment, ("upload", "zeros", "download", "best_cuts")),
    "raster": Stage(_raster),
    "change": Stage(_change),
}
