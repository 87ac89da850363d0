"""The cases of the real-time method: awkward inputs, and the library's output for them."""

from collections.abc import Iterator

import numpy as np

from oracle.cases import Case
from oracle.families import REALTIME
from oracle.make.realtime_packing import packings
from oracle.make.realtime_scene import PLACE, SEED, Scene, centres, noise, things
from oracle.stages import run_case
from stylit_ref.realtime import passes
from stylit_ref.realtime.params import REALTIME_PRESETS

CONTRAST = {
    "contrast": True, "channels": 10, "mu": 8,
    "guide_weights": [128, 127, 128, 128, 1, 128, 128, 128, 128, 128],
}  # fmt: skip
"""Weights and differences that are hardly allowed."""

ENERGIES = {
    "sums": {},
    "means": {"terms": "means"},
    "guides_alone": {"mu": 0},
    "style_alone": {"mu": 16},
    "sums_weighed": {"mu": 7, "guide_weights": [3, 0, 5]},
    "means_weighed": {"mu": 8, "guide_weights": [3, 0, 5], "terms": "means"},
    "no_weight": {"mu": 8, "guide_weights": [0, 0, 0]},
    "ten_channels": {"channels": 10, "patch_width": 3},
    "mip_3": {"scale_space": True, "depth": 3},
    "mip_4": {"scale_space": True, "depth": 4, "mu": 16, "source": (17, 19)},
    "box_3": {"scale_space": True, "depth": 3, "means": "box", "mu": 0},
    "box_2": {"scale_space": True, "means": "box", "terms": "means"},
    "small_source": {"source": (3, 4)},
    "small_target": {"target": (2, 3)},
    "one_pixel": {"source": (1, 1), "target": (1, 1)},
    "wide_7": {"patch_width": 7, "spacing": 6, "channels": 1},
    "contrast": CONTRAST,
}
"""How the level of each case of the energy differs from the plain one."""

SEARCHES = {
    "sums": ({}, {}),
    "means": ({"terms": "means"}, {"half": 1}),
    "guides_alone": ({"mu": 0}, {}),
    "style_alone": ({"mu": 16}, {}),
    "means_weighed": ({"mu": 8, "guide_weights": [3, 0, 5], "terms": "means"}, {}),
    "second_half": ({}, {"half": 1}),
    "late": ({}, {"iteration": 999, "level": 11, "seed": (1 << 64) - 1}),
    "mip_3": ({"scale_space": True, "depth": 3}, {}),
    "box_3": ({"scale_space": True, "depth": 3, "means": "box", "mu": 0}, {"half": 1}),
    "mip_4": ({"scale_space": True, "depth": 4, "mu": 16, "source": (17, 19)}, {}),
    "small_source": ({"source": (3, 7)}, {}),
    "small_target": ({"target": (2, 3)}, {}),
    "one_pixel": ({"source": (1, 1), "target": (1, 1)}, {"radius": 0}),
    "one_row": ({"source": (1, 12), "target": (1, 20)}, {}),
    "one_column": ({"source": (11, 1), "target": (14, 1)}, {"half": 1}),
    "wide_7": ({"patch_width": 7, "spacing": 6, "channels": 1}, {}),
    "labels": ({"labels": True}, {}),
    "wrong_label": ({"labels": True, "source": (12, 13)}, {"radius": 0}),
    "contrast": (CONTRAST, {}),
    "ties": ({"constant": True}, {}),
    "equal_candidates": (
        {"constant": True, "blemish": True, "source": (9, 24), "target": (15, 16)},
        {},
    ),
    "no_radius": ({}, {"radius": 0}),
    "radius_1": ({}, {"radius": 1}),
    "radius_29": ({"source": (31, 7), "patch_width": 3}, {"radius": 29}),
}
"""How level and place of each half iteration differ from the plain ones."""

FRAMES = {
    "best": {},
    "quick": {"preset": "quick"},
    "simple": {"preset": "simple", "levels": 6, "seed": 3},
    "optimized": {"preset": "optimized", "levels": 5, "depth": 3},
    "box_means": {"preset": "optimized", "means": "box", "depth": 2, "levels": 3},
    "bilinear": {"start": "bilinear"},
    "one_level": {"levels": 1},
    "labels": {"labelled": True, "source": (14, 15), "target": (15, 17)},
    "wide_patch": {"patch_width": 7, "spacing": 6, "terms": "means", "channels": 1},
    "no_iterations": {"iterations": (1, 0, 2)},
    "seed": {"seed": (1 << 64) - 5, "radii": (3,), "guide_weights": [2, 0, 1]},
    "guides_only": {"mu": (0,), "iterations": (1,)},
    "no_weight": {
        "guide_weights": [0, 0, 0],
        "mu": (1,),
        "iterations": (4,),
        "levels": 2,
        "source": (17, 19),
    },
    "one_pixel": {"source": (1, 1), "target": (1, 1), "levels": 2},
    "one_row": {"source": (1, 9), "target": (1, 21), "levels": 3},
    "small_source": {"source": (4, 3), "target": (13, 16), "levels": 2},
    "small_target": {"source": (16, 13), "target": (3, 4), "levels": 2},
}
"""How each whole frame differs from that of ``best``."""

DENSE = {
    "sums": {},
    "means_weighed": {"mu": 8, "guide_weights": [3, 0, 5], "terms": "means"},
    "guides_alone": {"mu": 0},
    "style_alone": {"mu": 16},
    "labels": {"labels": True, "target": (14, 17)},
    "wrong_label": {"labels": True, "source": (12, 13), "target": (11, 12)},
    "ties": {"constant": True},
    "wide_7": {"patch_width": 7, "spacing": 4, "channels": 1},
    "small_source": {"source": (3, 4)},
    "small_target": {"target": (2, 3)},
    "one_pixel": {"source": (1, 1), "target": (1, 1)},
    "contrast": CONTRAST,
}
"""How the level of each dense NNF differs from the plain one."""

FINISHES = "best", "quick", "labels", "no_weight", "one_row"

RENEWALS = {
    "plain": {},
    "labels": {"labelled": True, "source": (14, 15), "target": (15, 17)},
    "level_2": {"renewal_level": 2, "source": (20, 23), "target": (28, 26)},
    "weighed": {"guide_weights": [3, 0, 5]},
    "mip_3": {"scale_space": True, "depth": 3},
    "box_2": {"scale_space": True, "depth": 2, "means": "box"},
    "wide_patch": {"patch_width": 7, "spacing": 6, "channels": 1},
    "small_source": {"source": (4, 3), "target": (13, 16)},
    "one_row": {"source": (1, 9), "target": (1, 21)},
    "four_times": {"even": True, "source": (11, 60), "target": (24, 28)},
}
"""How the images of each renewal differ from the plain ones."""

TURNED = {"source": (20, 30), "target": (24, 30), "levels": 4, "warm_radius": 1}

WARM = {
    **{name: FRAMES[name] for name in ("best", "quick", "optimized", "bilinear", "labels")},
    "one_level": FRAMES["one_level"],
    **{f"turned_{n}": TURNED | {"iterations": (1, n), "warm_iterations": 0} for n in (2, 3)},
    "not_renewed": {"renewal_level": 0},
    "unread_guides": {"mu": (16,)},
    "held_back": {"warm_mu": 9, "warm_radius": 2, "warm_iterations": 1},
    "style_alone": {"warm_mu": 16, "warm_radius": 0},
    **{f"settled_{n}": TURNED | {"warm_iterations": n} for n in (2, 5)},
    "settled_optimized": TURNED | FRAMES["optimized"],
    "settled_labels": TURNED | FRAMES["labels"] | {"levels": 3},
}
"""How each warm frame differs from that of ``best``. The target moves a little, or turns around."""

STROKES = "best", "quick", "simple", "guides_only"


def realtime_cases(version: str) -> Iterator[Case]:
    """Every case of the newest version, with its expected output."""
    for stage, name, parameters, arrays in _inputs():
        expected = answer(stage, parameters, arrays)
        section = REALTIME.sections[stage]
        yield Case(version, stage, name, section, parameters, {}, arrays, expected)


def answer(stage: str, parameters: dict, arrays: dict) -> dict:
    """The expected arrays of a case of the stage."""
    return run_case(REALTIME, stage, parameters, arrays, passes)


def _inputs():
    rng = np.random.default_rng(2017)
    yield from packings(rng)
    yield from _levels(rng)
    yield from _starts(rng)
    yield from _weights()
    yield from _records(rng)
    for number, (name, differences) in enumerate(ENERGIES.items()):
        scene = Scene(number, **differences)
        yield "energy", name, scene.parameters, scene.arrays
    for number, (name, (differences, place)) in enumerate(SEARCHES.items()):
        scene = Scene(100 + number, **differences)
        yield "search", name, scene.parameters | PLACE | {"radius": 5} | place, scene.arrays
    scene = Scene(150, labels=True)
    lost = scene.arrays["target_labels"]
    lost[:4, :7] = 9
    scene.arrays["source_labels"][0, 0] = 9
    yield "search", "labels_lost", scene.parameters | PLACE | {"radius": 5}, scene.arrays
    yield from _blends()
    yield from _upsampling(rng)
    for number, name in enumerate(FRAMES):
        yield "frame", name, *_frame(200 + number, **FRAMES[name])
    for number, (name, differences) in enumerate(RENEWALS.items()):
        yield "renew", name, *_renewal(900 + number, **differences)
    for number, (name, differences) in enumerate(WARM.items()):
        usual = {
            "renewal_level": 2, "warm_mu": 4, "warm_radius": 8, "warm_iterations": 3,
        }  # fmt: skip
        parameters, arrays = _frame(300 + number, **usual | differences)
        turns = name.startswith(("turned", "settled"))
        if turns:  # two halves, which change places
            for side in ("source_guides", "target_guides"):
                arrays[side] = arrays[side] % 9
                arrays[side][:, : arrays[side].shape[1] // 2] += 200
        before = answer("frame", parameters, arrays)
        if turns:
            arrays["target_guides"] = arrays["target_guides"][:, ::-1]
        sides = [name for name in arrays if name.startswith("target")]
        arrays |= {side: np.roll(arrays[side], 1, axis=1) for side in sides}
        arrays["nnf"] = before["nnf"]
        yield "warm_frame", name, parameters, arrays
    for number, (name, differences) in enumerate(DENSE.items()):
        scene = Scene(700 + number, **differences)
        yield "dense_nnf", name, scene.parameters, scene.arrays
    yield from _votes()
    for number, name in enumerate(FINISHES):
        parameters, arrays = _frame(800 + number, **FRAMES[name])
        nnf = answer("frame", parameters, arrays)["nnf"]
        yield "finish", name, parameters, arrays | {"nnf": nnf}
    for number, name in enumerate(STROKES):
        parameters, arrays = _frame(400 + number, **FRAMES[name])
        stroke = arrays["source_style"].copy()
        stroke[3:6, 2:9] = (250, 20, 60)
        yield "stroke", name, parameters, arrays | {"new_style": stroke}


def _levels(rng):
    for name, size, channels in (
        ("even", (6, 8), 3),
        ("odd", (7, 5), 3),
        ("one_pixel", (1, 1), 1),
        ("one_row", (1, 10), 2),
        ("one_column", (9, 1), 3),
        ("ten_channels", (5, 6), 10),
    ):
        yield "halve", name, {}, {"image": noise(rng, size, channels)}
    halves = rng.integers(0, 2, (8, 12, 3), dtype=np.uint8)
    yield "halve", "halves", {}, {"image": halves}
    for name, size, patch_width, spacing, level in (
        ("level_0", (13, 14), 5, 3, 0),
        ("level_2", (29, 31), 3, 2, 2),
        ("one_pixel", (1, 1), 5, 3, 1),
        ("wide_7", (26, 33), 7, 6, 1),
    ):
        arrays = {"source_labels": things(rng, size), "target_labels": things(rng, size[::-1])}
        arrays["target_labels"] = np.minimum(arrays["target_labels"], arrays["source_labels"].max())
        numbers = {"patch_width": patch_width, "spacing": spacing, "level": level}
        yield "entry_labels", name, numbers, arrays
    numbers = {"patch_width": 5, "spacing": 3, "level": 1}
    for name in ("lost", "at_the_edge"):
        source, target = np.ones((2, 20, 23), np.uint8)
        if name == "lost":
            source[9, 9:15:2] = 7
        else:
            source[:] = 7
            source[4:16, 4:20] = 1  # all that has a centre on level 1
        target[4:11, 5:15] = 7
        arrays = {"source_labels": source, "target_labels": target}
        yield "entry_labels", name, numbers, arrays


def _starts(rng):
    for name, grid, source, patch_width, place in (
        ("plain", (5, 7), (20, 31), 5, {"seed": SEED, "level": 5}),
        ("small_source", (4, 3), (3, 4), 7, {"seed": 1, "level": 0}),
        ("one_pixel", (1, 1), (1, 1), 5, {"seed": 0, "level": 3}),
        ("huge_source", (6, 8), (32767, 32767), 3, {"seed": SEED, "level": 0}),
        ("largest", (4, 4), (300, 20), 13, {"seed": (1 << 64) - 1, "level": 11}),
    ):
        sizes = dict(zip(("rows", "columns"), grid, strict=True))
        sizes |= dict(zip(("source_height", "source_width"), source, strict=True))
        yield "random_nnf", name, sizes | {"patch_width": patch_width} | place, {}


def _weights():
    for name, mu, terms, weights in (
        ("sums", 4, "sums", [1, 1, 1, 1]),
        ("means", 4, "means", [1, 1, 1, 1]),
        ("guides_alone", 0, "means", [2, 4, 6]),
        ("style_alone", 16, "sums", [1, 1]),
        ("sums_weighed", 12, "sums", [3, 0, 9, 6]),
        ("means_weighed", 6, "means", [3, 0, 9, 6]),
        ("one_weighed", 6, "means", [0, 1]),
        ("no_weight", 0, "sums", [0, 0]),
        ("no_weight_means", 8, "means", [0, 0]),
    ):
        yield "weights", name, {"mu": mu, "terms": terms, "guide_weights": weights}, {}


def _records(rng):
    for name, size, channels, depth, means, spacing in (
        ("mip_1", (7, 8), 3, 1, "mip", 3),
        ("mip_2", (9, 11), 10, 2, "mip", 2),
        ("mip_4", (19, 23), 3, 4, "mip", 3),
        ("mip_3_source", (7, 9), 3, 3, "mip", 1),
        ("box_2", (9, 11), 10, 2, "box", 2),
        ("box_4", (31, 29), 1, 4, "box", 7),
        ("box_3_source", (7, 9), 3, 3, "box", 1),
        ("one_pixel", (1, 1), 2, 3, "mip", 3),
        ("one_row", (1, 13), 2, 3, "box", 3),
    ):
        numbers = {"depth": depth, "means": means, "spacing": spacing}
        yield "records", name, numbers, {"image": noise(rng, size, channels)}


def _blends():
    for number, (name, source, target, patch_width, spacing) in enumerate(
        (
            ("w_3", (9, 8), (11, 10), 3, 2),
            ("w_3_apart", (9, 8), (10, 11), 3, 3),
            ("w_5", (9, 12), (13, 11), 5, 3),
            ("w_5_apart", (9, 12), (14, 13), 5, 4),
            ("w_7", (9, 12), (13, 14), 7, 4),
            ("w_7_apart", (9, 12), (16, 15), 7, 6),
            ("w_9", (12, 11), (15, 14), 9, 5),
            ("w_11", (14, 13), (15, 17), 11, 6),
            ("w_13", (15, 16), (17, 18), 13, 7),
            ("w_13_apart", (15, 16), (26, 27), 13, 13),
            ("small_source", (2, 3), (9, 10), 5, 3),
            ("small_target", (9, 8), (2, 3), 5, 3),
            ("one_pixel", (1, 1), (1, 1), 7, 5),
            ("one_row", (8, 9), (1, 14), 5, 4),
            ("one_column", (8, 9), (13, 1), 5, 3),
        )
    ):
        scene = Scene(
            500 + number, source=source, target=target, patch_width=patch_width, spacing=spacing
        )
        numbers = {
            "patch_width": patch_width, "spacing": spacing, "height": target[0], "width": target[1],
        }  # fmt: skip
        arrays = {name: scene.arrays[name] for name in ("source_style", "nnf")}
        yield "blend", name, numbers, arrays


def _votes():
    for number, (name, source, target, patch_width) in enumerate(
        (
            ("plain", (9, 11), (10, 13), 5),
            ("wide_7", (9, 11), (10, 13), 7),
            ("small_source", (2, 3), (9, 10), 5),
            ("small_target", (9, 8), (2, 3), 5),
            ("one_pixel", (1, 1), (1, 1), 7),
            ("one_column", (8, 9), (13, 1), 3),
        )
    ):
        scene = Scene(750 + number, source=source, target=target, patch_width=patch_width)
        first, last = centres(source, patch_width)
        rng = np.random.default_rng(750 + number)
        dense = rng.integers(first, last + 1, (*target, 2)).astype(np.int32)
        arrays = {"source_style": scene.arrays["source_style"], "dense": dense}
        yield "vote", name, {"patch_width": patch_width}, arrays


def _upsampling(rng):
    for number, (name, coarse, grid, source, patch_width, spacing) in enumerate(
        (
            ("plain", (4, 5), (8, 9), (20, 23), 5, 3),
            ("wide_7", (3, 2), (5, 4), (17, 16), 7, 6),
            ("small_source", (3, 3), (6, 5), (4, 3), 5, 3),
            ("one_pixel", (1, 1), (1, 1), (1, 1), 5, 3),
            ("one_row", (1, 4), (1, 7), (12, 13), 3, 2),
        )
    ):
        half = tuple(-(-side // 2) for side in source)
        target = tuple(spacing * entries for entries in coarse)
        scene = Scene(
            600 + number, source=half, target=target, patch_width=patch_width, spacing=spacing
        )
        numbers = dict(zip(("rows", "columns"), grid, strict=True))
        numbers |= dict(zip(("source_height", "source_width"), source, strict=True))
        numbers |= {"patch_width": patch_width, "spacing": spacing}
        yield "upsample_nnf", name, numbers, {"nnf": scene.arrays["nnf"]}
    for name, coarse, size in (
        ("even", (4, 5), (8, 10)),
        ("odd", (4, 5), (7, 9)),
        ("one_pixel", (1, 1), (1, 1)),
        ("one_row", (1, 6), (1, 12)),
        ("one_column", (5, 1), (9, 1)),
    ):
        numbers = dict(zip(("height", "width"), size, strict=True))
        yield "upsample_picture", name, numbers, {"picture": noise(rng, coarse, 3)}


def _frame(
    number, source=(11, 12), target=(12, 14), channels=3, preset="best", labelled=False, **choices
):
    """Parameters and arrays of a whole frame; labels are large things, and one of a pixel."""
    rng = np.random.default_rng(number)
    chosen = {
        "patch_width": 5, "levels": 5, "mu": (4, 4, 4, 4, 0), "terms": "sums",
        "guide_weights": [1] * channels, "iterations": (1, 2), "radii": (4, 16, 32768),
        "start": "vote", "scale_space": False, "depth": 3, "means": "mip", "seed": SEED,
    }  # fmt: skip
    of_preset = REALTIME_PRESETS[preset]
    chosen |= {name: of_preset[name] for name in chosen if name in of_preset} | choices
    parameters = {"spacing": chosen["patch_width"] // 2 + 1} | {
        name: list(value) if isinstance(value, tuple) else value for name, value in chosen.items()
    }
    arrays = {
        "source_guides": noise(rng, source, channels),
        "source_style": noise(rng, source, 3),
        "target_guides": noise(rng, target, channels),
    }
    if labelled:
        for side, size in (("source", source), ("target", target)):
            labels = np.full(size, 1, np.uint8)
            labels[:, size[1] // 2 :] = 4
            labels[size[0] // 2 + 1, 3] = 200
            arrays[f"{side}_labels"] = labels
    return parameters, arrays


def _renewal(number, even=False, **choices):
    """Parameters and arrays of a renewal: both NNF are random, the fresh one is better at times."""
    parameters, arrays = _frame(number, **{"renewal_level": 1} | choices)
    del arrays["source_style"]
    level, width = parameters["renewal_level"], parameters["patch_width"]
    if even:  # matches differ from the target by 1, 2 or 3 everywhere: by 1, 4 or 9 times as much
        arrays["target_guides"][:] = 100
        arrays["source_guides"][:] = 101 + np.arange(60)[:, None] // 20
    rng = np.random.default_rng(number)
    for name, k in (("nnf", 0), ("fresh", level)):
        source, target = (
            [-(-side // (1 << k)) for side in arrays[f"{of}_guides"].shape[:2]]
            for of in ("source", "target")
        )
        first, last = centres(source, width)
        grid = [-(-side // parameters["spacing"]) for side in target]
        arrays[name] = rng.integers(first, last + 1, (*grid, 2)).astype(np.int32)
    names = "patch_width", "spacing", "terms", "guide_weights", "scale_space", "depth", "means"
    return {name: parameters[name] for name in (*names, "renewal_level")}, arrays
