r"""Occurrence map Ω and patch penalization ρ (thesis 2.1, procedures of 3.2).

Fixed point keeps the penalization exact. With
:math:`W(Q) = \sum_{pixels\ of\ Q} \Omega = w^2 \omega(Q)`, the term of the metric is

.. math:: \lambda \rho(Q) = \lambda \frac{\omega(Q)}{\omega_{best}}
          = \frac{\lambda}{w^2 \omega_{best}} W(Q),

one integer weight, ``occurrence_weight``, times an integer sum.
"""

from collections.abc import Callable

import numpy as np
from numba import njit
from numpy.typing import NDArray

from stylit_ref.machine.inlined import Compiler


def omega_best(patch_width: int, source_pixels: int, target_patches: int) -> float:
    """Ω of every source pixel if all were used equally often, ``w² |B| / |A|`` (thesis 2.1).

    ``target_patches`` is the number of assigned target patches: all pixels of the
    target, or those that a mask leaves to be synthesized.
    """
    return patch_width**2 * target_patches / source_pixels


@njit
def omega_sum(omega: NDArray[np.int32], patch_width: int, source_y: int, source_x: int) -> int:
    """W(Q): Ω summed over the patch around ``(source_y, source_x)``.

    PatchOmega of thesis 3.2 before its two divisions.
    """
    radius = patch_width // 2
    total = 0
    for dy in range(-radius, radius + 1):
        for dx in range(-radius, radius + 1):
            total += omega[source_y + dy, source_x + dx]
    return total


@njit(inline="always")
def penalization(
    omega_sums: NDArray[np.int32], occurrence_weight: int, source_y: int, source_x: int
) -> int:
    """λρ(Q) from W as an exact int64 in fixed point (thesis 2.1)."""
    return occurrence_weight * np.int64(omega_sums[source_y, source_x])


@njit
def penalization_by_omega(
    omega: NDArray[np.int32], occurrence_weight: int, patch_width: int, source_y: int, source_x: int
) -> int:
    """λρ(Q) from Ω itself, summed over the patch."""
    return occurrence_weight * np.int64(omega_sum(omega, patch_width, source_y, source_x))


def make_update_patch_omega(compiled: Compiler, add: Callable[..., None]) -> Callable[..., None]:
    """Compile UpdatePatchOmega (thesis 3.2).

    Parameters
    ----------
    compiled : callable
        Decorator: :func:`numba.njit`, or one that compiles a function for a GPU.
    add : callable
        ``(occurrences, y, x, change)``: adds to an element of a map.

    Returns
    -------
    callable
        ``(omega, patch_width, source_y, source_x, change)``: adds ``change`` to Ω under the patch.
    """

    @compiled
    def update_patch_omega(omega, patch_width, source_y, source_x, change):
        radius = patch_width // 2
        for dy in range(-radius, radius + 1):
            for dx in range(-radius, radius + 1):
                add(omega, source_y + dy, source_x + dx, change)

    return update_patch_omega


def make_update_omega_sums(compiled: Compiler, add: Callable[..., None]) -> Callable[..., None]:
    """Compile the update of W; parameters as above.

    The patch at offset ``(dy, dx)`` shares ``(w - |dy|) (w - |dx|)`` pixels with the assigned one.
    One update of W replaces UpdatePatchOmega and all sums over Ω that would follow it.

    Returns
    -------
    callable
        ``(omega_sums, patch_width, source_y, source_x, change)``: adds to W of every patch the
        effect of ``change`` assignments of one patch.
    """

    @compiled
    def update_omega_sums(omega_sums, patch_width, source_y, source_x, change):
        reach = patch_width - 1
        height, width = omega_sums.shape
        for dy in range(max(-reach, -source_y), min(reach, height - 1 - source_y) + 1):
            for dx in range(max(-reach, -source_x), min(reach, width - 1 - source_x) + 1):
                shared = (patch_width - abs(dy)) * (patch_width - abs(dx))
                add(omega_sums, source_y + dy, source_x + dx, change * shared)

    return update_omega_sums


@njit
def _add(occurrences, y, x, change):
    occurrences[y, x] += change


update_patch_omega: Callable[..., None] = make_update_patch_omega(njit, _add)
"""UpdatePatchOmega for a single thread."""

update_omega_sums: Callable[..., None] = make_update_omega_sums(njit, _add)
"""The update of W for a single thread."""
