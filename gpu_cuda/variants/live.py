"""Ω updated as in the thesis: by atomics, while the kernels run (3.2, 3.3).

The result depends on which thread comes first, so it is not reproducible. Tests check its
invariants (ΣΩ, Ω equals a recount) and its energy. Two forms:

:func:`live`
    ``ImproveAssignment`` as in 3.2: ρ sums w² elements of Ω, and every change of an assignment
    takes 2 w² atomics.
:func:`live_sums`
    ρ reads one element of W, Ω summed over each patch; a change takes 2 (2w - 1)² atomics.
"""

from functools import lru_cache

import numpy as np
from numba import cuda

from gpu_cuda.formulae import (
    neighbour_offsets,
    penalization,
    penalization_by_omega,
    propagation_candidate,
    random_candidate,
    random_words,
    search_draw,
    search_radius,
    search_words,
    update_omega_sums,
    update_patch_omega,
)
from gpu_cuda.host.argument_types import INT, MAP, METRIC, NNF, STREAM
from gpu_cuda.host.device import device_function, formula, launch
from gpu_cuda.metric.constants import MetricConstants
from gpu_cuda.metric.improve_proposal import NO_LIMIT, make_assignment_delta
from gpu_cuda.metric.target_patches import make_target_patch
from gpu_cuda.metric.textures import metric_arrays
from stylit_ref.formulae.candidates import PROPAGATION_DISTANCES
from stylit_ref.formulae.improve_assignment import make_improve_assignment
from stylit_ref.formulae.search_radii import number_of_radii
from stylit_ref.randomness.random_stream import RANDOM_SEARCH, random_stream


@lru_cache
def omega_kernels(constants):
    """Compile Kernel_Propagation and Kernel_RandomSearch of 3.3 with Ω.

    Parameters
    ----------
    constants : gpu_cuda.metric.constants.MetricConstants
    """
    patch_width = constants.patch_width

    @device_function
    def lambda_rho(omega, occurrence_weight, source_y, source_x):
        return penalization_by_omega(omega, occurrence_weight, patch_width, source_y, source_x)

    return _make_kernels(constants, lambda_rho, update_patch_omega)


@lru_cache
def omega_sums_kernels(constants):
    """Compile the same with W."""
    return _make_kernels(constants, penalization, update_omega_sums)


def _make_kernels(constants, lambda_rho, update):
    patch_width, radius = constants.patch_width, constants.radius
    assignment_delta = formula(make_assignment_delta(constants))
    target_patch = make_target_patch(constants, None, shared=False)

    @device_function
    def phi(metric_and_patch, occurrences, occurrence_weight, _, y, x, source_y, source_x):
        metric, patch = metric_and_patch
        return lambda_rho(occurrences, occurrence_weight, source_y, source_x) + assignment_delta(
            metric, patch, y, x, source_y, source_x, NO_LIMIT
        )

    improve_assignment = make_improve_assignment(device_function, phi, update)

    @cuda.jit
    def propagation_kernel(
        source, target, weights, guide_map, target_sums, source_sums, occurrences,
        occurrence_weight, nnf, new_nnf, distance,
    ):  # fmt: skip
        x, y = cuda.grid(2)
        height, width = nnf.shape[0], nnf.shape[1]
        if y >= height or x >= width:
            return
        source_height, source_width = occurrences.shape
        metric = source, source_width, weights, guide_map, target_sums, source_sums
        patch = target_patch(target, width, y, x)
        best_y, best_x = np.int64(nnf[y, x, 0]), np.int64(nnf[y, x, 1])
        if best_y >= 0:
            for dy, dx in neighbour_offsets(distance):
                near_y, near_x = y + dy, x + dx
                if near_y < 0 or near_y >= height or near_x < 0 or near_x >= width:
                    continue
                if nnf[near_y, near_x, 0] < 0:
                    continue
                candidate_y, candidate_x = propagation_candidate(
                    nnf[near_y, near_x, 0], nnf[near_y, near_x, 1], dy, dx,
                    radius, source_height, source_width,
                )  # fmt: skip
                best_y, best_x = improve_assignment(
                    (metric, patch), occurrences, occurrence_weight, patch_width, y, x,
                    np.int64(candidate_y), np.int64(candidate_x), best_y, best_x,
                )  # fmt: skip
        new_nnf[y, x, 0], new_nnf[y, x, 1] = best_y, best_x

    @cuda.jit
    def random_search_kernel(
        source, target, weights, guide_map, target_sums, source_sums, occurrences,
        occurrence_weight, nnf, stream, radii,
    ):  # fmt: skip
        x, y = cuda.grid(2)
        height, width = nnf.shape[0], nnf.shape[1]
        if y >= height or x >= width or nnf[y, x, 0] < 0:
            return
        source_height, source_width = occurrences.shape
        metric = source, source_width, weights, guide_map, target_sums, source_sums
        patch = target_patch(target, width, y, x)
        centre_y, centre_x = np.int64(nnf[y, x, 0]), np.int64(nnf[y, x, 1])
        best_y, best_x = centre_y, centre_x
        for k in range(radii):
            draw = random_words(stream, y * width + x, search_draw(k))
            word_y, word_x = search_words(draw, k)
            candidate_y, candidate_x = random_candidate(
                word_y, word_x, centre_y, centre_x, search_radius(k),
                radius, source_height, source_width,
            )  # fmt: skip
            best_y, best_x = improve_assignment(
                (metric, patch), occurrences, occurrence_weight, patch_width, y, x,
                np.int64(candidate_y), np.int64(candidate_x), best_y, best_x,
            )  # fmt: skip
        nnf[y, x, 0], nnf[y, x, 1] = best_y, best_x

    return propagation_kernel, random_search_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    for map_name, make_kernels in (("Ω", omega_kernels), ("W", omega_sums_kernels)):
        propagation_kernel, random_search_kernel = make_kernels(MetricConstants.of_sizes(sizes))
        first = *METRIC, MAP, INT, NNF
        yield f"live propagation, {map_name}", propagation_kernel, (*first, NNF, INT)
        yield f"live random search, {map_name}", random_search_kernel, (*first, STREAM, INT)


def propagate(level, make_kernels, occurrences, distance):
    """Kernel_Propagation of 3.3: computes NNF' from NNF, then swaps the two.

    Parameters
    ----------
    level : Level
    make_kernels : callable
        :func:`omega_kernels` or :func:`omega_sums_kernels`.
    occurrences : (H_A, W_A) int32
        The level's Ω or W; it is updated with every change.
    distance : int
    """
    kernel, _ = make_kernels(MetricConstants.of(level.textures, level.patch_width))
    launch(
        kernel, level.nnf.shape[:2], *metric_arrays(level.textures), occurrences,
        level.occurrence_weight, level.nnf, level.proposed_nnf, distance,
        races=True,
    )  # fmt: skip
    level.nnf, level.proposed_nnf = level.proposed_nnf, level.nnf


def search_at_random(level, make_kernels, occurrences, stream):
    """Kernel_RandomSearch of 3.3, in place; other parameters as for :func:`propagate`.

    Parameters
    ----------
    stream : tuple of 4 uint32
    """
    _, kernel = make_kernels(MetricConstants.of(level.textures, level.patch_width))
    size = level.nnf.shape[:2]
    launch(
        kernel, size, *metric_arrays(level.textures), occurrences,
        level.occurrence_weight, level.nnf, stream, number_of_radii(max(size)),
        races=True,
    )  # fmt: skip


def live(level, seed, level_number, vote, iteration):
    """GPU_PatchMatch of thesis 3.3: a PatchMatch iteration whose kernels change Ω as they run."""
    _iterate(level, omega_kernels, level.omega, seed, level_number, vote, iteration)


def live_sums(level, seed, level_number, vote, iteration):
    """The same with W, Ω summed over each patch, in place of Ω."""
    _iterate(level, omega_sums_kernels, level.omega_sums, seed, level_number, vote, iteration)


def _iterate(level, make_kernels, occurrences, seed, level_number, vote, iteration):
    for distance in PROPAGATION_DISTANCES:
        propagate(level, make_kernels, occurrences, distance)
    stream = random_stream(seed, RANDOM_SEARCH, level_number, vote, iteration)
    search_at_random(level, make_kernels, occurrences, stream)
    level.update_similarity()
    level.init_occurrence_map()
