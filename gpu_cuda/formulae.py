"""The formulae as kernels call them: none is written again here."""

from functools import lru_cache

from gpu_cuda.device import formula
from stylit_ref.formulae import (
    candidates,
    commit_classes,
    improve_proposal,
    patch_penalization,
    patch_similarity,
    philox,
    random_stream,
)
from stylit_ref.formulae import guide_map as guide_maps

clamp = formula(candidates.clamp)
commit_order = formula(commit_classes.commit_order)
delta = formula(patch_similarity.delta)
patch_omega = formula(patch_penalization.patch_omega)
patch_sum = formula(guide_maps.patch_sum)
penalization = formula(improve_proposal.penalization)
propagation_candidate = formula(candidates.propagation_candidate)
random_candidate = formula(candidates.random_candidate)
random_words = formula(random_stream.random_words)
scaled_variance = formula(guide_maps.scaled_variance)
uniform_below = formula(philox.uniform_below)


@lru_cache
def make_assignment_delta(mean_channels):
    """See :func:`stylit_ref.formulae.improve_proposal.make_assignment_delta`."""
    return formula(improve_proposal.make_assignment_delta(mean_channels))


@lru_cache
def make_improve_proposal(mean_channels):
    """See :func:`stylit_ref.formulae.improve_proposal.make_improve_proposal`."""
    return formula(improve_proposal.make_improve_proposal(mean_channels))
