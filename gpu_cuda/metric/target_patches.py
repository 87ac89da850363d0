"""Read a thread's target patch from B̄ itself, or from shared memory (thesis 5.1)."""

from numba import cuda, njit, uint32

from gpu_cuda.host.device import device_function, formula
from stylit_ref.errors import InputError

SHARED_BYTES = 48 << 10
"""Bytes of shared memory that every device offers a block."""


def make_target_patch(constants, block, shared):
    """Compile the function that finds a thread's target patch.

    Parameters
    ----------
    constants : gpu_cuda.metric.constants.MetricConstants
    block : (int, int)
        Threads of a block along x and y.
    shared : bool
        Whether the block copies its patches to shared memory first.

    Returns
    -------
    callable
        ``(target, width, y, x) -> (words, first, pixel, row)``: an array of words, where in it
        the patch begins, and how many words further the next pixel and the next row are.
        ``target`` is B̄ in words, ``width`` that of the target. All threads of a block must call
        it.

    Raises
    ------
    InputError
        If the patches take more shared memory than there is.
    """
    radius, border, pixel_words = constants.radius, 2 * constants.radius, constants.pixel_words

    @device_function
    def in_texture(target, width, y, x):
        row = (width + border) * pixel_words
        return target, y * row + x * pixel_words, pixel_words, row

    if not shared:
        return in_texture

    weighted_words = constants.weighted_words
    columns, rows = block[0] + border, block[1] + border
    tile_pixel = weighted_words | 1  # an odd number: neighbours lie in different banks
    size = rows * columns * tile_pixel
    if 4 * size > SHARED_BYTES:
        raise InputError(
            f"target patches of a block of {block[0]}x{block[1]} threads take {4 * size} bytes "
            f"of shared memory at patch width {2 * radius + 1}, but only {SHARED_BYTES} exist; "
            "use a smaller patch or another backend"
        )

    @formula
    @njit
    def fill_tile(target, width, height, tile, first_y, first_x, thread_y, thread_x):
        """Copy one thread's share of the tile (lines 8 to 16 of the listing in 5.1.2).

        Each thread copies its own pixel. Threads at the top and left also copy the pixels one block
        further down and right, which form the border.
        """
        for tile_y in range(thread_y, rows, rows - border):
            y = min(first_y + tile_y, height - 1)
            for tile_x in range(thread_x, columns, columns - border):
                x = min(first_x + tile_x, width - 1)
                for word in range(weighted_words):
                    tile[(tile_y * columns + tile_x) * tile_pixel + word] = target[
                        (y * width + x) * pixel_words + word
                    ]

    @device_function
    def in_tile(target, width, y, x):
        tile = cuda.shared.array(size, uint32)
        thread_y, thread_x = cuda.threadIdx.y, cuda.threadIdx.x
        padded_width = width + border
        padded_height = target.size // (padded_width * pixel_words)
        fill_tile(
            target, padded_width, padded_height, tile, y - thread_y, x - thread_x,
            thread_y, thread_x,
        )  # fmt: skip
        cuda.syncthreads()
        first = (thread_y * columns + thread_x) * tile_pixel
        return tile, first, tile_pixel, columns * tile_pixel

    return in_tile
