"""The cases of texture synthesis: awkward inputs, and the library's output for them."""

from collections.abc import Iterator

import numpy as np

from oracle.cases import Case
from oracle.families import TEXTURE
from oracle.make.texture_scene import (
    BENDING,
    COSTS,
    PLACE,
    POLAR,
    RASTER,
    STEPS,
    Patch,
    pictures,
)
from oracle.stages import run_case
from stylit_ref.texture import passes
from stylit_ref.texture.formulae.deformation import power_table as powers_of
from stylit_ref.texture.formulae.guide_cost import fixed_guide_weight
from stylit_ref.texture.passes.candidates import ring

HALVED = {"exponent": 3, "eta": 1, "split": True, "size": (13, 14)}
"""Seams that cost so much that costs are halved."""

PATCHES = {
    "plain": {},
    "one_channel": {"channels": 1, "exponent": 1, "radial_samples": 1.5},
    "cubed": {"exponent": 3, "eta": 1, "contrast": True},
    "printed": {"weighting": "printed", "max_jump": 1},
    "ray_ends": {"at_edge": True},
    "wraps": {"size": (8, 9)},
    "thin": {"size": (1, 11), "radius": 1},
    "locked": {"locked": True},
    "guided": {"guide_weight": 2.0},
    "locked_and_guided": {"locked": True, "guide_weight": 0.5, "at_edge": True},
    "quarters": {"fractions": True, "radius": 3, "images": ((6, 7),)},
    "several": {"images": ((13, 15), (10, 9)), "holes": True},
    "wide_patch": {"radius": 8, "angular_samples": 0.75, "radial_samples": 1.0, "max_jump": 3},
    "cubed_locked": {"exponent": 3, "eta": 1, "contrast": True, "locked": True},
    "halved": HALVED,
    "halved_locked": HALVED | {"locked": True},
    "halved_guided": HALVED | {"guide_weight": 10000.0},
}  # fmt: skip
"""How the patch of each case differs from the plain one."""

LIMITS = "new_limit", "existing_limit", "hidden_limit"

SHIFTED = "plain", "quarters", "locked", "wide_patch", "halved"
"""Patches whose features are aligned as well."""

RASTERED = *SHIFTED[:4], "one_channel", "ray_ends", "wraps", "thin", "several"
"""Patches whose raster is a case; the others are drawn as the plain one is."""

CHANGED = (
    "plain", "locked", "one_channel", "cubed", "wraps", "thin", "several", "guided",
    "locked_and_guided",
)  # fmt: skip
"""Patches that are written."""

ITERATED = {
    "plain": {},
    "unimproved": {"predicate": "none"},
    "before": {"predicate": "before", "second_pass": False},
    "after": {"predicate": "after", "max_shift": 2, "max_jump": 4},
    "tries": {"tries": 3, "prescreened": 2},
    "coherent": {"coherence": 40000},
}
"""Iterations of the plain patch."""

CHOICES = {
    "predicate": "exact", "second_pass": True, "prescreened": 4, "spread": 800, "coherence": 0,
    "tries": 1, "max_shift": 0, "penalty": 0,
}  # fmt: skip
"""What iterations and runs do by default."""

RUNS = {
    "plain": {},
    "one_channel": {"channels": 1, "predicate": "after", "second_pass": False, "prescreened": 1},
    "locked": {"locked": True, "coherence": 20000},
    "guided": {"guided": True},
    "several": {"images": ((13, 15), (10, 9)), "holes": True, "seed": (1 << 63) + 9},
    "quarters": {"fractions": True, "max_shift": 3, "penalty": 4, "radius": 3, "images": ((9, 8),)},
    "whole_pixels": {"max_shift": 3, "gamma": 0.5},
    "thin": {"size": (1, 11), "radius": 1},
}
"""Whole runs."""


def power_table(gamma):
    """The table of powers; two bytes hold it."""
    return powers_of(gamma).astype(np.uint16)


def texture_cases(version: str) -> Iterator[Case]:
    """Every case of the newest version, with its expected output."""
    for stage, name, parameters, arrays in _inputs():
        expected = answer(stage, parameters, arrays)
        section = TEXTURE.sections[stage]
        yield Case(version, stage, name, section, parameters, {}, arrays, expected)


def answer(stage: str, parameters: dict, arrays: dict) -> dict:
    """The expected arrays of a case of the stage."""
    return run_case(TEXTURE, stage, parameters, arrays, passes)


def _inputs():
    rng = np.random.default_rng(2012)
    pixels = np.sort(rng.choice(5000, 77, replace=False)).astype(np.int32)
    noise = {"height": 6, "width": 13, "seed": PLACE["seed"]}
    yield "white_noise", "plain", noise, {"pixels": pixels}
    yield "white_noise", "alone", noise | {"height": 1, "seed": (1 << 64) - 1}, {"pixels": pixels}
    for name, height, width, radius, iteration in (
        ("plain", 40, 53, 4, 5),
        ("one_cell", 8, 15, 4, 0),
        ("many", 64, 66, 3, 1),
        ("late", 70, 31, 5, 70000),
    ):
        size = {"height": height, "width": width, "radius": radius}
        yield "grid", name, size | {"seed": PLACE["seed"], "iteration": iteration}, {}
    yield from _exemplars(rng)
    yield "seams", "steep", *_steep(rng)
    yield from _cuts(rng)
    yield "closed_cut", "smallest", {"max_jump": 1, "second_pass": True}, _smallest()
    for number, (name, differences) in enumerate(PATCHES.items()):
        yield from _of_patch(name, Patch(number, **differences))
    for number, (name, differences) in enumerate(ITERATED.items()):
        yield "iteration", name, *_iteration(Patch(100 + number), **differences)
    yield "iteration", "settled", *_iteration(_settled(123), max_shift=2, prescreened=1)
    yield "iteration", "flat", *_iteration(Patch(120, flat=True))
    all_locked = Patch(121, locked=True)
    all_locked.arrays["lock"][:] = True
    yield "iteration", "all_locked", *_iteration(all_locked)
    yield "iteration", "locked", *_iteration(Patch(122, locked=True), tries=2, prescreened=1)
    tries = {"tries": 3, "prescreened": 1}
    yield "iteration", "halved_tries", *_iteration(Patch(171, **HALVED, locked=True), **tries)
    # Numbers with a patch that is accepted if but one term of the predicate is forgotten.
    after = {"predicate": "after", "max_shift": 3, "max_jump": 6, "prescreened": 1}
    yield "iteration", "settled_after", *_iteration(_settled(208), **after)
    after["max_jump"] = 4
    # And with one that is accepted though the table says no, or without its deformation.
    yield "iteration", "settled_exact", *_iteration(_settled(125), prescreened=1)
    yield "iteration", "undeformed_after", *_iteration(_settled(359), **after)
    yield "iteration", "halved_after", *_iteration(Patch(349, **HALVED, locked=True), **after)
    # Of a dozen numbers one in whose iteration a patch meets an edge that its neighbour changes.
    close = Patch(139, radius=2, size=(24, 24), radial_samples=4.0, images=((9, 9),))
    yield "iteration", "close", *_iteration(close, prescreened=1, predicate="none")
    for number, (name, differences) in enumerate(RUNS.items()):
        yield "run", name, *_run(200 + number, **differences)


def _exemplars(rng):
    for name, sizes, channels, radius, fractions, holes in (
        ("plain", ((7, 9),), 3, 4, False, False),
        ("one_channel", ((5, 6),), 1, 1, True, False),
        ("several", ((6, 9), (8, 5), (5, 5)), 3, 5, False, True),
        ("quarters", ((6, 5),), 3, 2, True, False),
    ):
        arrays = pictures(rng, sizes, channels, holes)
        yield "exemplars", name, {"radius": radius, "fractions": fractions}, arrays


def _steep(rng):
    """Smooth halves far apart: costs of 23 bits, where the rounding of each product shows."""
    image = rng.integers(0, 3, (6, 8, 3), dtype=np.uint8)
    image[:, 4:] += 45
    arrays = answer("exemplars", {"radius": 1, "fractions": False}, {"image_1": image})
    pixels = np.flatnonzero(arrays["clearance"])
    addresses = rng.choice(pixels, (9, 12)).astype(np.int32)
    parameters = {"stride": arrays["clearance"].shape[1], "eta": 400, "exponent": 3}
    return parameters, {"addresses": addresses, "colours": arrays["colours"]}


def _cuts(rng):
    """Tables of several patches, some of whose cuts are blocked."""
    blocked = (1 << 30) - 1
    for name, shape, max_jump, largest in (
        ("plain", (3, 14, 9), 4, 900),
        ("jump_1", (2, 12, 7), 1, 900),
        ("jump_16", (2, 10, 6), 16, 900),
        ("ties", (4, 15, 8), 2, 3),
        ("all_zero", (1, 9, 5), 2, 1),
        ("one_column", (2, 9, 1), 3, 50),
        ("arrivals", (3, 13, 9), 2, 900),
        ("blocked", (2, 11, 7), 2, 900),
        ("at_the_cap", (1, 9, 6), 1, 40_000_000),
    ):
        crossing = rng.integers(-(largest // 3), largest, shape, dtype=np.int32)
        steps = rng.integers(0, largest // 4 + 1, shape, dtype=np.int32).cumsum(2, dtype=np.int32)
        if name == "at_the_cap":
            crossing += 90_000_000
        if name == "blocked":
            crossing[0, 3:5, 2:], crossing[1, 6] = blocked, blocked
        arrays = {"crossing": crossing, "steps": steps}
        arrivals = np.zeros_like(crossing[:, 0])
        if name == "arrivals":
            arrivals[0], arrivals[1], arrivals[2] = blocked, 300 * np.arange(9), 2400
            arrivals[0, 4] = 0
        yield "cut", name, {"max_jump": max_jump}, arrays | {"arrivals": arrivals}
        for second_pass in (False, True):
            title = f"{name}_{1 + second_pass}"
            chosen = {"max_jump": max_jump, "second_pass": second_pass}
            yield "closed_cut", title, chosen, arrays


def _smallest():
    """Tables whose cheapest cut, column 0, the second pass does not reach."""
    rng = np.random.default_rng(1)
    while True:
        crossing = rng.integers(-300, 600, (1, 9, 6), dtype=np.int32)
        crossing[:, :, 0] = rng.integers(0, 60, 9)
        arrays = {"crossing": crossing, "steps": np.full((1, 9, 6), 40, np.int32).cumsum(2)}
        arrays["steps"] = arrays["steps"].astype(np.int32)
        one = {"max_jump": 1}
        arrivals = np.zeros_like(crossing[:, 0])
        ends = answer("cut", one, arrays | {"arrivals": arrivals})["totals"][:, -1]
        second = answer("cut", one, arrays | {"arrivals": ends - ends.min()})
        if crossing[:, :, 0].sum() < second["costs"][0]:
            return arrays


def _of_patch(name, patch):
    numbers = {key: patch.parameters[key] for key in ("eta", "exponent")}
    stride = {"stride": patch.arrays["valid"].shape[1]}
    if name in ("plain", "one_channel", "cubed", "wraps", "thin", "quarters"):
        yield "seams", name, numbers | stride, patch.only("addresses", "colours")
    if patch.parameters["guide_weight"]:
        weight = {"guide_weight": patch.parameters["guide_weight"]}
        given = patch.only("addresses", "guide_colours", "guide")
        yield "guide_costs", name, weight, given
    looked_at = patch.only("addresses", "colours", "valid", "guide", "guide_colours")
    looked_at |= {"ring": ring(patch.parameters["radius"]), "cells": patch.cells}
    chosen = {key: patch.parameters[key] for key in ("radius", "guide_weight")}
    if name == "guided":
        choice = {"prescreened": 5, "spread": 0, "coherence": 0, "attempt": 0}
        yield "candidates", "guided_best", chosen | PLACE | choice, looked_at
    if name in ("plain", "wraps", "several"):
        for title, choice in (
            ("random", {"prescreened": 1, "spread": 900, "coherence": 0, "attempt": 2}),
            ("best", {"prescreened": 5, "spread": 0, "coherence": 0, "attempt": 1}),
            ("priced", {"prescreened": 9, "spread": 3000, "coherence": 0, "attempt": 1}),
            ("coherent", {"prescreened": 5, "spread": 700, "coherence": 50000, "attempt": 0}),
        ):
            yield "candidates", f"{name}_{title}", chosen | PLACE | choice, looked_at
    placed = patch.parameters | patch.place
    seen = patch.only("addresses", "colours", "valid", "lock", "guide", "guide_colours")
    costed = seen | patch.only(*COSTS, *STEPS, "inside", "area", "border")
    yield "costs", name, placed, costed
    made = answer("costs", placed, costed)
    tables = {table: made[table][None] for table in ("crossing", "steps")}
    chosen = {"max_jump": patch.parameters["max_jump"], "second_pass": True}
    path = answer("closed_cut", chosen, tables)["paths"][0]
    drawn = patch.only("valid", "lock", *RASTER) | {"path": path}
    if name in RASTERED:
        yield "raster", name, placed, drawn
    if name in CHANGED:
        patched = seen | {"patch": answer("raster", placed, drawn)["patch"]}
        yield "change", name, placed, patched
    if name not in SHIFTED:
        return
    shifted = placed | {"max_shift": 3, "penalty": 5, "halved": int(made["halved"])}
    aligned = patch.only("addresses", "colours", "valid", "lock", *COSTS, *BENDING, "border")
    aligned |= {"path": path}
    yield "alignment", name, shifted, aligned
    if name not in RASTERED:
        return
    shifts = answer("alignment", shifted, aligned)["shifts"]
    bent = drawn | patch.only(*BENDING) | {"shifts": shifts, "powers": power_table(0.5)}
    yield "raster", f"{name}_deformed", placed, bent
    yield (
        "change",
        f"{name}_deformed",
        placed,
        seen | {"patch": answer("raster", placed, bent)["patch"]},
    )


def _iteration(patch, **differences):
    parameters = patch.parameters | PLACE | CHOICES | differences
    arrays = patch.arrays | {"ring": ring(parameters["radius"])}
    if parameters["max_shift"]:
        arrays["powers"] = power_table(1.0)
    return parameters, arrays


def _settled(number):
    """A patch over a texture after some iterations, few of whose patches are accepted."""
    patch = Patch(number)
    parameters, arrays = _run(number, iterations=9)
    size = {"height": 18, "width": 21}
    patch.arrays["addresses"] = answer("run", parameters | size, patch.pictures | arrays)[
        "addresses"
    ]
    return patch


def _run(
    number, images=((14, 15),), channels=3, holes=False, size=(17, 20), radius=4, locked=False,
    guided=False, gamma=1.0, **differences,
):  # fmt: skip
    patch = Patch(number, images=images, channels=channels, holes=holes, size=size, radius=radius)
    rng = np.random.default_rng(number)
    parameters = {
        name: patch.parameters[name] for name in ("radius", "max_jump", "eta", "exponent", *LIMITS)
    } | {
        "height": size[0], "width": size[1], "seed": number, "iterations": 3, "fractions": False,
        "guide_weight": 0,
    } | CHOICES  # fmt: skip
    arrays = patch.pictures | patch.only(*POLAR)
    arrays["ring"] = ring(radius)
    if differences.get("max_shift"):
        arrays["powers"] = power_table(gamma)
    if locked:
        arrays["lock"] = rng.random(size) < 0.3
    if guided:
        parameters["guide_weight"] = fixed_guide_weight(3.0)
        guides = pictures(rng, images, 1, holes=False)
        arrays |= {name.replace("image", "source_guide"): guides[name] for name in guides}
        arrays["target_guide"] = rng.integers(0, 256, (*size, 1), dtype=np.uint8)
    return parameters | differences, arrays
