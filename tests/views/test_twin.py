"""The folded term against equation 3.1 with a guide for every neighbour, spelt out."""

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

METHODS = ("ref", "guide_map", "stylit")


@pytest.fixture(params=[*((method, 3) for method in METHODS), *(("stylit", n) for n in (1, 2, 4))])
def level(request):
    """A level in the midst of a run; of StyLit, with room for the spread."""
    method, style_channels = request.param
    style, sources, guides, _ = sliding(frames=1, style_channels=style_channels)
    params = Params(method=method, **EFFORT)
    with_spread = params.traits.chooses_targets
    packing = make_exemplar(style, sources, params).packing
    packing = coherent_packing(packing, 256, with_spread=with_spread)

    def packed(guides, style=None):
        spread = [np.zeros((*guides[0].shape[:2], 1), np.uint8)] * with_spread
        return packing.pack([*guides, *spread], style)

    exemplar = Exemplar(passes, packing, params.patch_width, packed(sources, style))
    target = Target(passes, packing, params.patch_width, packed(guides[0]))
    run = Synthesis(exemplar, target, params)
    for number in run.level_numbers[:-1]:
        for _ in run.run_level(number):
            pass
    level = run.begin_level(run.level_numbers[-1])
    run.vote()
    return level


def candidates(level, number=12):
    """NNFs of random source patches."""
    rng, radius = np.random.default_rng(5), level.patch_width // 2
    last = np.array(level.omega.shape) - radius
    shape = level.nnf.shape
    return [rng.integers(radius, last, shape, dtype=np.int32) for _ in range(number)]


def similarity(level, nnf):
    """δ of an NNF in squared 8-bit steps."""
    level.set_nnf(nnf)
    level.update_similarity()
    return level.delta / ONE


def squared_differences(level, image, nnf):
    """The style term between an image and the source patches of an NNF, by brute force."""
    width, radius = level.patch_width, level.patch_width // 2
    source = level.packing.style(level.textures.source).astype(float)
    padded = np.pad(image, ((radius, radius), (radius, radius), (0, 0)), "edge").astype(float)
    total = np.zeros(nnf.shape[:2])
    for dy, dx in product(range(width), repeat=2):
        there = source[nnf[:, :, 0] + dy - radius, nnf[:, :, 1] + dx - radius]
        here = padded[dy : dy + nnf.shape[0], dx : dx + nnf.shape[1]]
        total += ((there - here) ** 2).mean(axis=2)
    return total


def explicit_similarity(level, own, guides, weight, nnf):
    """δ by equation 3.1, divided by 1 + Σ λ_c; the level's B' is ``own``."""
    plain = similarity(level, nnf)
    of_own = squared_differences(level, own, nnf)
    of_guides = sum(squared_differences(level, guide, nnf) for guide in guides)
    total = 1 + weight * len(guides)
    return plain - of_own + (of_own + weight * of_guides) / total


def folded(level, own, guides, weight):
    """Fold guides that need no shift."""
    identity = np.stack(np.mgrid[: own.shape[0], : own.shape[1]], axis=-1).astype(np.int32)
    neighbours = [Neighbour(identity, guide) for guide in guides]
    with_spread = len(level.packing.guide_sizes) > 2
    pull(level, own, neighbours, weight, with_spread=with_spread)
    return with_spread


def test_without_rounding_the_fold_is_the_explicit_term_up_to_a_constant(level):
    rng = np.random.default_rng(0)
    own = np.clip(level.style, 8, 247)
    guide = (own + rng.choice([-8, 8], own.shape)).astype(np.uint8)  # M = B' ± 4, and √S = 4
    level.set_style(own)
    nnfs = candidates(level)
    explicit = np.array([explicit_similarity(level, own, [guide], 1, nnf) for nnf in nnfs])
    with_spread = folded(level, own, [guide], 256)
    found = np.array([similarity(level, nnf) for nnf in nnfs])
    constant = explicit - found
    # A style channel weighs a third, rounded to 1/65536.
    assert np.allclose(constant, constant[0], rtol=0, atol=explicit.max() * 2 / ONE)
    assert np.array_equal(found.argmin(axis=0), explicit.argmin(axis=0))
    if with_spread:
        assert np.allclose(constant, 0, atol=explicit.max() * 2 / ONE)


def test_with_rounding_the_fold_chooses_as_well_within_half_a_percent(level):
    rng = np.random.default_rng(1)
    own = level.style.copy()
    guides = [np.roll(own, k, axis=0) for k in (1, 3)]
    guides.append(rng.integers(0, 256, own.shape, dtype=np.uint8))
    nnfs = candidates(level)
    explicit = np.array([explicit_similarity(level, own, guides, 0.5, nnf) for nnf in nnfs])
    with_spread = folded(level, own, guides, 128)
    found = np.array([similarity(level, nnf) for nnf in nnfs])
    chosen = np.take_along_axis(explicit, found.argmin(axis=0)[None], axis=0)
    assert chosen.sum() <= 1.005 * explicit.min(axis=0).sum()
    if with_spread:
        assert abs(found.sum() / explicit.sum() - 1) < 0.005
