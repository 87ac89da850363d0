"""The stages of views between others (oracle/interpolation/SPEC.md)."""

import numpy as np

from oracle.stages.stage import Stage
from stylit_ref.realtime.formulae.packed_nnf import entries_of, places_of
from stylit_ref.views.interpolation.axis import Axis
from stylit_ref.views.interpolation.formulae.transfer import plane_depths, transfer_of
from stylit_ref.views.interpolation.grid import Grid
from stylit_ref.views.interpolation.painting import make_style, pixels_of, search_among, vote

VOTE = "find_corners", "make_vote"


def _around(_, parameters, arrays):
    columns, rows = (tuple(map(float, parameters[name])) for name in ("columns", "rows"))
    axes = Axis(columns, is_ring=parameters["is_ring"]), Axis(rows)
    shape = len(parameters["rows"]), len(parameters["columns"])
    frames = np.arange(np.prod(shape)).reshape(shape).tolist()
    grid = Grid(*axes, tuple(map(tuple, frames)))
    around = grid.around(tuple(parameters["place"]), parameters["band"])
    return {name: np.array(found, np.int32) for name, found in around._asdict().items()}


def _transfer(passes, parameters, arrays):
    inverse = arrays["inverse"]
    motion = np.empty((1, *inverse.shape, 2), np.float32)
    passes.transfer(inverse, transfer_of(arrays["camera"], arrays["other"])[None], motion)
    y, x = np.mgrid[: inverse.shape[0], : inverse.shape[1]]
    return {"seen": np.stack([x, y], axis=-1) + motion[0].astype(np.float64)}


def _rasterize(passes, parameters, arrays):
    camera, corners = arrays["camera"], arrays["corners"]
    size, count = (parameters["height"], parameters["width"]), len(corners)
    polygons, counts = np.empty((count, 4, 2)), np.empty(count, np.int32)
    passes.clip(corners @ camera[:, :3].T + camera[:, 3], parameters["near"], polygons, counts)
    triangles, inverse = np.empty(size, np.int32), np.empty(size)
    passes.rasterize(polygons, counts, plane_depths(camera, corners), triangles, inverse)
    return {"triangles": triangles, "inverse": inverse}


def _splat(passes, parameters, arrays):
    points, labels = arrays["points"], arrays["labels"]
    size, views = labels.shape[1:], np.arange(len(labels))
    sparse, far = np.empty(size, np.int32), np.empty(size)
    passes.splat_points(points, labels, views, arrays["camera"], 0.0, sparse, far)
    found, inverse = np.empty_like(sparse), np.empty_like(far)
    passes.fill_holes(sparse, far, found, inverse)
    return {"found": found, "inverse": inverse}


def _shifted(passes, arrays):
    """Packed places of the views in their order."""
    places = np.empty(arrays["motion"].shape[:3], np.int32)
    passes.shift(
        arrays["motion"], arrays["labels"], arrays["beside"], arrays["view_labels"],
        np.arange(len(places)), places,
    )  # fmt: skip
    return places


def _shift(passes, parameters, arrays):
    places = _shifted(passes, arrays)
    return {"places": places_of(np.maximum(places, ~places)), "masked": places < 0}


def _packed_places(arrays):
    packed = entries_of(arrays["places"])
    return np.where(arrays["masked"], ~packed, packed).astype(np.int32)


def _fetched(passes, nnfs, places, order):
    candidates, nnf = np.empty_like(places), np.empty(places.shape[1:], np.int32)
    passes.fetch(nnfs, np.array(order), np.ascontiguousarray(places[order]), candidates, nnf)
    return candidates, nnf


def _fetch(passes, parameters, arrays):
    places = _packed_places(arrays)
    nnfs = entries_of(arrays["nnfs"])
    candidates, nnf = _fetched(passes, nnfs, places, list(range(len(places))))
    shown = np.where(candidates[..., None] < 0, -1, places_of(candidates)).astype(np.int32)
    return {"candidates": shown, "nnf": places_of(nnf)}


def _vote(passes, parameters, arrays):
    style = make_style(arrays["style"], parameters["patch_width"])
    picture = vote(style, entries_of(arrays["nnf"]), passes)
    return {"picture": pixels_of(picture, style.channels)}


def _search(passes, parameters, arrays):
    style = make_style(arrays["style"], parameters["patch_width"])
    nnf, candidates = (entries_of(arrays[name]) for name in ("nnf", "candidates"))
    border = style.patch_width // 2
    picture = make_style(np.pad(arrays["picture"], ((border,) * 2, (border,) * 2, (0, 0))), 1).image
    height, width = nnf.shape
    picture = picture._replace(border=border, height=height, width=width)
    return {"nnf": places_of(search_among(style, nnf, candidates, picture, passes))}


def _mix(passes, parameters, arrays):
    mixed = np.empty_like(arrays["pictures"][0])
    passes.mix(arrays["pictures"], arrays["weights"], mixed)
    return {"picture": mixed}


def _mix_shifted(passes, parameters, arrays):
    pictures, places = arrays["pictures"], _packed_places(arrays)
    mixed = np.empty_like(pictures[0])
    views = np.arange(len(places))
    passes.mix_shifted(pictures, views, places, arrays["weights"], mixed)
    return {"picture": mixed}


def _frame(passes, parameters, arrays):
    style = make_style(arrays["style"], parameters["patch_width"])
    places, nnfs = _shifted(passes, arrays), entries_of(arrays["nnfs"])
    weights = [weight for weight in parameters["weights"] if weight]
    frames = []
    for first, weight in enumerate(parameters["weights"]):
        if weight:
            order = [first, *(k for k in range(len(places)) if k != first)]
            candidates, nnf = _fetched(passes, nnfs, places, order)
            found = search_among(style, nnf, candidates, vote(style, nnf, passes), passes)
            frames.append(pixels_of(vote(style, found, passes), style.channels))
    mixed = np.empty_like(frames[0])
    passes.mix(np.stack(frames), np.array(weights), mixed)
    return {"picture": mixed}


STAGES = {
    "around": Stage(_around),
    "transfer": Stage(_transfer, ("transfer",)),
    "rasterize": Stage(_rasterize, ("clip", "rasterize")),
    "splat": Stage(_splat, ("splat_points", "fill_holes")),
    "shift": Stage(_shift, ("shift",)),
    "fetch": Stage(_fetch, ("fetch",)),
    "vote": Stage(_vote, VOTE),
    "search": Stage(_search, ("make_limited_search",)),
    "mix": Stage(_mix, ("mix",)),
    "mix_shifted": Stage(_mix_shifted, ("mix_shifted",)),
    "frame": Stage(_frame, ("shift", "fetch", *VOTE, "make_limited_search", "mix")),
}
