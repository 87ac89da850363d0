"""PatchMatch with an occurrence map: one iteration, in two schedules (thesis 2.4, 3.3).

They differ in when the occurrence map Ω changes:

``scanline``
    Thesis 2.4: patch after patch, Ω live. Sequential, the plainest reference.
``propose_commit``
    The default. Each kernel of thesis 3.3 (propagation at 4, at 2, at 1, then random
    search) runs over the whole target with Ω frozen and only *proposes*. Then its
    proposals *commit*, in 16 interleaved classes of pixels one after another: a pixel
    moves if φ still falls with Ω as it stands, and Ω is brought up to date after each
    class. The thesis updates Ω with atomics while its kernels run, which no two runs
    repeat; this gives the same bytes with any number of threads.

    Committing after every kernel matters: with one commit for all four, proposals that
    build on each other rush to the same unused patches, and for λ = 50000 and more the
    field loses coherence.
"""

from stylit_ref.formulae.random_stream import COMMIT_ORDER, RANDOM_SEARCH, random_stream

PROPAGATION_DISTANCES = (4, 2, 1)
"""Jump flood distances (thesis 3.3)."""


def propose_commit(level, seed, level_number, vote, iteration):
    """One PatchMatch iteration of the default schedule; returns the number of moves."""
    passes = level.passes
    commit_stream = random_stream(seed, COMMIT_ORDER, level_number, vote, iteration)
    search_stream = random_stream(seed, RANDOM_SEARCH, level_number, vote, iteration)
    proposal = (
        level.textures, level.omega_sums, level.occurrence_weight, level.patch_width,
        level.nnf, level.delta, level.proposed_nnf, level.proposed_delta,
    )  # fmt: skip
    commitment = (
        level.nnf, level.delta, level.proposed_nnf, level.proposed_delta,
        level.omega_sums, level.occurrence_weight, level.patch_width, commit_stream,
    )  # fmt: skip
    moves = 0
    for distance in PROPAGATION_DISTANCES:
        passes.propagation(*proposal, distance)
        moves += passes.commit(*commitment)
    passes.random_search(*proposal, search_stream)
    return moves + passes.commit(*commitment)


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
