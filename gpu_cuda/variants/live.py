"""Ω as the thesis updates it: while the kernels run, with atomics (3.2, 3.3).

Not reproducible, since it depends on which thread comes first; judged by what must hold
(ΣΩ, Ω equals a recount) and by its energy. Two forms:

``ImproveAssignment`` as in 3.2
    ρ sums w² elements of Ω, and every change of an assignment is 2 w² atomics.
with W
    ρ is one read of W, Ω summed over each patch, and a change is 2 (2w - 1)² atomics.
"""

from functools import lru_cache

import numpy as np
from numba import cuda

from gpu_cuda.formulae import (
    omega_sum,
    penalization,
    propagation_candidate,
    random_candidate,
    random_words,
    search_draw,
    search_radius,
    search_words,
)
from gpu_cuda.host.device import device_function, formula, launch
from gpu_cuda.improve_proposal import NO_LIMIT, make_assignment_delta
from gpu_cuda.metric import MetricConstants, metric_arrays
from gpu_cuda.patch_penalization import update_omega_sums, update_patch_omega
from gpu_cuda.target_patches import make_target_patch
from stylit_ref.formulae.candidates import PROPAGATION_DISTANCES
from stylit_ref.formulae.improve_assignment import make_improve_assignment
from stylit_ref.formulae.search_radii import number_of_radii
from stylit_ref.randomness.random_stream import RANDOM_SEARCH, random_stream


@lru_cache
def make_kernels(constants, with_sums):
    """Compile Kernel_Propagation and Kernel_RandomSearch of 3.3.

    Parameters
    ----------
    constants : gpu_cuda.metric.MetricConstants
    with_sums : bool
        Whether the map is W, not Ω.
    """
    patch_width, radius = constants.patch_width, constants.radius
    assignment_delta = formula(make_assignment_delta(constants))
    target_patch = make_target_patch(constants, None, shared=False)
    update = update_omega_sums if with_sums else update_patch_omega

    @device_function
    def lambda_rho(occurrences, occurrence_weight, source_y, source_x):
        if with_sums:
            return penalization(occurrences, occurrence_weight, source_y, source_x)
        return occurrence_weight * np.int64(omega_sum(occurrences, patch_width, source_y, source_x))

    @device_function
    def phi(metric_and_patch, occurrences, occurrence_weight, _, y, x, source_y, source_x):
        metric, patch = metric_and_patch
        return lambda_rho(occurrences, occurrence_weight, source_y, source_x) + assignment_delta(
            metric, patch, y, x, source_y, source_x, NO_LIMIT
        )

    improve_assignment = make_improve_assignment(device_function, phi, update)

    @cuda.jit
    def propagation_kernel(
        source, target, weights, guide_map, target_sums, source_sums, omega, occurrence_weight,
        nnf, new_nnf, distance,
    ):  # fmt: skip
        x, y = cuda.grid(2)
        height, width = nnf.shape[0], nnf.shape[1]
        if y >= height or x >= width:
            return
        metric = source, omega.shape[1], weights, guide_map, target_sums, source_sums
        patch = target_patch(target, width, y, x)
        best_y, best_x = np.int64(nnf[y, x, 0]), np.int64(nnf[y, x, 1])
        if best_y >= 0:
            for dy, dx in ((0, distance), (distance, 0), (0, -distance), (-distance, 0)):
                near_y, near_x = y + dy, x + dx
                if near_y < 0 or near_y >= height or near_x < 0 or near_x >= width:
                    continue
                if nnf[near_y, near_x, 0] < 0:
                    continue
                candidate_y, candidate_x = propagation_candidate(
                    nnf[near_y, near_x, 0], nnf[near_y, near_x, 1], dy, dx,
                    radius, omega.shape[0], omega.shape[1],
                )  # fmt: skip
                best_y, best_x = improve_assignment(
                    (metric, patch), omega, occurrence_weight, patch_width, y, x,
                    np.int64(candidate_y), np.int64(candidate_x), best_y, best_x,
                )  # fmt: skip
        new_nnf[y, x, 0], new_nnf[y, x, 1] = best_y, best_x

    @cuda.jit
    def random_search_kernel(
        source, target, weights, guide_map, target_sums, source_sums, omega, occurrence_weight,
        nnf, stream, radii,
    ):  # fmt: skip
        x, y = cuda.grid(2)
        height, width = nnf.shape[0], nnf.shape[1]
        if y >= height or x >= width or nnf[y, x, 0] < 0:
            return
        metric = source, omega.shape[1], weights, guide_map, target_sums, source_sums
        patch = target_patch(target, width, y, x)
        centre_y, centre_x = np.int64(nnf[y, x, 0]), np.int64(nnf[y, x, 1])
        best_y, best_x = centre_y, centre_x
        for k in range(radii):
            draw = random_words(stream, y * width + x, search_draw(k))
            word_y, word_x = search_words(draw, k)
            candidate_y, candidate_x = random_candidate(
                word_y, word_x, centre_y, centre_x, search_radius(k),
                radius, omega.shape[0], omega.shape[1],
            )  # fmt: skip
            best_y, best_x = improve_assignment(
                (metric, patch), omega, occurrence_weight, patch_width, y, x,
                np.int64(candidate_y), np.int64(candidate_x), best_y, best_x,
            )  # fmt: skip
        nnf[y, x, 0], nnf[y, x, 1] = best_y, best_x

    return propagation_kernel, random_search_kernel


def live_propagation(
    textures, occurrences, are_sums, occurrence_weight, patch_width, nnf, new_nnf, distance
):
    """Kernel_Propagation of 3.3, Ω (or W, if ``are_sums``) following by atomics.

    Parameters
    ----------
    textures : Textures
    occurrences : (H_A, W_A) int32
    are_sums : bool
    occurrence_weight, patch_width : int
    nnf, new_nnf : (H_B, W_B, 2) int32
        NNF and NNF' of the thesis.
    distance : int
    """
    kernel, _ = make_kernels(MetricConstants.of(textures, patch_width), are_sums)
    launch(
        kernel, nnf.shape[:2], *metric_arrays(textures), occurrences, occurrence_weight,
        nnf, new_nnf, distance,
    )  # fmt: skip


def live_random_search(
    textures, occurrences, are_sums, occurrence_weight, patch_width, nnf, stream
):
    """Kernel_RandomSearch of 3.3, parameters as for :func:`live_propagation`."""
    _, kernel = make_kernels(MetricConstants.of(textures, patch_width), are_sums)
    launch(
        kernel, nnf.shape[:2], *metric_arrays(textures), occurrences, occurrence_weight,
        nnf, stream, number_of_radii(max(nnf.shape[:2])),
    )  # fmt: skip


def live(level, seed, level_number, vote, iteration):
    """GPU_PatchMatch of thesis 3.3: a PatchMatch iteration whose kernels change Ω as they run."""
    _iterate(level, level.omega, False, seed, level_number, vote, iteration)


def live_sums(level, seed, level_number, vote, iteration):
    """The same with W, Ω summed over each patch, in the place of Ω."""
    _iterate(level, level.omega_sums, True, seed, level_number, vote, iteration)


def _iterate(level, occurrences, are_sums, seed, level_number, vote, iteration):
    metric = level.textures, occurrences, are_sums, level.occurrence_weight, level.patch_width
    for distance in PROPAGATION_DISTANCES:
        live_propagation(*metric, level.nnf, level.proposed_nnf, distance)
        level.nnf, level.proposed_nnf = level.proposed_nnf, level.nnf
    stream = random_stream(seed, RANDOM_SEARCH, level_number, vote, iteration)
    live_random_search(*metric, level.nnf, stream)
    level.update_similarity()
    level.init_occurrence_map()
