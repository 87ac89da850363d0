"""The cases of the newest version: awkward inputs, and what this library makes of them."""

import numpy as np

from oracle.cases import VERSIONS, Case
from oracle.scene import PLACE, RUN, Scene, run_arrays
from oracle.stages import run_case
from oracle.stylit_cases import stylit_inputs
from stylit_ref import passes

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
    "extreme_weights": {"guide_weights": [30000.0, 1e-4], "guide_influence": 4.0},
    "ignored_guide": {"guide_weights": [0.0, 1.0]},
    "masked": {"masked": True, "smooth": True},
    "crowded": {"crowded": True, "smooth": True, "target": (17, 12)},  # radius 8 is the largest
}  # fmt: skip
"""What differs from the plain level, by case."""


def cases():
    """Every case of the newest version, with what it must give.

    Yields
    ------
    Case
    """
    for stage, name, parameters, arrays, tolerances in _inputs():
        expected = run_case(stage, parameters, arrays, passes)
        if stage in ("commit", "iteration") and not parameters["occurrence_weight"]:
            del expected["omega_sums"]
        yield Case(VERSIONS[-1], stage, name, parameters, arrays, expected, tolerances)


def _inputs():
    rng = np.random.default_rng(2026)
    words = rng.integers(0, 1 << 32, (64, 6), dtype=np.uint32)
    words[0], words[1] = 0, 0xFFFFFFFF
    yield "philox", "words", {}, {"counters": words[:, :4], "keys": words[:, 4:]}, {}
    yield "commit_order", "first", PLACE, {}, {}
    yield "commit_order", "largest", dict.fromkeys(PLACE, 65535) | {"seed": (1 << 64) - 1}, {}, {}
    for name, size in (("even", (12, 16)), ("odd", (13, 7)), ("two_rows", (2, 9))):
        image = rng.integers(0, 256, (*size, 3), dtype=np.uint8)
        yield "downsample", name, {}, {"image": image}, {}
    yield "commit", "rush", *_rush(), {}
    for number, (name, differences) in enumerate(LEVELS.items()):
        yield from _of_level(name, Scene(number, **differences))
    yield from _guide_maps()
    yield from _runs()
    yield from stylit_inputs(rng)


def _of_level(name, scene):
    yield "weights", name, scene.weighing, {}, {}
    yield "random_nnf", name, scene.random, {"nnf": scene.start}, {}
    yield "occurrence", name, scene.sizes, scene.only("nnf"), {}
    yield "delta", name, scene.metric, scene.only("source", "target", "weights", "nnf"), {}
    phi = {"occurrence_weight": scene.occurrence_weight}
    yield "phi", name, phi, scene.only("delta", "omega_sums", "nnf"), {}
    finer = scene.sizes | {
        "source_height": 2 * scene.sizes["source_height"] + 1,
        "source_width": 2 * scene.sizes["source_width"],
    }
    height, width = scene.start.shape[:2]
    fine = np.zeros((2 * height + 1, 2 * width, 2), np.int32)
    fine[np.repeat(np.repeat(scene.start[:, :, 0] < 0, 2, 0), 2, 1).nonzero()] = -1
    coarse = np.abs(scene.arrays["nnf"])  # a coarser pixel takes part where any finer one does
    yield "upsample_nnf", name, finer, {"coarse_nnf": coarse, "nnf": fine}, {}
    searched = scene.only("source", "target", "weights", "omega_sums", "nnf", "delta")
    for distance in (4, 2, 1):
        parameters = scene.search | {"distance": distance}
        yield "propagation", f"{name}_{distance}", parameters, searched, {}
    yield "random_search", name, scene.search | PLACE, searched, {}
    proposals = run_case("random_search", scene.search | PLACE, searched, passes)
    committed = scene.only("nnf", "delta", "omega_sums") | proposals
    yield "commit", name, scene.search | PLACE, committed, {}
    yield "iteration", name, scene.search | PLACE, searched, {}
    style = np.ascontiguousarray(scene.arrays["source"][:, :, scene.guide_channels :])
    for outliers in (0, 4):
        parameters = {"patch_width": scene.sizes["patch_width"], "outliers": outliers}
        voted = {"style": style, "nnf": scene.arrays["nnf"]}
        yield "vote", f"{name}_{outliers}", parameters, voted, {}
    guides = np.ascontiguousarray(scene.arrays["target"][:, :, : scene.guide_channels])
    whole = scene.only("source", "weights", "nnf") | {"target_guides": guides}
    counts = {"votes": 2, "iterations": 1, "seed": PLACE["seed"], "level": PLACE["level"]}
    yield "level", name, scene.search | counts, whole, {}
    bounded = scene.only("source", "target", "weights", "nnf")
    yield "lower_bound", name, scene.metric, bounded, {}


def _rush():
    """Everyone wants to the same patch: how many get there says when W follows."""
    scene = Scene(300, uniformity=50000.0)
    arrays = scene.only("nnf", "delta", "omega_sums")
    proposed = {
        "proposed_nnf": np.full_like(scene.start, 4),
        "proposed_delta": scene.arrays["delta"] // 2,
    }
    return scene.search | PLACE, arrays | proposed


def _guide_maps():
    for number, (name, differences, epsilon) in enumerate(
        (
            ("some", {"smooth": True}, 150.0),
            ("none", {"smooth": True}, 0.0),
            ("all", {"smooth": True, "patch_width": 3}, 1e9),
            ("fraction", {"smooth": True, "patch_width": 7, "source": (15, 16)}, 137.7),
            ("ignored_guide", {"smooth": True, "guide_weights": (0.0, 1.0)}, 150.0),
        )
    ):
        scene = Scene(100 + number, **differences)
        arrays = scene.only("source", "target", "weights")
        parameters = scene.metric | {"epsilon": epsilon}
        yield "guide_map", name, parameters, arrays, {}
        white = run_case("guide_map", parameters, arrays, passes)["white"]
        arrays = arrays | scene.only("nnf") | {"white": white}
        yield "white_delta", name, scene.metric, arrays, {}


def _runs():
    plain = RUN | {"uniformity": 5000.0, "method": "ref", "epsilon": 0.0}
    small, large = ((13, 15), (14, 12)), ((22, 25), (24, 20))
    guide_map = {"method": "guide_map", "epsilon": 150.0, "patch_width": 5}
    for number, (name, differences, sizes) in enumerate(
        (
            ("lambda_0", {"uniformity": 0.0}, small),
            ("lambda_5000", {"patch_width": 5}, large),
            ("lambda_100000", {"uniformity": 100000.0}, small),
            ("one_level", {"levels": 1, "iterations": 2}, ((12, 15), (16, 11))),
            ("masked", {"masked": True}, small),
            ("guide_map", guide_map, small),
        )
    ):
        parameters = plain | differences
        yield "run", name, parameters, run_arrays(200 + number, sizes, parameters["masked"]), {}
