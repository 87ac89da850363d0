"""Whole iterations and whole runs of texture synthesis."""

import numpy as np
from numba import get_num_threads

from oracle.stages.stage import Stage
from oracle.stages.texture import cells_of, numbered
from oracle.stages.texture_level import scene_of, stream_of
from stylit_ref.randomness.random_stream import PATCHES, WHITE_NOISE
from stylit_ref.texture.exemplars import make_exemplars, packed_planes
from stylit_ref.texture.passes.guide_costs import guide_costs
from stylit_ref.texture.passes.layout import make_workspace
from stylit_ref.texture.passes.placement import iterate
from stylit_ref.texture.passes.white_noise import white_noise

UNBENT = np.zeros(1, np.int32)
"""In the place of the table of powers, where nothing is deformed."""


def iterated(scene, parameters, powers):
    """Do an iteration; what became of the cells, and their changes."""
    texture, sources, polar, settings = scene
    height, width = texture.addresses.shape
    cells = cells_of(parameters | {"height": height, "width": width})
    patches = np.empty((len(cells), polar.radius_at.size), np.int32)
    outcomes, changes = (np.empty(len(cells), np.int64) for _ in range(2))
    work = make_workspace(polar, settings.max_jump, settings.max_shift, get_num_threads())
    iterate(
        texture, sources, polar, powers.astype(np.int32), settings, work,
        stream_of(parameters, PATCHES), cells, patches, outcomes, changes,
    )  # fmt: skip
    return outcomes, changes


def _iteration(_, parameters, arrays):
    scene = scene_of(parameters, arrays)
    outcomes, changes = iterated(scene, parameters, arrays.get("powers", UNBENT))
    names = "addresses", "seams_x", "seams_y"
    found = {name: getattr(scene.texture, name) for name in names}
    return found | {"outcomes": outcomes, "changes": np.where(outcomes >= 2, changes, 0)}


def _run(_, parameters, arrays):
    radius, fractions = parameters["radius"], parameters["fractions"]
    known = numbered(arrays, "known") or None
    images, guides = numbered(arrays, "image"), numbered(arrays, "source_guide")
    exemplars = make_exemplars(images, radius, known=known, fractions=fractions)
    addresses = np.empty((parameters["height"], parameters["width"]), np.int32)
    pixels = np.flatnonzero(exemplars.clearance).astype(np.int32)
    white_noise(addresses, pixels, stream_of(parameters, WHITE_NOISE))
    given = arrays | {
        "addresses": addresses,
        "colours": exemplars.colours,
        "valid": exemplars.clearance > 0,
    }
    if guides:
        given["guide_colours"] = packed_planes(guides, exemplars.border, fractions)
        guide = packed_planes([arrays["target_guide"]], 0, fractions=False)
        given["guide"] = guide.reshape(addresses.shape)
    scene = scene_of(parameters, given)
    texture = scene.texture
    total = int(texture.seams_x.sum(dtype=np.int64) + texture.seams_y.sum(dtype=np.int64))
    if guides:
        costs = np.empty(addresses.shape, np.int64)
        guide_costs(
            addresses, given["guide_colours"], given["guide"], parameters["guide_weight"], costs
        )
        total += int(costs.sum())
    totals = [total]
    for iteration in range(parameters["iterations"]):
        now = parameters | {"iteration": iteration}
        outcomes, changes = iterated(scene, now, arrays.get("powers", UNBENT))
        totals.append(totals[-1] + int(changes[outcomes >= 2].sum()))
    return {"addresses": texture.addresses, "totals": np.array(totals, np.int64)}


STAGES = {"iteration": Stage(_iteration), "run": Stage(_run)}
