"""PatchMatch with an occurrence map: one iteration, in several schedules (thesis 2.4, 3.3).

They differ in when the occurrence map Ω changes:

``scanline``
    Thesis 2.4: patch after patch, Ω live. Sequential, the plainest reference.
``propose_commit``
    The default and the canonical one. Each kernel of thesis 3.3 runs over the whole
    target with Ω frozen and only *proposes*; then its proposals *commit*, and Ω follows.
    The thesis updates Ω with atomics while its kernels run, which no two runs repeat;
    this gives the same bytes with any number of threads.

A backend may bring a schedule of its own: those of :mod:`gpu_cuda.variants.live` are thesis 3.3, Ω
live by atomics, no two runs alike.

The canonical iteration, to the last choice:

1. Propagation at distance 4, commit; at 2, commit; at 1, commit; random search, commit.
   Fewer distances lose usage at high λ and another order gains nothing
   (``docs/performance.md``). One commit for all four makes proposals that build on each
   other rush to the same unused patches, and for λ = 50000 and more the field loses
   coherence.
2. Propagation offers the assignments of the neighbours to the right, below, to the left
   and above, as the kernel found them, shifted back and clamped to the source's centres.
3. Random search offers one candidate each from the squares of radius 1, 2, 4, ... up to
   half the larger side of the target, all around the assignment the kernel found. Its
   stream is ``RANDOM_SEARCH``: draw ``k // 2`` of a pixel serves radius ``2**k`` with its
   first two words if k is even, its last two if it is odd.
4. A proposal is the candidate with the lowest φ; among equals the earlier one, the
   assignment first.
5. A commit takes the 16 classes ``(y mod 4, x mod 4)`` one after another, in an order
   shuffled once an iteration (stream ``COMMIT_ORDER``) for its four commits. A pixel
   moves if the φ of its proposal is below that of its assignment, both with W as it
   stood when the class began; W follows when the class is done.
"""

from stylit_ref.formulae.candidates import PROPAGATION_DISTANCES
from stylit_ref.randomness.random_stream import COMMIT_ORDER, RANDOM_SEARCH, random_stream
from stylit_ref.stylization.progress import SearchStep


def propose_commit(level, seed, level_number, vote, iteration):
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
"""One iteration of each, ``(level, seed, level_number, vote, iteration) -> int or None``: the
assignments that changed, where they are counted."""


def search(level, params, iterate, seed, level_number, vote):
    """PatchMatch of thesis 2.3: as many iterations as ``params`` say, from target to source.

    Parameters
    ----------
    level : Level
        Its NNF, δ and W are improved.
    params : Params
    iterate : callable
        One of :data:`SCHEDULES`, or a backend's own.
    seed, level_number, vote : int
        Name the random numbers.

    Yields
    ------
    SearchStep
        After every iteration.
    """
    for iteration in range(1, params.patchmatch_iterations + 1):
        moves = iterate(level, seed, level_number, vote, iteration)
        yield SearchStep(iteration, moves, iteration / params.patchmatch_iterations)
