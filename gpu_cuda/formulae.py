"""The formulae as kernels call them: none is written again here."""

from gpu_cuda.host.device import formula
from stylit_ref.formulae import candidates, patch_penalization, rounding
from stylit_ref.formulae import guide_map as guide_maps
from stylit_ref.randomness import commit_classes, philox, random_stream

block_mean = formula(rounding.block_mean)
commit_order = formula(commit_classes.commit_order)
patch_omega = formula(patch_penalization.patch_omega)
patch_sum = formula(guide_maps.patch_sum)
penalization = formula(patch_penalization.penalization)
propagation_candidate = formula(candidates.propagation_candidate)
random_candidate = formula(candidates.random_candidate)
random_words = formula(random_stream.random_words)
rounded_mean = formula(rounding.rounded_mean)
scaled_variance = formula(guide_maps.scaled_variance)
uniform_below = formula(philox.uniform_below)
upsampled_assignment = formula(candidates.upsampled_assignment)
