"""The cases of StyLit: sections 14 and 15 of SPEC.md."""

from fractions import Fraction

import numpy as np

from oracle.make.answer import answer
from oracle.make.scene import PLACE, RUN, Scene, run_arrays

SEARCH = {
    "seed": PLACE["seed"], "level": PLACE["level"], "vote": PLACE["vote"],
    "iterations": 2, "budget": 0.9, "fixed_share": 0.95, "error_limit": None,
}  # fmt: skip


def stylit_inputs(rng):
    """Stage, name, parameters and arrays of every case."""
    yield from _budgets(rng)
    yield from _knees(rng)
    for number, (name, differences) in enumerate(
        (
            ("plain", {}),
            ("small_source", {"source": (7, 9), "target": (19, 16)}),
            ("small_target", {"source": (19, 18), "target": (7, 9), "patch_width": 3}),
            ("masked", {"masked": True, "smooth": True}),
            ("all_ties", {"constant": True}),
        )
    ):
        scene = Scene(400 + number, uniformity=0.0, **differences)
        yield from _inversion(name, scene, rng)
        yield from _settlement(name, scene, rng)
    for name, differences, search in (
        ("plain", {}, {}),
        ("share_0.5", {"smooth": True}, {"budget": 0.5}),
        ("error_limit", {}, {"error_limit": 1.02}),
        ("one_retrieval", {"source": (17, 19)}, {"fixed_share": 0.1}),
        ("small_source", {"source": (7, 9), "target": (19, 16)}, {}),
        ("masked", {"masked": True, "smooth": True}, {}),
        ("all_ties", {"constant": True}, {}),
        ("equal_errors", {"constant": True, "blemish": True}, {"budget": 0.5}),
    ):
        scene = Scene(500, uniformity=0.0, **differences)
        arrays = scene.only("source", "target", "weights", "nnf", "delta")
        yield "stylit_search", name, scene.metric | SEARCH | search, arrays
    yield "stylit_search", "exact_share", *_exact_share()
    own = {"budget": 0.9, "fixed_share": 0.95, "error_limit": None}
    for number, (name, differences, sizes) in enumerate(
        (
            ("plain", {"patch_width": 5, "votes": 2}, ((22, 25), (24, 20))),
            ("limited", {"error_limit": 2.0, "budget": 0.7}, ((17, 15), (14, 12))),
            ("masked", {"masked": True}, ((13, 15), (15, 17))),
        )
    ):
        parameters = RUN | own | differences
        arrays = run_arrays(600 + number, sizes, parameters)
        yield "stylit_run", name, parameters, arrays


def _budgets(rng):
    errors = np.sort(rng.integers(0, 1 << 40, 200))
    for share in (0.5, 0.9, 1.0, 1e-9):
        yield "budget", f"share_{share:g}", {"share": share}, {"errors": errors}
    yield "budget", "rounded_sums", *_rounded_sums(rng)
    yield "budget", "all_zero", {"share": 0.9}, {"errors": np.zeros(5, np.int64)}


def _rounded_sums(rng):
    """A share that a running sum reaches or misses depending on how it was rounded."""
    errors = np.sort(rng.integers(1 << 50, 1 << 60, 200))
    spent = np.cumsum(errors.astype(np.float64))
    exact = [Fraction(int(sum(errors[: k + 1].tolist()))) for k in range(len(errors))]
    for k in range(len(errors)):
        share = spent[k] / spent[-1]
        within = [total <= Fraction(share) * exact[-1] for total in exact]
        if (spent <= share * spent[-1]).sum() != sum(within):
            return {"share": float(share)}, {"errors": errors}
    raise AssertionError("with these errors, rounding makes no difference")


def _exact_share():
    """The first retrieval fixes exactly the share that was asked for."""
    scene = Scene(500, uniformity=0.0)
    arrays = scene.only("source", "target", "weights", "nnf", "delta")
    found = answer("stylit_search", scene.metric | SEARCH, arrays)
    patches = arrays["delta"].size
    share = int(found["fixed_counts"][0]) / patches
    assert share * patches == found["fixed_counts"][0]
    return scene.metric | SEARCH | {"fixed_share": share}, arrays


def _knees(rng):
    ends = rng.uniform(0.5, 4, 20), rng.uniform(0.05, 0.45, 20)
    a = np.array([*ends[0], 1.0, 1.0])
    b = np.array([*(ends[0] - ends[1]), 0.0, 0.4])
    yield "knee", "ends", {}, {"a": a, "b": b}


def _random_claims(scene, rng):
    """Claims with errors of few values, so that many are equal."""
    source, target = (scene.arrays[name].shape[:2] for name in ("source", "target"))
    patches = tuple(side - scene.metric["patch_width"] + 1 for side in source)
    claims = np.stack([rng.integers(0, side, patches, dtype=np.int32) for side in target], axis=2)
    return {"claims": claims, "errors": rng.integers(1, 6, patches)}


def _inversion(name, scene, rng):
    given = scene.only("nnf") | _random_claims(scene, rng)
    delta = rng.integers(0, 6, scene.arrays["delta"].shape)
    given["delta"] = np.where(given["nnf"][:, :, 0] < 0, 0, delta)
    parameters = {"patch_width": scene.metric["patch_width"]}
    yield "invert_nnf", name, parameters, given


def _settlement(name, scene, rng):
    given = scene.only("nnf", "delta") | _random_claims(scene, rng)
    size = given["delta"].shape
    given["fixed"] = (rng.random(size) < 0.2) | (given["nnf"][:, :, 0] < 0)
    given["limits"] = rng.integers(2, 9, size)
    parameters = {
        "patch_width": scene.metric["patch_width"], "last_error": 4, "last_claims": 3,
    }  # fmt: skip
    yield "settle", name, parameters, given
