"""A small, complete pyramid level for tests of passes and formulae."""

from dataclasses import replace

import numpy as np

from stylit_ref import Params, passes
from stylit_ref.metric.packing import make_packing
from stylit_ref.randomness.random_stream import RANDOM_NNF, random_stream
from stylit_ref.stylization.exemplar import Exemplar
from stylit_ref.stylization.level import Level
from stylit_ref.stylization.target import Target


def make_level(
    seed=0,
    patch_width=5,
    guide_channels=(3, 3),
    guide_weights=None,
    style_channels=3,
    source_size=(13, 17),
    target_size=(14, 12),
    uniformity=5000,
    smooth=False,
    constant=False,
    crowded=False,
    masked=None,
    epsilon=None,
    flat_style=False,
):
    """A level with random textures, a random NNF, and δ, Ω and W that belong to it.

    ``smooth`` images change slowly, ``constant`` ones not at all; a ``crowded`` NNF
    assigns every other row to one source patch; ``epsilon`` makes a guide map;
    with ``flat_style`` only the guides differ.
    """
    rng = np.random.default_rng(seed)
    params = Params(patch_width=patch_width, uniformity=uniformity)
    if epsilon is not None:
        params = replace(params, method="guide_map", epsilon=epsilon)
    weights = guide_weights or (1.0,) * len(guide_channels)
    packing = make_packing(guide_channels, style_channels, params.guide_influence, weights)

    used = np.zeros(packing.channels, np.uint8)  # channels that only pad are zero
    for first, channels in zip(packing.guide_channels, guide_channels, strict=True):
        used[first : first + channels] = 1
    used[packing.style_channel : packing.style_channel + style_channels] = 1

    def texture(size):
        image = rng.integers(0, 256, (*size, packing.channels), dtype=np.uint8)
        if smooth:
            ramp = np.add.outer(np.arange(size[0]), np.arange(size[1]))[:, :, None]
            image = (ramp * 4 + image // 16).astype(np.uint8)
        if constant:
            image[:] = 100
        if flat_style:
            packing.style(image)[:] = 100
        return image * used

    synthesized = np.ones(target_size, bool) if masked is None else ~masked
    source, target = texture(source_size), texture(target_size)
    exemplar = Exemplar(passes, packing, patch_width, source)
    level = Level(
        exemplar.level(0),
        Target(passes, packing, patch_width, target, synthesized).level(0),
        params,
    )
    stream = random_stream(seed, RANDOM_NNF, 1)
    passes.random_nnf(level.nnf, patch_width, *source_size, stream)
    if crowded:
        level.nnf[::2] = level.nnf[0, 0]
    level.update_similarity()
    level.init_occurrence_map()
    return level
