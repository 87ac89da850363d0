"""PatchMatch with an occurrence map: one iteration, in several schedules (thesis 2.4, 3.3).

They differ in when the occurrence map Ω changes:

``scanline``
    Thesis 2.4: one patch after another, Ω live. It is sequential, and the simplest reference.
``propose_commit``
    The default, and the canonical one. Each kernel of thesis 3.3 runs over the whole target with Ω
    frozen and only *proposes*; then its proposals *commit*, and Ω is updated. It gives the same
    bytes with any number of threads. The thesis updates Ω with atomics while its kernels run, so
    its results are not reproducible.

A backend may have its own schedule: those of :mod:`gpu_cuda.variants.live` follow thesis 3.3, with
Ω live by atomics.

The canonical iteration in every detail:

1. Propagation at distance 4, commit; at 2, commit; at 1, commit; random search, commit.
   With fewer distances the style is used less evenly at high λ; another order gains nothing
   (``docs/performance.md``). With one commit for all four, proposals build on each other and
   rush to the same unused patches; for λ = 50000 and more the field then loses coherence.
2. Propagation offers the assignments that the neighbours to the right, below, to the left and above
   had when the kernel began, shifted back and clamped to the source's centres.
3. Random search offers one candidate each from the squares of radius 1, 2, 4, ... up to half the
   larger side of the target, all around the assignment at the kernel's beginning. Its stream is
   ``RANDOM_SEARCH``: draw ``k // 2`` of a pixel serves radius ``2**k``, with its first two words if
   k is even, with its last two if k is odd.
4. A proposal is the candidate with the lowest φ; among equals the earlier one, the current
   assignment being the first.
5. A commit takes the 16 classes ``(y mod 4, x mod 4)`` one after another. Their order is shuffled
   once an iteration (stream ``COMMIT_ORDER``) and serves its four commits. A pixel moves if the φ
   of its proposal is below that of its assignment, both with W as it was when the class began. W is
   updated when the class is done.
"""

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from stylit_ref.formulae.candidates import PROPAGATION_DISTANCES
from stylit_ref.randomness.random_stream import COMMIT_ORDER, RANDOM_SEARCH, random_stream
from stylit_ref.stylization.level import Level
from stylit_ref.stylization.progress import SearchStep

if TYPE_CHECKING:  # params imports the methods, which import this module
    from stylit_ref.stylization.params import Params


def propose_commit(level: Level, seed: int, level_number: int, vote: int, iteration: int) -> int:
    """One PatchMatch iteration of the default schedule; returns the assignments that changed."""
    passes = level.passes
    commit_stream = random_stream(seed, COMMIT_ORDER, level_number, vote, iteration)
    search_stream = random_stream(seed, RANDOM_SEARCH, level_number, vote, iteration)
    for distance in PROPAGATION_DISTANCES:
        passes.propagation(*level.proposal, distance)
        passes.commit(*level.commitment(commit_stream))
    passes.random_search(*level.proposal, search_stream)
    passes.commit(*level.commitment(commit_stream))
    return level.take_moves()


def scanline(level: Level, seed: int, level_number: int, vote: int, iteration: int) -> None:
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


Iterate = Callable[[Level, int, int, int, int], int | None]
"""``(level, seed, level_number, vote, iteration)``: one PatchMatch iteration. It returns the number
of assignments that changed, or None if they are not counted."""

SCHEDULES: dict[str, Iterate] = {"propose_commit": propose_commit, "scanline": scanline}
"""One iteration of each."""


def search(
    level: Level, params: "Params", iterate: Iterate, seed: int, level_number: int, vote: int
) -> Iterator[SearchStep]:
    """PatchMatch of thesis 2.3, from target to source, with the iterations that ``params`` names.

    Parameters
    ----------
    level : Level
        Its NNF, δ and W are improved.
    params : Params
    iterate : callable
        One of :data:`SCHEDULES`, or that of a backend.
    seed, level_number, vote : int
        They identify the random numbers.

    Yields
    ------
    SearchStep
        After every iteration.
    """
    for iteration in range(1, params.patchmatch_iterations + 1):
        moves = iterate(level, seed, level_number, vote, iteration)
        yield SearchStep(iteration, moves, iteration / params.patchmatch_iterations)
