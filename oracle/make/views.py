"""The cases of coherence between frames: awkward inputs, and the library's output for them."""

from collections.abc import Iterator

import numpy as np

from oracle.cases import Case
from oracle.families import VIEWS
from oracle.make.views_motion import motion_inputs
from oracle.make.views_runs import run_inputs
from oracle.stages import run_case
from stylit_ref.views import passes


def views_cases(version: str) -> Iterator[Case]:
    """Every case of the newest version, with its expected output."""
    for stage, name, parameters, arrays in _inputs():
        expected = run_case(VIEWS, stage, parameters, arrays, passes)
        section = VIEWS.sections[stage]
        yield Case(version, stage, name, section, parameters, {}, arrays, expected)


def _inputs():
    rng = np.random.default_rng(2020)
    yield from motion_inputs(rng)
    yield from _folds(rng)
    yield from _weights()
    yield from _plans()
    yield from run_inputs()


def _folds(rng):
    for name, size, channels, weights in (
        ("plain", (5, 7), 3, [128, 128]),
        ("one", (5, 7), 3, [256]),
        ("four", (4, 6), 3, [128, 37, 1, 1024]),
        ("least", (5, 7), 3, [1, 1]),
        ("largest", (5, 7), 3, [1 << 14] * 4),
        ("nought", (3, 4), 3, [0, 0]),
        ("contrast", (6, 8), 3, [256]),
        ("grey", (5, 7), 1, [128, 128]),
        ("four_channels", (4, 5), 4, [100, 300]),
        ("one_pixel", (1, 1), 2, [128]),
    ):
        own, *guides = rng.integers(0, 256, (1 + len(weights), *size, channels), np.uint8)
        if name == "contrast":
            own, *guides = (255 * (image > 127) for image in (own, *guides))
        arrays = {"own": np.uint8(own), "guides": np.stack(guides).astype(np.uint8)}
        yield "fold", name, {}, arrays | {"weights": np.array(weights, np.int64)}


def _weights():
    plain = {
        "guide_channels": [3, 1], "guide_weights": [1.0, 0.5], "guide_influence": 2.0,
        "style_channels": 3, "coherence": 0.5, "form": "norm", "neighbours": 2, "spread": False,
    }  # fmt: skip
    for name, differences in (
        ("norm", {}),
        ("plain_form", {"form": "plain"}),
        ("with_spread", {"spread": True}),
        ("plain_form_with_spread", {"form": "plain", "spread": True, "neighbours": 4}),
        ("grey_with_spread", {"form": "plain", "spread": True, "style_channels": 1}),
        ("four_channels_with_spread", {"form": "plain", "spread": True, "style_channels": 4}),
        ("least", {"form": "plain", "coherence": 1 / 256, "neighbours": 1}),
        ("nought", {"form": "plain", "coherence": 0.00195}),
        ("largest", {"form": "plain", "coherence": 64.0, "neighbours": 4, "spread": True}),
        ("half_way", {"form": "plain", "neighbours": 1}),
        ("between", {"form": "plain", "coherence": 129 / 512, "style_channels": 4}),
        ("alone", {"form": "plain", "neighbours": 0}),
    ):
        yield "weights", name, plain | differences, {}


def _plans():
    line, behind = [[1], [0, 2], [1]], [[], [0], [1]]
    for name, order, neighbours, votes in (
        ("parallel", "parallel", line, [2, 1]),
        ("sweeps", "sweeps", line, [3, 2]),
        ("sequential", "sequential", behind, [2, 1]),
        ("ring", "sweeps", [[1, 3], [0, 2], [1, 3], [0, 2]], [2]),
        ("grid", "sequential", [[], [0], [0], [1, 2]], [1, 1]),
        ("alone", "sweeps", [[]], [1, 2]),
    ):
        yield "plan", name, {"order": order, "neighbours": neighbours, "votes": votes}, {}
    following = {"order": "sequential", "neighbours": [[], [0], []], "votes": [3, 2]}
    yield "plan", "following", following | {"following_votes": [1, 3]}, {}
