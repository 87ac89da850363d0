"""StyLit: source patches look for their place in the target (Fišer et al. 2016; thesis 1.5).

The search between two votes follows Hauptfleisch 2020, 2.3.1, with the changes of 2.4.1:

1. Target to source: every target patch finds its closest source patch. The error E_best of this
   match limits the errors that the target patch accepts later (α). The match stays if no retrieval
   fixes the patch.
2. Source to target, a *retrieval*: every source patch finds the closest target patch that is not
   fixed yet, and claims it. Only the closest claims count, as many as the error budget covers
   (:mod:`stylit_ref.stylization.error_budget`); of two claims to the same patch the closer wins.
   The target patches of these claims are fixed.
3. Step 2 is repeated until the share ``fixed_share`` of the target's patches is fixed, or a
   retrieval fixes less than a thousandth of what it could. The latter happens with a limit α, or if
   no source patch is close to the remaining target patches.
4. The vote.

PatchMatch runs both ways with the same passes. For a retrieval, source and target are swapped. The
padded target can be a source, since its patches lie inside it. The source can be a target: its
border of ``radius`` pixels serves as the padding. A map of taken patches replaces W. Its weight is
so large that λρ of a fixed patch exceeds every δ, so the search skips fixed patches as it skips
patches that are used too often.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from stylit_ref.formulae.candidates import PROPAGATION_DISTANCES
from stylit_ref.metric.proposal import Proposal
from stylit_ref.metric.textures import Textures
from stylit_ref.passes.claims import CLAIMED, FIXED, FREE
from stylit_ref.randomness.philox import FourWords
from stylit_ref.randomness.random_stream import (
    ITERATIONS,
    RETRIEVAL_NNF,
    RETRIEVAL_SEARCH,
    random_stream,
)
from stylit_ref.stylization.error_budget import correspondences_within_budget
from stylit_ref.stylization.exemplar import ExemplarLevel
from stylit_ref.stylization.level import Level, join
from stylit_ref.stylization.progress import SearchStep
from stylit_ref.stylization.target import TargetLevel

if TYPE_CHECKING:  # params imports the methods, which import this module
    from stylit_ref.stylization.params import Params
    from stylit_ref.stylization.schedules import Iterate

LEAST_PROGRESS = 1e-3
"""A retrieval can fix at most as many patches as the smaller of source and target has. If it fixes
less than this share of that number, it is the last."""


def search(
    level: Level, params: "Params", iterate: "Iterate", seed: int, level_number: int, vote: int
) -> Iterator[SearchStep]:
    """One M-step of StyLit: a search from target to source, then retrievals within an error budget.

    Parameters
    ----------
    level : Level
        Its NNF and δ are overwritten.
    params : Params
    iterate : callable
        A PatchMatch iteration of the search from target to source.
    seed, level_number, vote : int
        They identify the random numbers.

    Yields
    ------
    SearchStep
        After the target-to-source search, and after every retrieval.
    """
    iterations = params.patchmatch_iterations
    for iteration in range(1, iterations + 1):
        iterate(level, seed, level_number, vote, iteration)
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

    Source and target of the level are swapped; they share memory with the level, except for the
    moments. NNF coordinates are those of the padded target: ``radius`` more than the target's own.

    Parameters
    ----------
    level : Level
        After a vote, with the NNF and δ of a search from target to source.
    stream : tuple of 4 uint32
        Random numbers of the random NNF that it begins with.

    Attributes
    ----------
    proposal : Proposal
        The arguments of the passes; W is replaced by a map of ``FREE`` and ``FIXED``.
    """

    level: Level
    textures: Textures
    proposal: Proposal

    def __init__(self, level: Level, stream: FourWords) -> None:
        self.level = level
        passes, packing, width = level.passes, level.packing, level.patch_width
        radius = width // 2
        source, target = level.textures.source, level.textures.target
        self.textures = join(
            ExemplarLevel(passes, packing, width, target),
            TargetLevel(passes, packing, width, source),
        )
        taken = np.full(target.shape[:2], FIXED, np.int32)
        inside = np.s_[radius : target.shape[0] - radius, radius : target.shape[1] - radius]
        taken[inside][level.nnf[:, :, 0] >= 0] = FREE

        patches = self.textures.target_moments.shape[:2]
        nnf, delta = np.zeros((*patches, 2), np.int32), np.zeros(patches, np.int64)
        passes.random_nnf(nnf, width, *target.shape[:2], stream)
        passes.similarity(self.textures, width, nnf, delta)
        passes.invert_nnf(level.nnf, level.delta, width, nnf, delta)
        price = packing.largest_delta(width) + 1
        self.proposal = Proposal(
            self.textures, taken, price, width, nnf, delta, nnf.copy(), delta.copy()
        )

    @property
    def nnf(self) -> NDArray[np.int32]:
        """The target patch of each source patch, ``radius`` added to its coordinates."""
        return self.proposal.nnf

    @property
    def delta(self) -> NDArray[np.int64]:
        """Their δ."""
        return self.proposal.delta

    @property
    def taken(self) -> NDArray[np.int32]:
        """``FREE`` or ``FIXED`` for every target patch, in place of W."""
        return self.proposal.omega_sums

    def improve(self, stream: FourWords) -> None:
        """One PatchMatch iteration; every proposal is accepted, since the map does not change."""
        passes = self.level.passes
        for distance in PROPAGATION_DISTANCES:
            passes.propagation(*self.proposal, distance)
            self.proposal = self.proposal.accepted()
        passes.random_search(*self.proposal, stream, max(self.level.delta.shape))
        self.proposal = self.proposal.accepted()

    def settle(self, budget: Literal["hyperbola"] | float, limits: NDArray[np.int64]) -> int:
        """Fix the target patches of the claims that the error budget covers.

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
