"""UpdatePatchOmega (thesis 3.2): many threads at once, so by atomic additions.

As the formulae of the same names. Additions of integers: the order in which threads come does not
change the map.
"""

from numba import cuda

from gpu_cuda.host.device import device_function


@device_function
def update_patch_omega(omega, patch_width, source_y, source_x, change):
    """Add ``change`` to Ω under the patch."""
    radius = patch_width // 2
    for dy in range(-radius, radius + 1):
        for dx in range(-radius, radius + 1):
            cuda.atomic.add(omega, (source_y + dy, source_x + dx), change)


@device_function
def update_omega_sums(omega_sums, patch_width, source_y, source_x, change):
    """Add to W of every patch what ``change`` assignments of one patch add to Ω."""
    reach = patch_width - 1
    for dy in range(max(-reach, -source_y), min(reach, omega_sums.shape[0] - 1 - source_y) + 1):
        for dx in range(max(-reach, -source_x), min(reach, omega_sums.shape[1] - 1 - source_x) + 1):
            shared = (patch_width - abs(dy)) * (patch_width - abs(dx))
            cuda.atomic.add(omega_sums, (source_y + dy, source_x + dx), change * shared)
