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

A retrieval is PatchMatch with source and target in each other's place. Every target patch that is
fixed counts as worse than every free one. Its passes leave out what cannot change a claim
(:mod:`stylit_ref.formulae.claim_state`), and keep the decisions of the plain ones.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from stylit_ref.formulae.candidates import PROPAGATION_DISTANCES
from stylit_ref.formulae.claim_state import LOST, UNKNOWN
from stylit_ref.passes.claims import CLAIMED, FIXED, FREE
from stylit_ref.randomness.philox import FourWords
from stylit_ref.randomness.random_stream import (
    ITERATIONS,
    RETRIEVAL_NNF,
    RETRIEVAL_SEARCH,
    random_stream,
)
from stylit_ref.stylization.error_budget import correspondences_within_budget
from stylit_ref.stylization.level import Level
from stylit_ref.stylization.progress import SearchStep

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
    least = LEAST_PROGRESS * min(patches, retrieval.errors.size)
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
    """PatchMatch from source to target that looks for target patches that are not fixed.

    Parameters
    ----------
    level : Level
        After a vote, with the NNF and δ of a search from target to source.
    stream : tuple of 4 uint32
        Random numbers of the random claims that it begins with.

    Attributes
    ----------
    claims : (H_A - 2 radius, W_A - 2 radius, 2) int32
        The target patch that each source patch claims.
    errors : (H_A - 2 radius, W_A - 2 radius) int64
        Their δ.
    states : (H_A - 2 radius, W_A - 2 radius) uint8
        What is left to look at (:mod:`stylit_ref.formulae.claim_state`).
    taken : (H_B, W_B) uint8
        ``FREE`` or ``FIXED`` for every target patch.
    """

    level: Level
    claims: NDArray[np.int32]
    errors: NDArray[np.int64]
    states: NDArray[np.uint8]
    taken: NDArray[np.uint8]

    def __init__(self, level: Level, stream: FourWords) -> None:
        self.level = level
        passes, width = level.passes, level.patch_width
        self.taken = np.where(level.nnf[:, :, 0] >= 0, np.uint8(FREE), np.uint8(FIXED))
        patches = tuple(length - width + 1 for length in level.textures.source.shape[:2])
        self.claims, self.errors = np.zeros((*patches, 2), np.int32), np.zeros(patches, np.int64)
        passes.random_nnf(self.claims, 1, *self.taken.shape, stream)
        passes.claim_errors(level.textures, width, self.claims, self.errors)
        passes.invert_nnf(level.nnf, level.delta, width, self.claims, self.errors)
        self.states = np.full(patches, UNKNOWN, np.uint8)
        passes.lose_claims(self.claims, self.taken, self.states)
        self._spare = tuple(map(np.empty_like, (self.claims, self.errors, self.states)))

    def improve(self, stream: FourWords) -> None:
        """One PatchMatch iteration; each pass takes all claims of the one before."""
        passes = self.level.passes
        for distance in PROPAGATION_DISTANCES:
            self._improve(passes.propagate_claims, distance)
        self._improve(passes.search_claims, stream)

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
        errors = np.sort(self.errors[self.states < LOST])
        if not errors.size:
            return 0
        within = correspondences_within_budget(errors, budget)
        last_error = errors[within - 1]
        passes = self.level.passes
        passes.settle_claims(
            self.claims,
            self.errors,
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
        passes.lose_claims(self.claims, self.taken, self.states)
        return int(np.count_nonzero(claimed))

    def _improve(self, propose, *arguments):
        own = self.claims, self.errors, self.states
        width = self.level.patch_width
        propose(self.level.textures, self.taken, width, *own, *self._spare, *arguments)
        (self.claims, self.errors, self.states), self._spare = self._spare, own
