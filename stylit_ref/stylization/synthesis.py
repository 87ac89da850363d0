"""Texture optimization, coarse to fine (thesis 2.3, 3.4).

A sequence of passes, written once: the module of passes is an argument.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from stylit_ref.metric.packing import Packing
from stylit_ref.randomness.random_stream import RANDOM_NNF, random_stream
from stylit_ref.stylization import schedules, stylit
from stylit_ref.stylization.level import Level
from stylit_ref.stylization.mask import downsample_mask
from stylit_ref.stylization.params import Params

SEARCHES = {
    "ref": schedules.search,
    "shared_memory": schedules.search,
    "guide_map": schedules.search,
    "stylit": stylit.search,
}
"""How the NNF is improved between two votes, by method."""


@dataclass(frozen=True)
class Step:
    """Where a run stands after a step of a search: a PatchMatch iteration, or a retrieval.

    Attributes
    ----------
    level, levels : int
        Pyramid level, 1 the coarsest, and their number.
    height, width : int
        Target size of the level.
    vote : int
        Counted from 1.
    delta, penalization : float
        Mean δ and mean λρ over the target patches; φ is their sum.
    done : float
        Share of the whole run's work, up to 1.
    patchmatch_iteration : int
        Counted from 1 after each vote.
    moves : int or None
        Changes of assignments (None where they are not counted).
    retrieval : int or None
        ``stylit``: source-to-target retrievals since the vote. The last step of a vote has their
        number.
    fixed : float or None
        ``stylit``: share of the target patches that they have fixed since the vote.
    """

    level: int
    levels: int
    height: int
    width: int
    vote: int
    delta: float
    penalization: float
    done: float
    patchmatch_iteration: int
    moves: int | None
    retrieval: int | None
    fixed: float | None


def texture_optimization(
    passes,
    source: np.ndarray,
    target: np.ndarray,
    synthesized: np.ndarray,
    packing: Packing,
    params: Params,
    seed: int,
    on_step: Callable[[Step], None],
    on_level: Callable[[int, Level], None],
) -> Level:
    """TextureOptimization of thesis 2.3 and GPU_TextureOptimization of 3.4.

    The thesis also upsamples B' to the next level; the vote that opens a level
    overwrites it before anything reads it, so only the NNF is carried over.

    Parameters
    ----------
    passes : module
        :mod:`stylit_ref.passes`, or those of a GPU.
    source, target : (H, W, C) uint8
        Packed textures Ā and B̄.
    synthesized : (H_B, W_B) bool
        Target pixels whose patches take part.
    packing : Packing
    params : Params
        ``levels`` must suit the sizes.
    seed : int
    on_step : callable
        Called after every step of a search.
    on_level : callable
        Called with a level's number and the level after its last vote.

    Returns
    -------
    Level
        The finest, voted.
    """
    sources, targets, where = [passes.upload(source)], [passes.upload(target)], [synthesized]
    for _ in range(params.levels - 1):
        sources.append(passes.downsample(sources[-1]))
        targets.append(passes.downsample(targets[-1]))
        where.append(downsample_mask(where[-1]))
    work = [np.count_nonzero(level_where) for level_where in where]
    all_work = sum(pixels * params.votes_above(depth) for depth, pixels in enumerate(work))
    search = SEARCHES[params.method]

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
            for step in search(level, params, seed, level_number, vote):
                delta, penalization = level.energy()
                on_step(
                    Step(
                        level=level_number,
                        levels=params.levels,
                        height=level.nnf.shape[0],
                        width=level.nnf.shape[1],
                        vote=vote,
                        delta=delta,
                        penalization=penalization,
                        done=(done + step.done * work[depth]) / all_work,
                        patchmatch_iteration=step.patchmatch_iteration,
                        moves=step.moves,
                        retrieval=step.retrieval,
                        fixed=step.fixed,
                    )
                )
            done += work[depth]
        level.vote()
        level.init_occurrence_map()
        on_level(level_number, level)
    return level
