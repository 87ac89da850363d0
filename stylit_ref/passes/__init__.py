"""The passes: loops on the CPU that apply the formulae to whole arrays."""

from stylit_ref.passes.claim_propagation import propagate_claims
from stylit_ref.passes.claim_search import search_claims
from stylit_ref.passes.claims import claim_errors, invert_nnf, lose_claims, settle_claims
from stylit_ref.passes.commit import commit
from stylit_ref.passes.energy import energy
from stylit_ref.passes.guide_map import guide_map
from stylit_ref.passes.guide_sums import means
from stylit_ref.passes.memory import download, repeat_edge, upload, wait, zeros
from stylit_ref.passes.occurrence import box_sum, count_assignments, occurrence_map
from stylit_ref.passes.patch_moments import moments_storage, patch_moments
from stylit_ref.passes.propagation import propagation
from stylit_ref.passes.pyramid import downsample, upsample_nnf
from stylit_ref.passes.random_nnf import random_nnf
from stylit_ref.passes.random_search import random_search
from stylit_ref.passes.replay_vote import replay_vote
from stylit_ref.passes.scanline import scanline
from stylit_ref.passes.similarity import similarity
from stylit_ref.passes.vote import vote

__all__ = [
    "box_sum",
    "claim_errors",
    "commit",
    "count_assignments",
    "download",
    "downsample",
    "energy",
    "guide_map",
    "invert_nnf",
    "lose_claims",
    "means",
    "moments_storage",
    "occurrence_map",
    "patch_moments",
    "propagate_claims",
    "propagation",
    "random_nnf",
    "random_search",
    "repeat_edge",
    "replay_vote",
    "scanline",
    "search_claims",
    "settle_claims",
    "similarity",
    "upload",
    "upsample_nnf",
    "vote",
    "wait",
    "zeros",
]
