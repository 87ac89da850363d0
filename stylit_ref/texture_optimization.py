"""Texture optimization, coarse to fine (thesis 2.3, 2.4, 3.3, 3.4).

Sequences of passes, written once: the module of passes is an argument.

Two schedules of PatchMatch differ in when the occurrence map Ω changes:

``scanline``
    Thesis 2.4: patch after patch, Ω live. Sequential, the plainest reference.
``propose_commit``
    The default. Each kernel of thesis 3.3 (propagation at 4, at 2, at 1, then random
    search) runs over the whole target with Ω frozen and only *proposes*. Then its
    proposals *commit*, in 16 interleaved classes of pixels one after another: a pixel
    moves if φ still falls with Ω as it stands, and Ω is brought up to date after each
    class. The thesis updates Ω with atomics while its kernels run, which no two runs
    repeat; this gives the same bytes with any number of threads.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from stylit_ref.formulae.bounded_metric import Textures
from stylit_ref.formulae.commit_classes import CLASS_STRIDE, commit_order
from stylit_ref.formulae.random_stream import (
    COMMIT_ORDER,
    RANDOM_NNF,
    RANDOM_SEARCH,
    random_stream,
)
from stylit_ref.packing import ONE, Packing, occurrence_weight
from stylit_ref.params import Params

PROPAGATION_DISTANCES = (4, 2, 1)
"""Jump flood distances (thesis 3.3)."""


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
    moved : int or None
        Target patches whose assignment changed (None for ``scanline``).
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
    moved: int | None
    done: float


class Level:
    """Textures, assignments and occurrence maps of one pyramid level."""

    def __init__(self, passes, packing, params, source, target, synthesized):
        self.passes, self.packing, self.params = passes, packing, params
        self.patch_width = params.patch_width
        radius = self.patch_width // 2
        height, width = target.shape[:2]
        padded = np.pad(target, ((radius, radius), (radius, radius), (0, 0)), mode="edge")
        self.textures = Textures(
            source=source,
            target=padded,
            source_sums=np.zeros(source.shape, np.int16),
            target_sums=np.zeros(target.shape, np.int16),
            weights=packing.weights,
            pair_weights=packing.pair_weights,
        )
        passes.patch_sums(source, self.textures.source_sums, self.patch_width, radius)
        passes.patch_sums(padded, self.textures.target_sums, self.patch_width, 0)

        self.nnf = np.where(synthesized[:, :, None], np.int32(0), np.int32(-1)).repeat(2, axis=2)
        self.delta = np.zeros((height, width), np.int64)
        self.proposed_nnf, self.proposed_delta = self.nnf.copy(), self.delta.copy()
        self.omega, self.omega_sums = np.zeros((2, *source.shape[:2]), np.int32)
        self.target_patches = np.count_nonzero(synthesized)
        self.occurrence_weight = occurrence_weight(
            params.uniformity,
            self.patch_width,
            source.shape[0] * source.shape[1],
            self.target_patches,
        )

    @property
    def style(self):
        """The synthesized style B' as it stands, (H_B, W_B, n) uint8 view."""
        radius = self.patch_width // 2
        return self.packing.style(self.textures.target)[radius:-radius, radius:-radius]

    def init_occurrence_map(self):
        """InitOccurrenceMap (2.3): Ω and W of the NNF as it stands."""
        self.passes.occurrence_map(self.nnf, self.omega, self.omega_sums, self.patch_width)

    def vote(self):
        """E-step of 2.3: B' from the NNF; then δ of the NNF with the new B'."""
        self.passes.vote(
            self.textures.source,
            self.textures.target,
            self.nnf,
            self.patch_width,
            self.packing.style_channel,
            self.packing.style_channels,
        )
        self.passes.patch_sums(
            self.textures.target,
            self.textures.target_sums,
            self.patch_width,
            0,
            self.packing.style_channel,
        )
        self.update_similarity()

    def update_similarity(self):
        self.passes.similarity(self.textures, self.patch_width, self.nnf, self.delta)

    def energy(self):
        """Mean δ and mean λρ, in the thesis' units."""
        delta, omega_sum = self.passes.energy(self.nnf, self.delta, self.omega_sums)
        return delta / ONE, self.occurrence_weight * omega_sum / ONE


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
    sources, targets, masks = [source], [target], [synthesized]
    for _ in range(params.levels - 1):
        sources.append(passes.downsample(sources[-1]))
        targets.append(passes.downsample(targets[-1]))
        masks.append(passes.downsample_mask(masks[-1]))
    work = [np.count_nonzero(mask) for mask in masks]

    done = 0
    level = None
    for level_number in range(1, params.levels + 1):
        depth = params.levels - level_number
        coarse = level
        level = Level(passes, packing, params, sources[depth], targets[depth], masks[depth])
        source_size = sources[depth].shape[:2]
        if coarse is None:
            stream = random_stream(seed, RANDOM_NNF, level_number)
            passes.random_nnf(level.nnf, params.patch_width, *source_size, stream)
        else:
            passes.upsample_nnf(coarse.nnf, level.nnf, params.patch_width, *source_size)
        level.init_occurrence_map()
        for vote in range(1, params.votes + 1):
            level.vote()
            for iteration in range(1, params.patchmatch_iterations + 1):
                moved = SCHEDULES[params.schedule](level, seed, level_number, vote, iteration)
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
                        moved=moved,
                        done=done / (sum(work) * params.votes * params.patchmatch_iterations),
                    )
                )
        level.vote()
        level.init_occurrence_map()
        on_level(level_number, level.style)
    return level


def propose_commit(level, seed, level_number, vote, iteration):
    """One PatchMatch iteration of the default schedule; returns how many patches moved."""
    passes = level.passes
    classes = commit_order(random_stream(seed, COMMIT_ORDER, level_number, vote, iteration))
    search_stream = random_stream(seed, RANDOM_SEARCH, level_number, vote, iteration)
    proposal = (
        level.textures, level.omega_sums, level.occurrence_weight, level.patch_width,
        level.nnf, level.delta, level.proposed_nnf, level.proposed_delta,
    )  # fmt: skip
    commitment = (
        level.nnf, level.delta, level.proposed_nnf, level.proposed_delta,
        level.omega_sums, level.occurrence_weight, level.patch_width, classes, CLASS_STRIDE,
    )  # fmt: skip
    moved = 0
    for distance in PROPAGATION_DISTANCES:
        passes.propagation(*proposal, distance)
        moved += passes.commit(*commitment)
    passes.random_search(*proposal, search_stream)
    return moved + passes.commit(*commitment)


def scanline(level, seed, level_number, vote, iteration):
    """One PatchMatch iteration of thesis 2.4, Ω live."""
    level.passes.scanline(
        level.textures.source,
        level.textures.target,
        level.textures.weights,
        level.omega,
        level.occurrence_weight,
        level.patch_width,
        level.nnf,
        random_stream(seed, RANDOM_SEARCH, level_number, vote, iteration),
        iteration % 2 == 0,
    )
    level.update_similarity()
    level.init_occurrence_map()


SCHEDULES = {"propose_commit": propose_commit, "scanline": scanline}
