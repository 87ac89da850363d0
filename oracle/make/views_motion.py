"""The cases of motion: where pixels lie in other frames, and which of them are seen there."""

import numpy as np

from oracle.make.views_scene import (
    NOT_NUMBERS,
    SIZE,
    coming_nearer,
    crossing_square,
    floor_that_recedes,
    motion,
    of_few,
    only,
    uniform,
)

SMALL = ("one_pixel", (1, 1)), ("one_row", (1, 9)), ("one_column", (10, 1))

LANDINGS = {
    "splat": (
        "plain", "one_pixel", "equal_depths", "no_depth", "ties", "crowded", "nothing_there",
        "not_numbers",
    ),
    "invert": (
        "plain", "one_row", "no_depth", "ties", "nothing_there", "cracks", "uncovered", "crossing",
    ),
    "unhidden": ("plain", "one_pixel", "no_depth", "nothing_there", "crowded"),
}  # fmt: skip
"""What lands in the cases of each stage."""


def motion_inputs(rng):
    """Stage, name, parameters and arrays of every case."""
    yield from _places(rng)
    yield from _pictures(rng)
    yield from _compositions(rng)
    yield from _cancellations(rng)
    yield from _splats(rng)
    yield from _silhouettes(rng)
    yield from _edges()


def _places(rng):
    for name, depth, arrays in (
        ("plain", 0, motion(rng)),
        ("depth_1", 1, motion(rng, (12, 14), 4.0)),
        ("depth_2", 2, motion(rng, (16, 20), 8.0)),
        ("odd", 1, motion(rng, (11, 13), 3.0)),
        *((name, 0, motion(rng, size, 1.0, shown=1.0)) for name, size in SMALL),
        ("halves", 0, motion(rng, longest=1.0, awkward=(-0.5, 0.5, -1.5, 0.49999997, -0.50000006))),
        ("not_numbers", 0, motion(rng, awkward=NOT_NUMBERS)),
        ("hidden", 0, motion(rng, shown=0.0)),
        ("long", 1, _longer_than_the_level()),
    ):
        yield "shift_map", name, {"depth": depth}, arrays


def _longer_than_the_level():
    """Vectors of more pixels than the level has, which lead into it all the same."""
    arrays = uniform((6, 8), -6.0, 0.0)
    arrays["field"][:, :4] = 6, 4
    return arrays


def _pictures(rng):
    for name, size, channels, shown in (
        ("plain", SIZE, 3, 0.8),
        ("grey", SIZE, 1, 0.8),
        ("four_channels", (4, 5), 4, 0.8),
        ("hidden", (4, 5), 3, 0.0),
        ("one_pixel", (1, 1), 3, 1.0),
    ):
        picture, own = rng.integers(0, 256, (2, *size, channels), np.uint8)
        places = rng.integers(0, size, (*size, 2)).astype(np.int32)
        places[rng.random(size) >= shown] = -1
        yield "shift_picture", name, {}, {"picture": picture, "places": places, "own": own}


def _compositions(rng):
    for name, first, second in (
        ("plain", motion(rng), motion(rng)),
        ("halves", motion(rng, awkward=(0.5, -0.5)), motion(rng)),
        ("not_numbers", motion(rng, awkward=NOT_NUMBERS), motion(rng, awkward=(np.nan, 1e30))),
        ("hidden", motion(rng), motion(rng, shown=0.0)),
        ("one_pixel", uniform((1, 1), 0.25), uniform((1, 1), -0.5)),
        ("one_row", motion(rng, (1, 9)), motion(rng, (1, 9))),
    ):
        after = {f"next_{key}": array for key, array in second.items()}
        yield "compose", name, {}, first | after


def _cancellations(rng):
    def roughly(arrays, amount):
        noise = np.round(rng.uniform(-amount, amount, arrays["field"].shape) * 16) / 16
        back = -arrays["field"] + noise
        return arrays | {"back": back.astype(np.float32), "known": np.ones(back.shape[:2], bool)}

    slow = motion(rng, longest=0.25)
    slow["field"] += np.float32((1, -1))
    yield "cancel", "plain", {}, roughly(slow, 0.8)
    yield "cancel", "long", {}, roughly(uniform((2, 40), -20.0, 0.0), 4.0)
    arrays = roughly(slow, 0.5)
    arrays["known"] = rng.random(arrays["known"].shape) < 0.5
    yield "cancel", "unknown", {}, arrays
    arrays = roughly(uniform((2, 8), 0.0), 0.0)
    limits = np.array([181, 181.5, 181.49, 182, -181, -181.5, -181.51, -182]) / 256
    arrays["back"][0, :, 0] = arrays["back"][1, :, 1] = limits
    yield "cancel", "at_the_limit", {}, arrays
    arrays = roughly(motion(rng, longest=1.0, awkward=NOT_NUMBERS), 0.5)
    arrays["back"] = rng.choice(np.array([*NOT_NUMBERS, 0, 0], np.float32), arrays["back"].shape)
    arrays["back"][2:4] = np.inf
    yield "cancel", "not_numbers", {}, arrays
    yield "cancel", "one_pixel", {}, roughly(uniform((1, 1), 0.25), 0.0)


def _splats(rng):
    landings = dict(_landings(rng))
    for stage, names in LANDINGS.items():
        for name in names:
            yield stage, name, {}, landings[name]


def _landings(rng):
    for name, size in (("plain", SIZE), *SMALL[:2]):
        yield name, motion(rng, size, 1.5) | {"depth": of_few(rng, [1, 2, 3, 4], size)}
    yield "equal_depths", motion(rng) | {"depth": of_few(rng, [2])}
    yield "no_depth", motion(rng)
    ties = uniform(SIZE, 0.0)
    ties["field"][:, ::2, 0], ties["field"][::3, 1::2, 0] = 1, -1
    yield "ties", ties | {"depth": of_few(rng, [2])}
    crowd = uniform(SIZE, 0.0)
    middle = np.stack(np.mgrid[: SIZE[0], : SIZE[1]][::-1], axis=-1)
    crowd["field"] += (4, 3) - middle + rng.choice([-0.25, 0.25], (*SIZE, 1))
    yield "crowded", crowd | {"depth": of_few(rng, [1, 2])}
    nothing = of_few(rng, [np.nan, 0, -1, 1e9, np.inf, -np.inf, 9.9e8, 1, 2])
    yield "nothing_there", motion(rng) | {"depth": nothing}
    yield "not_numbers", motion(rng, awkward=NOT_NUMBERS)
    yield "cracks", coming_nearer((8, 12)) | {"depth": of_few(rng, [1], (8, 12))}
    passing = uniform(SIZE, 0.0)
    passing["field"][2:5, 2] = 3, 0
    yield "uncovered", passing | {"depth": of_few(rng, [1])}
    shaking = uniform((8, 9), 0.0)
    shaking["field"] += np.round(rng.uniform(-0.6, 1.0, (8, 9, 2)) * 8) / 8
    yield "crossing", shaking | {"depth": of_few(rng, [1], (8, 9))}


def _silhouettes(rng):
    depths = {
        "plain": of_few(rng, [1, 2, 4]),
        "plane": floor_that_recedes(),
        "at_the_limit": of_few(rng, [1, 1.04, 1.05, 1.0500001, 1.06, 1.1]),
        "nothing": of_few(rng, [0, -1, np.inf, np.nan, 1e9, 9.9e8, 1]),
        "as_close": of_few(rng, [1, 1.02, 2, 4, 4, 4]),
    } | {name: of_few(rng, [1, 2, 4], size) for name, size in SMALL}
    depths["thin"] = np.full(SIZE, 4, np.float32)
    depths["thin"][1, 2] = depths["thin"][3:, 5] = depths["thin"][2, 0] = 1
    labels = of_few(rng, [0, 0, 3, 5], dtype=np.int32)
    for name, depth in depths.items():
        yield "rims", name, {}, {"depth": depth}
    yield "rims", "labels", {}, {"labels": labels}
    for name, reach in (("plain", 1), ("plane", 2), ("nothing", 2), ("as_close", 3), ("thin", 2)):
        yield "beside", name, {"reach": reach}, {"depth": depths[name]}
    yield "beside", "one_row", {"reach": 20}, {"depth": depths["one_row"]}
    yield "beside", "labels", {"reach": 2}, {"labels": labels}
    wide = 2, 120
    for name, arrays, ends in (
        ("plain", motion(rng), ("depth_0", "depth_1")),
        ("labels", motion(rng), ("labels_0", "labels_1")),
        ("hidden", motion(rng, shown=0.1), ("depth_0", "depth_1")),
        ("one_pixel", uniform((1, 1), 0.0), ("depth_0", "depth_1")),
    ):
        size = arrays["visible"].shape
        for end in ends:
            if end.startswith("depth"):
                arrays[end] = of_few(rng, [1, 1.04, 2, 4, 4], size)
            else:
                arrays[end] = of_few(rng, [0, 3], size, np.int32)
        yield "along", name, {}, arrays
    arrays = uniform(wide, 0.0) | {f"depth_{end}": np.full(wide, 4, np.float32) for end in (0, 1)}
    arrays["depth_0"][:, 30:70] = arrays["depth_1"][:, 33:73] = 2
    arrays["field"][:, 30:70] = 3, 0
    yield "along", "wide", {}, arrays
    arrays = uniform(SIZE, 0.0) | {"depth_0": np.full(SIZE, 4, np.float32)}
    arrays["depth_1"] = arrays["depth_0"].copy()
    arrays["depth_0"][2:4, 2:4], arrays["depth_1"][1:4, 1:6] = 2, 1.9
    arrays["depth_1"][2, 2] = 1.0
    yield "along", "other_thing", {}, arrays


def _edges():
    """Motion of an edge from all that files may hold."""
    told, untold = {"tells_visible": True}, {"tells_visible": False}
    ahead, back = {"to": 0, "other": 1}, {"to": 1, "other": 0}
    two, three = crossing_square(2), crossing_square(3)
    forward, backward = ("forward_0", "forward_shown_0"), ("backward_1", "backward_shown_1")
    both = "forward", "backward"
    over = *forward, *backward, "backward_2", "backward_shown_2", "depth_0", "depth_2"
    for name, parameters, arrays in (
        ("forward", ahead | untold, only(two, *forward)),
        ("backward", ahead | untold, only(two, *backward)),
        ("both", ahead | untold, only(two, *both)),
        ("told", ahead | told, only(two, *both)),
        ("with_labels", ahead | told, only(two, *forward, "labels")),
        ("with_depth", back | untold, only(two, *forward, "depth")),
        (
            "with_labels_and_one_depth",
            ahead | untold,
            only(two, *forward, "labels", "depth_0"),
        ),
        ("mixed", ahead | untold, only(two, *backward, "depth_0", "labels_1")),
        ("one_end", ahead | untold, only(two, *forward, "depth_0")),
        ("over_three", {"to": 0, "other": 2} | untold, only(three, *over)),
        (
            "back_over_three",
            {"to": 2, "other": 0} | untold,
            only(three, *forward, "forward_1", "forward_shown_1"),
        ),
    ):
        yield "motion", name, parameters, arrays
