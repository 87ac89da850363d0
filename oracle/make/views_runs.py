"""The cases of whole coherent runs, and of the iterations that they are made of."""

import numpy as np

from oracle.make.views_scene import Sequence, motion, uniform

ITERATIONS = {
    "ref": {"neighbours": 2},
    "ref_plain": {"form": "plain", "coherence": 1.0},
    "guide_map": {"method": "guide_map"},
    "stylit": {"method": "stylit"},
    "stylit_plain": {"method": "stylit", "form": "plain"},
    "limited": {"method": "stylit", "error_limit": 1.02, "iterations": 2},
    "coarse": {"level": 1, "target": (9, 7)},
    "finished": {"level": 1, "method": "stylit", "is_finished": True},
    "largest": {"coherence": 64.0, "form": "plain", "vote": 2, "shown": 0.3},
    "alone": {"neighbours": 0},
    "four": {"neighbours": 4, "style_channels": 4},
    "hidden": {"shown": 0.0, "form": "plain"},
    "outliers": {"outliers": 4},
}
"""How each iteration differs from that of ``ref``."""

RUNS = {
    "parallel": {},
    "sweeps": {"order": "sweeps", "frames": 3, "coherence": 1.0},
    "sequential": {"order": "sequential", "coherence": 1.0},
    "ref_plain": {"form": "plain", "order": "sweeps", "votes": 3, "levels": 1},
    "guide_map": {"method": "guide_map"},
    "stylit": {"method": "stylit", "form": "plain", "votes": 1},
    "stylit_sequential": {"method": "stylit", "order": "sequential", "votes": 1},
    "nought": {"coherence": 0.00195, "votes": 1},
    "ring": {"frames": 3, "pairs": ((0, 2), (1, 0), (2, 1)), "order": "sweeps", "votes": 1},
    "two_channels": {"style_channels": 2, "target": (7, 11), "seed": (1 << 64) - 5},
    "odd": {"source": (9, 11), "target": (11, 7), "order": "sequential", "votes": 1},
    "outliers": {"outliers": 4, "votes": 1},
    "following": {"order": "sequential", "votes": 3, "following_votes": 1, "frames": 3},
}
"""How each run differs from two frames of ``ref`` at once."""


def run_inputs():
    """Stage, name, parameters and arrays of every case."""
    for number, (name, differences) in enumerate(ITERATIONS.items()):
        yield "iteration", name, *_iteration(100 + number, **differences)
    for number, (name, differences) in enumerate(RUNS.items()):
        sequence = Sequence(200 + number, **{"order": "parallel"} | differences)
        yield "run", name, sequence.parameters, sequence.arrays


def _iteration(
    number, level=2, vote=1, neighbours=1, target=(7, 8), style_channels=3, shown=0.8,
    is_finished=False, **chosen,
):  # fmt: skip
    """Parameters and arrays of a frame that neighbours pull at."""
    rng = np.random.default_rng(number)
    sequence = Sequence(number, 1, target=target, style_channels=style_channels, **chosen)
    parameters, arrays = sequence.parameters | {"level": level, "vote": vote}, sequence.arrays
    arrays["target_guides"] = arrays.pop("target_guides_0")
    depth = parameters["levels"] - level
    size = tuple(side >> depth for side in target)
    centres = np.array(arrays["style"].shape[:2]) >> depth
    nnf = rng.integers(1, centres - 1, (*size, 2)).astype(np.int32)
    pictures = rng.integers(0, 256, (1 + neighbours, *size, style_channels), np.uint8)
    arrays |= {"nnf": nnf, "picture": pictures[0]}
    for other in range(1, neighbours + 1):
        arrays[f"picture_{other}"] = pictures[other]
        if is_finished:
            whole = rng.integers(0, 256, (*target, style_channels), np.uint8)
            arrays[f"picture_{other}"] = whole
        moved = uniform(target, other - 1)
        moved["field"] += motion(rng, target, 1.0)["field"]
        moved["visible"] = rng.random(target) < shown
        arrays |= {f"{key}_{other}": array for key, array in moved.items()}
    return parameters, arrays
