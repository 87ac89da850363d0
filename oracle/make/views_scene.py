"""Small frames that move in awkward ways, from which the cases are cut."""

import numpy as np

from oracle.make.scene import random_image

SEED = 0x1234567890ABCDEF

SIZE = 6, 8
"""Of frames whose pixels are not stylized."""

NOT_NUMBERS = np.nan, np.inf, -np.inf, 1e30, -1e30


def motion(rng, size=SIZE, longest=2.0, shown=0.85, awkward=()):
    """Vectors in steps of 1/4; some are one of the awkward values, and some are hidden.

    Across a frame of one row or column they are a fourth as long.
    """
    field = np.round(rng.uniform(-longest, longest, (*size, 2)) * 4) / 4
    field *= np.where(np.array(size[::-1]) == 1, 0.25, 1)
    if awkward:
        field = np.where(rng.random((*size, 1)) < 0.3, rng.choice(awkward, field.shape), field)
    return {"field": field.astype(np.float32), "visible": rng.random(size) < shown}


def uniform(size, dx, dy=0.0):
    """The same vector everywhere, and all visible."""
    return {"field": np.full((*size, 2), (dx, dy), np.float32), "visible": np.ones(size, bool)}


def of_few(rng, values, size=SIZE, dtype=np.float32):
    """Depths, or labels, of few values."""
    return rng.choice(np.array(values, dtype), size)


def floor_that_recedes(size=SIZE):
    """Depth of a plane, with a thing in front of it."""
    rows, columns = np.mgrid[: size[0], : size[1]]
    depth = 1 / (0.2 + 0.05 * rows + 0.02 * columns)
    depth[1:3, 2:5] = 0.9
    return depth.astype(np.float32)


def coming_nearer(size):
    """A surface that grows by a fifth, so that cracks open."""
    field = np.stack(np.mgrid[: size[0], : size[1]][::-1], axis=-1) * 0.2
    return {"field": field.astype(np.float32), "visible": np.ones(size, bool)}


def crossing_square(frames, size=(6, 9)):
    """A square that crosses a still ground by two pixels a frame: what its files might hold."""
    arrays = {}
    for frame in range(frames):
        depth, labels = np.full(size, 4, np.float32), np.zeros(size, np.int32)
        square = np.s_[2:5, 1 + 2 * frame : 4 + 2 * frame]
        depth[square], labels[square] = 2, 7
        forward_shown, backward_shown = np.ones((2, *size), bool)
        forward_shown[0, frame] = backward_shown[5, frame] = False
        forward = np.zeros((*size, 2), np.float32)
        forward[square] = 2, 0
        arrays |= {
            f"forward_{frame}": forward, f"forward_shown_{frame}": forward_shown,
            f"backward_{frame}": -forward, f"backward_shown_{frame}": backward_shown,
            f"depth_{frame}": depth, f"labels_{frame}": labels,
        }  # fmt: skip
    return arrays


def only(arrays, *names):
    """Those arrays whose names begin with one of these."""
    return {name: array for name, array in arrays.items() if name.startswith(names)}


class Sequence:
    """Frames that slide to the right by a pixel each, and a style: what runs are made of."""

    def __init__(
        self, number, frames=2, source=(8, 9), target=(7, 8), style_channels=3, shown=0.9,
        pairs=None, **chosen,
    ):  # fmt: skip
        rng = np.random.default_rng(number)
        self.parameters = {
            "method": "ref", "guide_channels": [3, 1], "guide_weights": [1.0, 1.0],
            "guide_influence": 2.0, "patch_width": 3, "levels": 2, "votes": 2, "outliers": 0,
            "iterations": 1, "coherence": 0.5, "form": "norm", "seed": SEED,
        } | chosen  # fmt: skip
        own = {
            "ref": {"uniformity": 5000.0},
            "guide_map": {"uniformity": 5000.0, "epsilon": 400.0},
            "stylit": {"budget": 0.9, "fixed_share": 0.95, "error_limit": None},
        }
        self.parameters = own[self.parameters["method"]] | self.parameters
        guides = random_image(rng, target, 4, smooth=True)
        self.arrays = {
            "style": random_image(rng, source, style_channels),
            "source_guides": random_image(rng, source, 4, smooth=True),
        }
        for frame in range(frames):
            self.arrays[f"target_guides_{frame}"] = np.roll(guides, frame, axis=1)
        if pairs is None:
            pairs = [pair for k in range(frames - 1) for pair in ((k, k + 1), (k + 1, k))]
        for to, other in pairs:
            moved = uniform(target, other - to)
            moved["field"] += motion(rng, target, 0.5)["field"]
            moved["visible"] = rng.random(target) < shown
            self.arrays |= {f"{name}_{to}_{other}": array for name, array in moved.items()}
