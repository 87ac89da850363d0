"""StyLit: source patches look for their place in the target (Fišer et al. 2016; thesis 1.5).

The search between two votes, as Hauptfleisch 2020 tells it in 2.3.1, with the changes of 2.4.1:

1. Target to source: every target patch finds its closest source patch, whose error E_best
   limits what it accepts later (α), and who keeps it if no other fixes it.
2. Source to target, a *retrieval*: every source patch finds the closest target patch that is
   not fixed yet, and claims it. Of all claims the error budget
   (:mod:`stylit_ref.stylization.error_budget`) covers the closest; of two to the same patch the
   closer wins. Their target patches are fixed.
3. Again 2, until the share ``fixed_share`` of the target's patches is fixed, or a retrieval
   fixes less than a thousandth of what it could: with a limit α, or with patches that no source
   patch comes near to, more would follow that fix next to nothing.
4. The vote.

PatchMatch runs both ways with the same passes. For a retrieval source and target change places: A
padded target is a texture whose patches lie whole inside it, as a source's do, and the source,
its border of ``radius`` pixels left out, is a target that is padded already. The place of W takes a
map of what is taken, weighed so heavily that λρ of a patch that is fixed exceeds every δ: the
search then skips it as it skips patches that are used too often.
"""

import numpy as np

from stylit_ref.passes.claims import CLAIMED, FIXED, FREE
from stylit_ref.randomness.random_stream import (
    ITERATIONS,
    RETRIEVAL_NNF,
    RETRIEVAL_SEARCH,
    random_stream,
)
from stylit_ref.stylization.error_budget import correspondences_within_budget
from stylit_ref.stylization.progress import SearchStep
from stylit_ref.stylization.schedules import PROPAGATION_DISTANCES, propose_commit

LEAST_PROGRESS = 1e-3
"""A retrieval can fix as many patches as the source has, or the target; another one follows
where it has fixed this share of the fewer."""


def search(level, params, seed, level_number, vote):
    """One M-step of StyLit: retrievals within an error budget, and the rest from target to source.

    Parameters
    ----------
    level : Level
        Its NNF and δ are overwritten.
    params : Params
    seed, level_number, vote : int
        Name the random numbers.

    Yields
    ------
    SearchStep
        After the target-to-source search, and after every retrieval.
    """
    iterations = params.patchmatch_iterations
    for iteration in range(1, iterations + 1):
        propose_commit(level, seed, level_number, vote, iteration)
    yield SearchStep(iterations, None, 0.0, retrieval=0, fixed=0.0)

    limits = np.full(level.delta.shape, np.iinfo(np.int64).max)
    if params.error_limit is not None:
        limits = np.minimum(level.delta * params.error_limit, 2.0**62).astype(np.int64)
    retrieval = Retrieval(level, random_stream(seed, RETRIEVAL_NNF, level_number, vote))
    patches = int(np.count_nonzero(retrieval.taken == FREE))
    wanted = params.fixed_share * patches
    least = LEAST_PROGRESS * min(patches, retrieval.delta.size)
    fixed = number = 0
    going_on = True
    while going_on:
        for iteration in range(iterations * number + 1, iterations * (number + 1) + 1):
            retrieval.improve(random_stream(seed, RETRIEVAL_SEARCH, level_number, vote, iteration))
        newly_fixed = retrieval.settle(params.budget, limits)
        fixed += newly_fixed
        number += 1
        numbers_left = iterations * (number + 1) < ITERATIONS
        going_on = fixed < wanted and newly_fixed >= least and numbers_left
        done = fixed / wanted if going_on else 1.0
        yield SearchStep(iterations * (number + 1), newly_fixed, done, number, fixed / patches)


class Retrieval:
    """PatchMatch from source to target that skips fixed target patches.

    Attributes
    ----------
    textures : Textures
        Those of the level with source and target in each other's place; the same memory but for
        the moments.
    nnf : (H_A - 2 radius, W_A - 2 radius, 2) int32
        For each source patch a target patch, ``radius`` added to its coordinates.
    delta : (H_A - 2 radius, W_A - 2 radius) int64
    taken : (H_B + 2 radius, W_B + 2 radius) int32
        ``FREE`` or ``FIXED``, in the place of W.
    """

    def __init__(self, level, stream):
        self.level = level
        passes, packing, width = level.passes, level.packing, level.patch_width
        radius = width // 2
        source, target = level.textures.source, level.textures.target
        patches = source.shape[0] - 2 * radius, source.shape[1] - 2 * radius
        lanes = len(packing.moments)
        self.textures = level.textures._replace(
            source=target,
            target=source,
            source_moments=passes.moments_storage(*target.shape[:2], lanes),
            target_moments=passes.moments_storage(*patches, lanes),
        )
        style = packing.style_channel, packing.style_channels
        passes.patch_moments(target, self.textures.source_moments, width, radius, *style)
        passes.patch_moments(source, self.textures.target_moments, width, 0, *style)

        self.taken = np.full(target.shape[:2], FIXED, np.int32)
        inside = np.s_[radius : target.shape[0] - radius, radius : target.shape[1] - radius]
        self.taken[inside][level.nnf[:, :, 0] >= 0] = FREE
        self.taken_weight = packing.largest_delta(width) + 1

        self.nnf, self.delta = np.zeros((*patches, 2), np.int32), np.zeros(patches, np.int64)
        passes.random_nnf(self.nnf, width, *target.shape[:2], stream)
        passes.similarity(self.textures, width, self.nnf, self.delta)
        passes.invert_nnf(level.nnf, level.delta, width, self.nnf, self.delta)
        self.proposed_nnf, self.proposed_delta = self.nnf.copy(), self.delta.copy()

    def improve(self, stream):
        """One PatchMatch iteration; nothing follows the moves, so proposals are assignments."""
        passes = self.level.passes
        for distance in PROPAGATION_DISTANCES:
            self._take(passes.propagation, distance)
        self._take(passes.random_search, stream, max(self.level.delta.shape))

    def _take(self, propose, *parameters):
        propose(
            self.textures, self.taken, self.taken_weight, self.level.patch_width,
            self.nnf, self.delta, self.proposed_nnf, self.proposed_delta, *parameters,
        )  # fmt: skip
        self.nnf, self.proposed_nnf = self.proposed_nnf, self.nnf
        self.delta, self.proposed_delta = self.proposed_delta, self.delta

    def settle(self, budget, limits):
        """Fix what the error budget covers.

        Parameters
        ----------
        budget : "hyperbola" or float
        limits : (H_B, W_B) int64
            The largest error each target patch accepts.

        Returns
        -------
        int
            Number of target patches fixed.
        """
        free = self.taken[self.nnf[:, :, 0], self.nnf[:, :, 1]] == FREE
        errors = np.sort(self.delta[free])
        if not errors.size:
            return 0
        within = correspondences_within_budget(errors, budget)
        last_error = errors[within - 1]
        self.level.passes.settle_claims(
            self.nnf,
            self.delta,
            last_error,
            within - np.searchsorted(errors, last_error),
            limits,
            self.taken,
            self.level.patch_width,
            self.level.nnf,
            self.level.delta,
        )
        claimed = self.taken == CLAIMED
        self.taken[claimed] = FIXED
        return int(np.count_nonzero(claimed))
