"""Texture optimization, coarse to fine (thesis 2.3, 3.4).

A sequence of passes, written once: the module of passes is an argument.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from stylit_ref.formulae.random_stream import RANDOM_NNF, random_stream
from stylit_ref.level import Level
from stylit_ref.packing import Packing
from stylit_ref.params import Params
from stylit_ref.patchmatch import SCHEDULES


@dataclass(frozen=True)
class Step:
    """Where a run stands after a PatchMatch iteration.

    Attributes
    ----------
    level, levels : int
        Pyramid level, 1 the coarsest, and their number.
    height, width : int
        Target size of the level.
    vote, patchmatch_iteration : int
        Counted from 1.
    delta, penalization : float
        Mean δ and mean λρ over the target patches; φ is their sum.
    moves : int or None
        Changes of assignments (None for ``scanline``).
    done : float
        Share of the whole run's work, up to 1.
    """

    level: int
    levels: int
    height: int
    width: int
    vote: int
    patchmatch_iteration: int
    delta: float
    penalization: float
    moves: int | None
    done: float


def texture_optimization(
    passes,
    source: np.ndarray,
    target: np.ndarray,
    synthesized: np.ndarray,
    packing: Packing,
    params: Params,
    seed: int,
    on_step: Callable[[Step], None],
    on_level: Callable[[int, np.ndarray], None],
) -> Level:
    """TextureOptimization of thesis 2.3 and GPU_TextureOptimization of 3.4.

    The thesis also upsamples B' to the next level; the vote that opens a level
    overwrites it before anything reads it, so only the NNF is carried over.

    Parameters
    ----------
    passes : module
        :mod:`stylit_ref.passes`.
    source, target : (H, W, C) uint8
        Packed textures Ā and B̄.
    synthesized : (H_B, W_B) bool
        Target pixels whose patches take part.
    packing : Packing
    params : Params
        ``levels`` must suit the sizes.
    seed : int
    on_step : callable
        Called after every PatchMatch iteration.
    on_level : callable
        Called with the level and B' after its last vote.

    Returns
    -------
    Level
        The finest, voted.
    """
    sources, targets, where = [source], [target], [synthesized]
    for _ in range(params.levels - 1):
        sources.append(passes.downsample(sources[-1]))
        targets.append(passes.downsample(targets[-1]))
        where.append(passes.downsample_mask(where[-1]))
    work = [np.count_nonzero(level_where) for level_where in where]
    all_work = params.patchmatch_iterations * sum(
        pixels * params.votes_above(depth) for depth, pixels in enumerate(work)
    )

    done = 0
    level = None
    for level_number in range(1, params.levels + 1):
        depth = params.levels - level_number
        coarse_nnf = level.nnf if level else None
        level = None  # makes room for the next
        level = Level(passes, packing, params, sources[depth], targets[depth], where[depth])
        source_size = sources[depth].shape[:2]
        if coarse_nnf is None:
            stream = random_stream(seed, RANDOM_NNF, level_number)
            passes.random_nnf(level.nnf, params.patch_width, *source_size, stream)
        else:
            passes.upsample_nnf(coarse_nnf, level.nnf, params.patch_width, *source_size)
        level.init_occurrence_map()
        for vote in range(1, params.votes_above(depth) + 1):
            level.vote()
            level.update_moments()
            for iteration in range(1, params.patchmatch_iterations + 1):
                moves = SCHEDULES[params.schedule](level, seed, level_number, vote, iteration)
                done += work[depth]
                delta, penalization = level.energy()
                on_step(
                    Step(
                        level=level_number,
                        levels=params.levels,
                        height=level.nnf.shape[0],
                        width=level.nnf.shape[1],
                        vote=vote,
                        patchmatch_iteration=iteration,
                        delta=delta,
                        penalization=penalization,
                        moves=moves,
                        done=done / all_work,
                    )
                )
        level.vote()
        level.init_occurrence_map()
        on_level(level_number, level.style)
    return level
