"""The cases of views between others: awkward inputs, and the library's output for them."""

from collections.abc import Iterator

import numpy as np

from oracle.cases import Case
from oracle.families import INTERPOLATION
from oracle.stages import run_case
from stylit_ref.views.interpolation import passes
from stylit_ref.views.interpolation.camera import Camera

SIZE = 9, 12
_CAMERA = Camera((0.3, 1.2, 4.0), (0.1, 0.4, 0.0), 35.0)
_TOLERANCES = {
    "transfer": {"seen": 1e-5}, "rasterize": {"inverse": 1e-9}, "splat": {"inverse": 1e-9},
}  # fmt: skip


def interpolation_cases(version: str) -> Iterator[Case]:
    """Every case of the newest version, with its expected output."""
    for stage, name, parameters, arrays in _inputs():
        expected = run_case(INTERPOLATION, stage, parameters, arrays, passes)
        section = INTERPOLATION.sections[stage]
        tolerances = _TOLERANCES.get(stage, {})
        yield Case(version, stage, name, section, parameters, tolerances, arrays, expected)


def _inputs():
    rng = np.random.default_rng(2020)
    yield from _places()
    yield from _cameras(rng)
    yield from _scenes(rng)
    yield from _shifts(rng)
    yield from _votes(rng)
    yield from _mixes(rng)
    yield from _frames(rng)


def _places():
    even, uneven, three = [20, 25, 30], [20, 25, 32], [8, 13, 18]
    for name, columns, rows, ring, place, band in (
        ("inside", even, three, False, [-1.25, 1.5], 0.4),
        ("uneven", uneven, three, False, [3.5, -2.0], 0.4),
        ("on_a_view", even, three, False, [0, 0], 0.4),
        ("last", even, three, False, [5, 5], 0.4),
        ("tie", even, three, False, [2.5, -2.5], 0.4),
        ("without_band", even, three, False, [2.5, -2.5], 0.0),
        ("whole_band", even, three, False, [1.0, -4.0], 1.0),
        ("row", even, [7], False, [-4, 0], 0.4),
        ("column", [7], three, False, [0, 1.2], 0.4),
        ("ring", [0, 90, 200], [0], True, [-10, 0], 0.4),
        ("around_twice", [0, 90, 200], [0, 10], True, [740, -3], 0.4),
    ):
        parameters = {"columns": columns, "rows": rows, "is_ring": ring}
        yield "around", name, parameters | {"place": place, "band": band}, {}


def _cameras(rng):
    for name, other in (
        ("turned", Camera((0.9, 1.4, 4.1), (0.1, 0.4, 0.0), 35.0)),
        ("same", _CAMERA),
        ("lens", Camera((0.3, 1.2, 4.0), (0.1, 0.4, 0.0), 50.0, (0.1, 1, 0), (0.2, -0.1), 1.5)),
        ("behind", Camera((0.3, 1.2, -4.0), (0.1, 0.4, -9.0), 35.0)),
    ):
        inverse = rng.uniform(0.15, 0.6, SIZE)
        inverse[:2] = 0
        matrices = {"camera": _CAMERA.matrix(SIZE), "other": other.matrix(SIZE)}
        yield "transfer", name, {}, {"inverse": inverse} | matrices


def _scenes(rng):
    ground = np.array([[[-9, -0.5, 9], [9, -0.5, 9], [0, -0.5, -9]]], np.float64)
    triangles = rng.uniform(-1.5, 1.5, (6, 3, 3))
    for name, corners, near in (
        ("triangles", triangles, 0.05),
        ("ground", np.concatenate([triangles, ground]), 0.05),
        ("near", np.concatenate([triangles, ground]), 3.5),
        ("equal", np.concatenate([ground, ground]), 0.05),
        ("edge_on", np.array([[_CAMERA.origin, (0, 0, 0), (1, 0, 0)]]), 0.05),
        ("nothing", np.array([[(0, 1, 9), (1, 1, 9), (0, 2, 9.0)]]), 0.05),
    ):
        parameters = {"height": SIZE[0], "width": SIZE[1], "near": near}
        yield "rasterize", name, parameters, {"corners": corners, "camera": _CAMERA.matrix(SIZE)}
    for name, views, empty in (("one", 1, 0.1), ("three", 3, 0.5)):
        points = rng.uniform(-1.2, 1.2, (views, *SIZE, 3)).astype(np.float32)
        points[0, 0, 0], points[-1, 0, 1] = np.nan, (0.3, 1.2, 9.0)
        labels = rng.integers(0, 5, (views, *SIZE), np.int32)
        labels[rng.random(labels.shape) < empty] = -1
        arrays = {"points": points, "labels": labels, "camera": _CAMERA.matrix(SIZE)}
        yield "splat", name, {}, arrays


def _shifting(rng, views, longest=3.0, faces=2):
    """Motion with halves and with vectors that lead nowhere, labels and silhouettes."""
    motion = np.round(rng.normal(0, longest, (views, *SIZE, 2)) * 4).astype(np.float32) / 4
    motion[rng.random(motion.shape[:3]) < 0.1] = np.inf
    motion[0, 4, 5] = np.nan
    beside = np.stack(np.mgrid[: SIZE[0], : SIZE[1]], axis=-1).astype(np.int32)
    beside[::3, ::2] = rng.integers(0, SIZE[0], beside[::3, ::2].shape)
    return {
        "motion": motion,
        "labels": rng.integers(-1, faces, SIZE, np.int32),
        "beside": beside,
        "view_labels": rng.integers(-1, faces, (views, *SIZE), np.int32),
    }


def _shown(rng, views, masked):
    places = np.stack([rng.integers(0, side, (views, *SIZE)) for side in SIZE], axis=-1)
    return {"places": places.astype(np.int32), "masked": rng.random((views, *SIZE)) < masked}


def _nnfs(rng, count, style_size, radius):
    last = np.array(style_size) - radius
    return rng.integers(radius, last, (count, *SIZE, 2), np.int32)


def _shifts(rng):
    for name, views, longest in (("four", 4, 3.0), ("two", 2, 1.0), ("far", 4, 30.0)):
        yield "shift", name, {}, _shifting(rng, views, longest)
    for name, views, masked in (("four", 4, 0.5), ("two", 2, 0.7), ("none", 4, 1.0)):
        arrays = {"nnfs": _nnfs(rng, views, (14, 17), 2)} | _shown(rng, views, masked)
        yield "fetch", name, {}, arrays


def _style(rng, channels):
    style = rng.integers(0, 256, (14, 17, channels), np.uint8)
    style[:5] = 255 * (style[:5] > 127)
    return style


def _votes(rng):
    for name, channels, width in (("five", 3, 5), ("three", 4, 3), ("grey", 1, 5)):
        style = _style(rng, channels)
        nnf, *candidates = _nnfs(rng, 5, style.shape[:2], width // 2)
        arrays = {"style": style, "nnf": nnf}
        yield "vote", name, {"patch_width": width}, arrays
        candidates = np.array(candidates)
        candidates[1] = nnf
        candidates[rng.random(candidates.shape[:3]) < 0.4] = -1
        picture = rng.integers(0, 256, (*SIZE, channels), np.uint8)
        more = {"candidates": candidates, "picture": picture}
        yield "search", name, {"patch_width": width}, arrays | more
    flat = np.full((14, 17, 3), 200, np.uint8)
    nnf, *candidates = _nnfs(rng, 3, (14, 17), 2)
    arrays = {"style": flat, "nnf": nnf, "candidates": np.array(candidates)}
    arrays |= {"picture": np.full((*SIZE, 3), 200, np.uint8)}
    yield "search", "equal", {"patch_width": 5}, arrays
    yield "vote", "widest", {"patch_width": 15}, {
        "style": np.full((17, 17, 3), 255, np.uint8), "nnf": _nnfs(rng, 1, (17, 17), 7)[0],
    }  # fmt: skip


def _mixes(rng):
    for name, weights in (
        ("halves", [32768, 32768]), ("four", [40000, 20000, 5000, 536]), ("one", [65536, 0, 0, 0]),
    ):  # fmt: skip
        pictures = rng.integers(0, 256, (len(weights), *SIZE, 3), np.uint8)
        arrays = {"pictures": pictures, "weights": np.array(weights, np.int64)}
        yield "mix", name, {}, arrays
        yield "mix_shifted", name, {}, arrays | _shown(rng, len(weights), 0.5)


def _frames(rng):
    for name, weights in (
        ("limited", [65536, 0, 0, 0]), ("fading", [40000, 25536, 0, 0]),
        ("middle", [16384, 16384, 16384, 16384]), ("row", [45000, 20536]),
    ):  # fmt: skip
        style = _style(rng, 3)
        arrays = _shifting(rng, len(weights), 1.5)
        arrays |= {"style": style, "nnfs": _nnfs(rng, len(weights), style.shape[:2], 2)}
        yield "frame", name, {"patch_width": 5, "weights": weights}, arrays
