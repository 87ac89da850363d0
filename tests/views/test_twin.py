"""The folded term against equation 3.1 with a guide for every neighbour."""

from itertools import product

import numpy as np
import pytest
from small_shot import EFFORT, sliding

from stylit_ref import Params, passes
from stylit_ref.metric.packing import ONE
from stylit_ref.stylization.exemplar import Exemplar
from stylit_ref.stylization.problem import make_exemplar
from stylit_ref.stylization.synthesis import Synthesis
from stylit_ref.stylization.target import Target
from stylit_ref.views.coherence import Neighbour, pull
from stylit_ref.views.packing import coherent_packing


def explicit_delta(level, own, guides, weight, nnf):
    """δ of each assignment by equation 3.1, divided by 1 + Σ λ_c; float64 squared steps."""
    packing, width = level.packing, level.patch_width
    radius = width // 2
    source = level.textures.source.astype(float)
    target = level.textures.target.astype(float)
    total = 1 + weight * len(guides)
    costs = np.zeros(nnf.shape[:2])
    padded = [np.pad(image, ((radius, radius), (radius, radius), (0, 0)), "edge").astype(float)
              for image in (own, *guides)]  # fmt: skip
    guide_channels = range(packing.style_channel - 2)
    style = slice(packing.style_channel, packing.style_channel + packing.style_channels)
    for dy, dx in product(range(-radius, radius + 1), repeat=2):
        there = source[nnf[:, :, 0] + dy, nnf[:, :, 1] + dx]
        rows = slice(radius + dy, radius + dy + nnf.shape[0])
        columns = slice(radius + dx, radius + dx + nnf.shape[1])
        for c in guide_channels:
            weighs = packing.weights[c] / ONE
            costs += weighs * (there[:, :, c] - target[rows, columns, c]) ** 2
        for image, share in zip(padded, [1, *[weight] * len(guides)], strict=True):
            squares = ((there[:, :, style] - image[rows, columns]) ** 2).mean(axis=2)
            costs += share / total * squares
    return costs


@pytest.fixture
def level():
    """A level of StyLit in the midst of a run, whose pixels have room for the spread."""
    style, sources, guides, _ = sliding(frames=1)
    params = Params(method="stylit", **EFFORT)
    packing = make_exemplar(style, sources, params).packing
    packing = coherent_packing(packing, 256, with_spread=True)

    def packed(guides, style=None):
        spread = np.zeros((*guides[0].shape[:2], 1), np.uint8)
        return packing.pack([*guides, spread], style)

    exemplar = Exemplar(passes, packing, params.patch_width, packed(sources, style))
    target = Target(passes, packing, params.patch_width, packed(guides[0]))
    run = Synthesis(exemplar, target, params)
    for number in run.level_numbers[:-1]:
        for _ in run.run_level(number):
            pass
    level = run.begin_level(run.level_numbers[-1])
    run.vote()
    return level


def identity(size):
    return np.stack(np.mgrid[: size[0], : size[1]], axis=-1).astype(np.int32)


def test_folded_error_is_that_of_explicit_guides_where_nothing_is_rounded(level):
    own = level.style.copy()
    sign = np.random.default_rng(0).choice([-8, 8], own.shape)
    own = np.clip(own, 8, 247)
    level.set_style(own)
    guide = (own + sign).astype(np.uint8)  # M = own ± 4 and √S = 4 exactly
    pull(level, own, [Neighbour(identity(own.shape[:2]), guide)], 256, with_spread=True)
    expected = explicit_delta(level, own, [guide], 1, level.nnf)
    # A style channel weighs a third, rounded to 1/65536.
    assert np.allclose(level.delta / ONE, expected, rtol=2 / ONE, atol=1e-6)


def test_folded_error_is_that_of_explicit_guides_up_to_rounding(level):
    own = level.style.copy()
    rng = np.random.default_rng(1)
    guides = [np.roll(own, k, axis=0) for k in (1, 3)]
    guides.append(rng.integers(0, 256, own.shape, dtype=np.uint8))
    neighbours = [Neighbour(identity(own.shape[:2]), guide) for guide in guides]
    pull(level, own, neighbours, 128, with_spread=True)
    expected = explicit_delta(level, own, guides, 0.5, level.nnf)
    assert abs(level.delta.sum() / ONE / expected.sum() - 1) < 0.005
