"""The cases of stylization: awkward inputs, and the library's output for them."""

from collections.abc import Iterator
from fractions import Fraction

import numpy as np

from oracle.cases import Case
from oracle.families import STYLIZATION
from oracle.make.answer import answer
from oracle.make.scene import PLACE, RUN, Scene, run_arrays
from oracle.make.stylit import stylit_inputs

LEVELS = {
    "plain": {},
    "one_channel": {
        "source": (15, 11), "target": (9, 19), "guide_channels": [1], "guide_weights": [1.0],
        "style_channels": 1, "patch_width": 3, "uniformity": 100000.0,
    },
    "four_channels": {
        "source": (16, 15), "target": (10, 12), "guide_channels": [1, 4],
        "guide_weights": [2.0, 0.5], "style_channels": 4, "patch_width": 7,
    },
    "barely_a_patch": {"source": (6, 5), "target": (5, 7)},
    "all_ties": {"constant": True},
    "equal_candidates": {"constant": True, "blemish": True, "uniformity": 0.0},
    "no_penalization": {"uniformity": 0.0},
    "extreme_weights": {
        "guide_weights": [98303.0, 1e-4], "guide_influence": 4.0, "contrast": True,
    },
    "ignored_guide": {"guide_weights": [0.0, 1.0]},
    "masked": {"masked": True, "smooth": True},
    "crowded": {"crowded": True, "smooth": True, "target": (17, 12)},  # radius 8 is the largest
}  # fmt: skip
"""How the level of each case differs from the plain one."""

WHOLE = "plain", "one_channel", "barely_a_patch", "masked", "crowded"
"""Cases of a whole level, which take long in a simulator."""

TOLERANCES = {"knee": {"x": 1e-12}}
"""Tolerances of the stages whose expected arrays need not be equal bit for bit."""


def stylization_cases(version: str) -> Iterator[Case]:
    """Every case of the newest version, with its expected output."""
    for stage, name, parameters, arrays in _inputs():
        expected = answer(stage, parameters, arrays)
        if stage in ("commit", "iteration") and not parameters["occurrence_weight"]:
            del expected["omega_sums"]
        tolerances = TOLERANCES.get(stage, {})
        section = STYLIZATION.sections[stage]
        yield Case(version, stage, name, section, parameters, tolerances, arrays, expected)


def _inputs():
    rng = np.random.default_rng(2026)
    words = rng.integers(0, 1 << 32, (64, 6), dtype=np.uint32)
    words[0], words[1] = 0, 0xFFFFFFFF
    yield "philox", "words", {}, {"counters": words[:, :4], "keys": words[:, 4:]}
    yield "commit_order", "first", PLACE, {}
    yield "commit_order", "largest", dict.fromkeys(PLACE, 65535) | {"seed": (1 << 64) - 1}, {}
    for name, size in (("even", (12, 16)), ("odd", (13, 7)), ("two_rows", (2, 9))):
        image = rng.integers(0, 256, (*size, 3), dtype=np.uint8)
        yield "downsample", name, {}, {"image": image}
    yield from _tied_weights()
    huge = {"patch_width": 5, "source_height": 65521, "source_width": 3000017}
    place = {"seed": PLACE["seed"], "level": PLACE["level"]}
    yield "random_nnf", "huge_source", huge | place, {"nnf": np.zeros((9, 8, 2), np.int32)}
    yield "commit", "rush", *_rush()
    yield "vote", "unheard", *_unheard()
    for number, (name, differences) in enumerate(LEVELS.items()):
        yield from _of_level(name, Scene(number, **differences))
    yield from _guide_maps()
    yield from _runs()
    yield from stylit_inputs(rng)


def _of_level(name, scene):
    yield "weights", name, scene.weighing, {}
    yield "random_nnf", name, scene.random, {"nnf": scene.start}
    yield "occurrence", name, scene.sizes, scene.only("nnf")
    yield "delta", name, scene.metric, scene.only("source", "target", "weights", "nnf")
    phi = {"occurrence_weight": scene.occurrence_weight}
    yield "phi", name, phi, scene.only("delta", "omega_sums", "nnf")
    finer = scene.sizes | {
        "source_height": 2 * scene.sizes["source_height"] + 1,
        "source_width": 2 * scene.sizes["source_width"],
    }
    height, width = scene.start.shape[:2]
    fine = np.zeros((2 * height + 1, 2 * width, 2), np.int32)
    fine[np.repeat(np.repeat(scene.start[:, :, 0] < 0, 2, 0), 2, 1).nonzero()] = -1
    coarse = np.abs(scene.arrays["nnf"])  # a coarser pixel takes part where any finer one does
    yield "upsample_nnf", name, finer, {"coarse_nnf": coarse, "nnf": fine}
    searched = scene.only("source", "target", "weights", "omega_sums", "nnf", "delta")
    for distance in (4, 2, 1):
        parameters = scene.search | {"distance": distance}
        yield "propagation", f"{name}_{distance}", parameters, searched
    yield "random_search", name, scene.search | PLACE, searched
    proposals = answer("random_search", scene.search | PLACE, searched)
    committed = scene.only("nnf", "delta", "omega_sums") | proposals
    yield "commit", name, scene.search | PLACE, committed
    yield "iteration", name, scene.search | PLACE, searched
    style = np.ascontiguousarray(scene.arrays["source"][:, :, scene.guide_channels :])
    for outliers in (0, 4):
        parameters = {"patch_width": scene.sizes["patch_width"], "outliers": outliers}
        voted = {"style": style, "nnf": scene.arrays["nnf"]}
        yield "vote", f"{name}_{outliers}", parameters, voted
    if name in WHOLE:
        guides = np.ascontiguousarray(scene.arrays["target"][:, :, : scene.guide_channels])
        whole = scene.only("source", "weights", "nnf") | {"target_guides": guides}
        counts = {"votes": 2, "iterations": 1, "seed": PLACE["seed"], "level": PLACE["level"]}
        yield "level", name, scene.search | counts, whole
    bounded = scene.only("source", "target", "weights", "nnf")
    yield "lower_bound", name, scene.metric, bounded


def _rush():
    """All pixels propose the same patch: how many get it shows when W is updated."""
    scene = Scene(300, uniformity=50000.0)
    arrays = scene.only("nnf", "delta", "omega_sums")
    proposed = {
        "proposed_nnf": np.full_like(scene.start, 4),
        "proposed_delta": scene.arrays["delta"] // 2,
    }
    return scene.search | PLACE, arrays | proposed


def _tied_weights():
    """Weights halfway between two integers, or so close that the order of products decides."""
    ties = [(k + 0.5) / 32768 for k in range(1, 9)]
    parameters = Scene(0).weighing | {"guide_weights": ties, "guide_channels": [1] * 8}
    yield "weights", "ties", parameters | {"guide_influence": 4.0}, {}
    near = [(k + 0.5) * 5 / 196608 for k in range(1, 100)]
    near = [g for g in near if round(65536 * (3 / 5) * g) != round(65536 * 3 * g / 5)][:5]
    parameters = parameters | {"guide_weights": near, "guide_channels": [1] * 5}
    yield "weights", "order_of_products", parameters | {"guide_influence": 3.0}, {}


def _unheard():
    """A target with pixels that no patch votes for."""
    scene = Scene(301, patch_width=3)
    nnf = scene.arrays["nnf"].copy()
    nnf[2:9, 3:8] = -1
    style = np.ascontiguousarray(scene.arrays["source"][:, :, :2])
    return {"patch_width": 3, "outliers": 0}, {"style": style, "nnf": nnf}


def _guide_maps():
    for number, (name, differences, choose) in enumerate(
        (
            ("some", {}, lambda variances: 500.0),
            ("none", {}, lambda variances: 0.0),
            ("all", {"patch_width": 3}, lambda variances: 1e9),
            ("seven", {"patch_width": 7, "source": (15, 16)}, np.median),
            ("exact", {"patch_width": 3, "target": (19, 18)}, _exact_variance),
            ("rounded", {}, _rounded_variance),
            ("ignored_guide", {"guide_weights": (0.0, 1.0)}, np.median),
        )
    ):
        scene = Scene(100 + number, smooth=True, **differences)
        arrays = scene.only("source", "target", "weights")
        whole = answer("guide_map", scene.metric | {"epsilon": 0.0}, arrays)
        parameters = scene.metric | {
            "epsilon": float(choose(whole["variances"] / scene.metric["patch_width"] ** 4))
        }
        yield "guide_map", name, parameters, arrays
        white = answer("guide_map", parameters, arrays)["white"]
        arrays = arrays | scene.only("nnf") | {"white": white}
        yield "white_delta", name, scene.metric, arrays


def _exact_variance(variances):
    """A variance that a double represents exactly, as ε: the patch is then black."""
    return next(v for v in np.sort(variances.ravel())[variances.size // 3 :] if v == int(v))


def _rounded_variance(variances):
    """A variance that rounds up to the double ε: it is below ε, though w⁴-folds round alike."""
    near = np.sort(variances.ravel())[variances.size // 3 :]
    return next(v for v in near if Fraction(v) > Fraction(round(v * 625), 625) and v * 625 % 1 == 0)


def _runs():
    plain = RUN | {"uniformity": 5000.0, "method": "ref", "epsilon": 0.0}
    small, large = ((13, 15), (14, 12)), ((22, 25), (24, 20))
    guide_map = {"method": "guide_map", "epsilon": 340.0, "patch_width": 5}
    for number, (name, differences, sizes, style_channels) in enumerate(
        (
            ("lambda_0", {"uniformity": 0.0, "guide_weights": [1.0, 0.5]}, small, 1),
            ("lambda_5000", {"patch_width": 5, "votes": 2}, large, 3),
            ("lambda_100000", {"uniformity": 100000.0, "seed": (1 << 63) + 5}, small, 4),
            ("one_level", {"levels": 1, "iterations": 2}, ((12, 15), (16, 11)), 3),
            ("wide_patch", {"patch_width": 7, "guide_weights": [0.0, 3.0]}, small, 2),
            ("small_source", {"guide_channels": [1, 2, 1]}, ((7, 8), (14, 12)), 3),
            ("small_target", {}, ((17, 15), (8, 7)), 3),
            ("masked", {"masked": True, "patch_width": 5}, ((20, 22), (21, 23)), 3),
            ("guide_map", guide_map, small, 3),
        )
    ):
        parameters = plain | differences
        if len(parameters["guide_channels"]) != len(parameters["guide_weights"]):
            parameters["guide_weights"] = [1.0] * len(parameters["guide_channels"])
        arrays = run_arrays(200 + number, sizes, parameters, style_channels)
        yield "run", name, parameters, arrays
