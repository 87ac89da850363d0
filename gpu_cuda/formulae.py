"""The library's formulae in the form that kernels can call; none is written again here.

Many threads change Ω and W at once, so they add atomically. Both are maps of integers, so the
order of the threads does not matter.
"""

from numba import cuda

from gpu_cuda.host.device import device_function, formula
from stylit_ref.formulae import (
    candidates,
    improve_assignment,
    patch_penalization,
    rounding,
    search_radii,
    voting,
)
from stylit_ref.formulae import guide_map as guide_maps
from stylit_ref.randomness import commit_classes, philox, random_stream

block_mean = formula(rounding.block_mean)
commit_order = formula(commit_classes.commit_order)
discard_farthest = formula(voting.discard_farthest)
distance_from_mean = formula(voting.distance_from_mean)
neighbour_offsets = formula(candidates.neighbour_offsets)
patch_sum = formula(guide_maps.patch_sum)
penalization = formula(patch_penalization.penalization)
penalization_by_omega = formula(patch_penalization.penalization_by_omega)
propagation_candidate = formula(candidates.propagation_candidate)
random_candidate = formula(candidates.random_candidate)
random_words = formula(random_stream.random_words)
rounded_mean = formula(rounding.rounded_mean)
scaled_variance = formula(guide_maps.scaled_variance)
search_draw = formula(search_radii.search_draw)
search_radius = formula(search_radii.search_radius)
search_words = formula(search_radii.search_words)
take_proposal = formula(improve_assignment.take_proposal)
uniform_below = formula(philox.uniform_below)
upsampled_assignment = formula(candidates.upsampled_assignment)
voted_pixel = formula(voting.voted_pixel)
votes_kept = formula(voting.votes_kept)


@device_function
def _add(occurrences, y, x, change):
    cuda.atomic.add(occurrences, (y, x), change)


update_patch_omega = patch_penalization.make_update_patch_omega(device_function, _add)
update_omega_sums = patch_penalization.make_update_omega_sums(device_function, _add)
