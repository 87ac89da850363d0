"""The target patches of a block in shared memory (thesis 5.1)."""

from math import prod

from numba import njit

from gpu_cuda.device import formula
from stylit_ref.errors import InputError

SHARED_BYTES = 48 << 10
"""Of a block, as every device has them."""


def tile_shape(block, radius, channels):
    """Rows, columns and channels of the tile that holds a block's patches: 36x36 for 32x32.

    Raises
    ------
    InputError
        If they take more shared memory than there is.
    """
    shape = block[1] + 2 * radius, block[0] + 2 * radius, channels
    if prod(shape) > SHARED_BYTES:
        raise InputError(
            f"target patches of a block of {block[0]}x{block[1]} threads take {prod(shape)} bytes "
            f"of shared memory at patch width {2 * radius + 1}; {SHARED_BYTES} are there"
        )
    return shape


@formula
@njit
def fill_tile(target, tile, radius, first_y, first_x, thread_y, thread_x):
    """Copy one thread's share of the tile (lines 8 to 16 of the listing in 5.1.2).

    Each thread copies its own pixel, and those at the top and left also the ones a block further
    down and right, which make the border. A synchronization must follow.

    Parameters
    ----------
    target : (H_B + 2 radius, W_B + 2 radius, C) uint8
    tile : (rows + 2 radius, columns + 2 radius, C) uint8
        Shared memory of a block of as many rows and columns of threads.
    radius, first_y, first_x : int
        Patch radius, and the block's first patch.
    thread_y, thread_x : int
        Of the thread in its block.
    """
    for tile_y in range(thread_y, tile.shape[0], tile.shape[0] - 2 * radius):
        y = min(first_y + tile_y, target.shape[0] - 1)
        for tile_x in range(thread_x, tile.shape[1], tile.shape[1] - 2 * radius):
            x = min(first_x + tile_x, target.shape[1] - 1)
            for c in range(tile.shape[2]):
                tile[tile_y, tile_x, c] = target[y, x, c]
