"""UpdatePatchOmega (thesis 3.2): many threads at once, so by atomic additions.

Additions of integers: the order in which threads come does not change the map.
"""

from functools import lru_cache

from numba import cuda

from gpu_cuda.host.device import device_function


@lru_cache
def make_atomic_updates(patch_width):
    """Compile UpdatePatchOmega (3.2) and the same for W.

    Returns
    -------
    update_patch_omega, update_omega_sums : callable
        ``(map, source_y, source_x, change)``: as the formulae of those names in
        :mod:`stylit_ref.formulae.patch_penalization`, atomic.
    """
    radius, reach = patch_width // 2, patch_width - 1

    @device_function
    def update_patch_omega(omega, source_y, source_x, change):
        for dy in range(-radius, radius + 1):
            for dx in range(-radius, radius + 1):
                cuda.atomic.add(omega, (source_y + dy, source_x + dx), change)

    @device_function
    def update_omega_sums(omega_sums, source_y, source_x, change):
        for dy in range(max(-reach, -source_y), min(reach, omega_sums.shape[0] - 1 - source_y) + 1):
            for dx in range(
                max(-reach, -source_x), min(reach, omega_sums.shape[1] - 1 - source_x) + 1
            ):
                shared = (patch_width - abs(dy)) * (patch_width - abs(dx))
                cuda.atomic.add(omega_sums, (source_y + dy, source_x + dx), change * shared)

    return update_patch_omega, update_omega_sums
