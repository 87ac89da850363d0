"""The stages of coherence between frames (oracle/views/SPEC.md), up to those of an iteration."""

import numpy as np

from oracle.stages.stage import Stage
from stylit_ref.metric.packing import make_packing
from stylit_ref.views.formulae.depth import depth_of_things, inverse_depth
from stylit_ref.views.formulae.fold import ONE, fixed_weight
from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.between import motion_between
from stylit_ref.views.motion.composition import composed
from stylit_ref.views.motion.conventions import FrameMotion
from stylit_ref.views.motion.inversion import inverted, unhidden
from stylit_ref.views.motion.places import places_in_other
from stylit_ref.views.motion.silhouettes import along_silhouettes, silhouettes_of
from stylit_ref.views.packing import coherent_packing
from stylit_ref.views.params import PLAIN
from stylit_ref.views.plan import Plan


def _told(motion):
    """Motion as cases have it: a vector that leads nowhere is (0, 0) and not visible."""
    visible = places_in_other(motion)[:, :, 0] >= 0
    return {"field": np.where(visible[:, :, None], motion.field, np.float32(0)), "visible": visible}


def _motion(arrays):
    return Motion(arrays["field"], arrays["visible"])


def _places(passes, arrays, depth=0):
    height, width = arrays["visible"].shape
    places = np.empty((height >> depth, width >> depth, 2), np.int32)
    passes.shift_map(arrays["field"], arrays["visible"], depth, places)
    return places


def _shift_map(passes, parameters, arrays):
    return {"places": _places(passes, arrays, parameters["depth"])}


def _shift_picture(passes, parameters, arrays):
    guide = np.empty_like(arrays["own"])
    passes.shift_picture(arrays["picture"], arrays["places"], arrays["own"], guide)
    return {"guide": guide}


def _cancel(passes, parameters, arrays):
    cancels = np.empty(arrays["visible"].shape, np.bool_)
    places = _places(passes, arrays)
    passes.cancel(arrays["field"], places, arrays["back"], arrays["known"], cancels)
    return {"cancels": cancels}


def _compose(_, parameters, arrays):
    second = Motion(arrays["next_field"], arrays["next_visible"])
    return _told(composed(_motion(arrays), second))


def _splat(passes, parameters, arrays):
    size, places = arrays["visible"].shape, _places(passes, arrays)
    depth = arrays.get("depth", np.ones(size, np.float32))
    winners = np.empty((*size, 2), np.int32)
    passes.splat(arrays["field"], places, depth_of_things(depth), winners)
    beaten, contested = np.empty(size, np.bool_), np.empty(size, np.bool_)
    passes.find_beaten(arrays["field"], places, winners, beaten, contested)
    return {"winners": winners, "beaten": beaten, "contested": contested}


def _invert(_, parameters, arrays):
    return _told(inverted(_motion(arrays), arrays.get("depth")))


def _unhidden(_, parameters, arrays):
    return {"visible": unhidden(_motion(arrays), arrays.get("depth"))}


def _inverse(arrays):
    if "depth" in arrays:
        return inverse_depth(arrays["depth"])
    return (arrays["labels"] != 0).astype(np.float64)


def _rims(passes, parameters, arrays):
    inverse = _inverse(arrays)
    rims = np.empty(inverse.shape, np.bool_)
    passes.find_rims(inverse, rims)
    return {"rims": rims}


def _beside(passes, parameters, arrays):
    inverse, rims = _inverse(arrays), _rims(passes, parameters, arrays)["rims"]
    places = np.empty((*inverse.shape, 2), np.int32)
    passes.take_nearer(inverse, rims, np.ones_like(rims), parameters["reach"], places)
    return {"places": places}


def _along(_, parameters, arrays):
    here, there = (
        silhouettes_of(arrays.get(f"depth_{end}"), arrays.get(f"labels_{end}")) for end in (0, 1)
    )
    return _told(along_silhouettes(_motion(arrays), here, there))


def _between(_, parameters, arrays):
    def motion_of(frame):
        both = [
            Motion(arrays[f"{way}_{frame}"], arrays[f"{way}_shown_{frame}"])
            if f"{way}_{frame}" in arrays
            else None
            for way in ("forward", "backward")
        ]
        return FrameMotion(*both, tells_visible=parameters["tells_visible"])

    motion = motion_between(
        parameters["to"],
        parameters["other"],
        motion_of,
        depth_of=lambda frame: arrays.get(f"depth_{frame}"),
        labels_of=lambda frame: arrays.get(f"labels_{frame}"),
    )
    return _told(motion)


def _fold(passes, parameters, arrays):
    own = arrays["own"]
    mixed, spreads = np.empty_like(own), np.empty((*own.shape[:2], 1), np.uint8)
    passes.fold(own, arrays["guides"], arrays["weights"], mixed, spreads)
    return {"mixed": mixed, "spreads": spreads}


def _weights(_, parameters, arrays):
    packing = make_packing(
        parameters["guide_channels"], parameters["style_channels"], parameters["guide_influence"],
        parameters["guide_weights"],
    )  # fmt: skip
    style_weight = ONE
    if parameters["form"] == PLAIN:
        style_weight += parameters["neighbours"] * fixed_weight(parameters["coherence"])
    packing = coherent_packing(packing, style_weight, with_spread=parameters["spread"])
    used = [
        first + channel
        for first, size in zip(packing.guide_channels, packing.guide_sizes, strict=True)
        for channel in range(size)
    ]
    used += range(packing.style_channel, packing.style_channel + packing.style_channels)
    return {"weights": packing.weights[used]}


def _plan(_, parameters, arrays):
    neighbours, votes, order = (parameters[name] for name in ("neighbours", "votes", "order"))
    plan = Plan(neighbours, votes, order, parameters.get("following_votes"))
    tasks = list(plan.tasks())
    pulls = [(task, other) for task in tasks for other in plan.pulling(task)]
    return {
        "tasks": np.array(tasks, np.int32),
        "pulls": np.array(pulls, np.int32).reshape(-1, 2, 3),
    }


STAGES = {
    "shift_map": Stage(_shift_map, ("shift_map",)),
    "shift_picture": Stage(_shift_picture, ("shift_picture",)),
    "cancel": Stage(_cancel, ("shift_map", "cancel")),
    "compose": Stage(_compose),
    "splat": Stage(_splat, ("shift_map", "splat", "find_beaten")),
    "invert": Stage(_invert),
    "unhidden": Stage(_unhidden),
    "rims": Stage(_rims, ("find_rims",)),
    "beside": Stage(_beside, ("find_rims", "take_nearer")),
    "along": Stage(_along),
    "motion": Stage(_between),
    "fold": Stage(_fold, ("fold",)),
    "weights": Stage(_weights),
    "plan": Stage(_plan),
}
