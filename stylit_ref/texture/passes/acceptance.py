"""The exact change of the cost of S if a patch is written, and the writing."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import subroutine
from stylit_ref.texture.formulae.guide_cost import guide_cost
from stylit_ref.texture.formulae.seam_cost import edge_cost
from stylit_ref.texture.passes.layout import FREE_BELOW, FREE_RIGHT, Settings, Sources, Texture


@subroutine
def cost_change(
    texture: Texture,
    sources: Sources,
    settings: Settings,
    y: int,
    x: int,
    half_width: NDArray[np.int32],
    patch: NDArray[np.int32],
) -> int:
    """What S costs after a patch is written, less what it cost before.

    Summed over all pixels that change and their edges; the sum is exact.
    """
    before, after = costs_of_change(texture, sources, settings, y, x, half_width, patch)
    return after - before


@subroutine
def costs_of_change(
    texture: Texture,
    sources: Sources,
    settings: Settings,
    y: int,
    x: int,
    half_width: NDArray[np.int32],
    patch: NDArray[np.int32],
) -> tuple[int, int]:
    """What all pixels that a patch changes and their edges cost before it is written, and after."""
    before, after = np.int64(0), np.int64(0)
    for j in range(1, half_width.size - 1):
        row_before, row_after = costs_of_row(texture, sources, settings, y, x, half_width, patch, j)
        before += row_before
        after += row_after
    return before, after


@subroutine
def costs_of_row(
    texture: Texture,
    sources: Sources,
    settings: Settings,
    y: int,
    x: int,
    half_width: NDArray[np.int32],
    patch: NDArray[np.int32],
    j: int,
) -> tuple[int, int]:
    """The share of row ``j`` of the window; of the patch, this row and the next are read."""
    height, width = texture.addresses.shape
    side = half_width.size
    centre = side // 2
    row = (y + j - centre) % height
    below = row + 1 if row + 1 < height else 0
    colours, stride = sources.colours, settings.stride
    eta, exponent = settings.eta, settings.exponent
    # In a texture one pixel high every pixel is its own neighbour below; so it is with the width.
    to_right, to_below = (1 if width > 1 else 0), (side if height > 1 else 0)
    reach = min(half_width[j] + 1, centre - 1)
    place, end = j * side + centre - reach, j * side + centre + reach + 1
    column = (x - reach) % width
    before, after = np.int64(0), np.int64(0)
    while place < end:  # up to the last column of S at a time
        run = min(end - place, width - column)
        stretch = slice(column, column + run)
        here, new = texture.addresses[row, stretch], patch[place : place + run]
        new_right = patch[place + to_right : place + to_right + run]
        new_below = patch[place + to_below : place + to_below + run]
        seams_x, seams_y = texture.seams_x[row, stretch], texture.seams_y[row, stretch]
        lock = texture.lock[row, stretch]
        # Without a branch, for vector instructions; a & b is negative if both are OUTSIDE.
        for i in range(run):
            cost_x, cost_y, free = np.int64(seams_x[i]), np.int64(seams_y[i]), lock[i]
            stays_x = (new[i] & new_right[i]) < 0 or free & FREE_RIGHT != 0
            stays_y = (new[i] & new_below[i]) < 0 or free & FREE_BELOW != 0
            before += (0 if stays_x else cost_x) + (0 if stays_y else cost_y)
        for i in range(run):
            a, right, down = new[i], new_right[i], new_below[i]
            if a < 0 and right < 0 and down < 0:
                continue
            if settings.guide_weight and a >= 0:
                wanted, shown = texture.guide[row, column + i], sources.guide_colours
                before += guide_cost(shown[here[i]], wanted, settings.guide_weight)
                after += guide_cost(shown[a], wanted, settings.guide_weight)
            if a >= 0 and right == a + 1 and down == a + stride:
                continue  # a piece of the exemplar goes on
            free = lock[i]
            old_or_new = a if a >= 0 else here[i]
            if (a >= 0 or right >= 0) and not free & FREE_RIGHT:
                after_x = column + i + 1 if column + i + 1 < width else 0
                there = right if right >= 0 else texture.addresses[row, after_x]
                after += edge_cost(colours, old_or_new, there, 1, eta, exponent)
            if (a >= 0 or down >= 0) and not free & FREE_BELOW:
                there = down if down >= 0 else texture.addresses[below, column + i]
                after += edge_cost(colours, old_or_new, there, stride, eta, exponent)
        place += run
        column = 0
    return before, after


@subroutine
def inner_cost(
    patch: NDArray[np.int32],
    half_width: NDArray[np.int32],
    colours: NDArray[np.int32],
    settings: Settings,
) -> int:
    """E(P): what the seams between the pixels of a patch cost, which deformation made."""
    side = half_width.size
    stride, eta, exponent = settings.stride, settings.eta, settings.exponent
    total = np.int64(0)
    for place in range(patch.size - side):
        here, right, below = patch[place], patch[place + 1], patch[place + side]
        if here >= 0 and right >= 0:
            total += edge_cost(colours, here, right, 1, eta, exponent)
        if here >= 0 and below >= 0:
            total += edge_cost(colours, here, below, stride, eta, exponent)
    return total


@subroutine
def write_patch(
    texture: Texture,
    sources: Sources,
    settings: Settings,
    y: int,
    x: int,
    half_width: NDArray[np.int32],
    patch: NDArray[np.int32],
) -> None:
    """Write a patch into S, and what the edges cost that it touches."""
    addresses, seams_x, seams_y = texture.addresses, texture.seams_x, texture.seams_y
    colours, stride = sources.colours, settings.stride
    eta, exponent = settings.eta, settings.exponent
    height, width = addresses.shape
    side = half_width.size
    centre = side // 2
    to_right, to_below = (1 if width > 1 else 0), (side if height > 1 else 0)
    for j in range(1, side - 1):
        row = (y + j - centre) % height
        reach = min(half_width[j] + 1, centre - 1)
        column = (x - reach) % width
        first = j * side + centre - reach
        for place in range(first, first + 2 * reach + 1):
            if patch[place] >= 0:
                addresses[row, column] = patch[place]
            column = column + 1 if column + 1 < width else 0
    for j in range(1, side - 1):
        row = (y + j - centre) % height
        below = row + 1 if row + 1 < height else 0
        reach = min(half_width[j] + 1, centre - 1)
        column = (x - reach) % width
        first = j * side + centre - reach
        for place in range(first, first + 2 * reach + 1):
            right = column + 1 if column + 1 < width else 0
            free = texture.lock[row, column] if settings.has_lock else np.uint8(0)
            # The edges of a pixel beside the patch may be those of the next patch, too: each of
            # the two is written only if it is one of this patch.
            if (patch[place] >= 0 or patch[place + to_right] >= 0) and not free & FREE_RIGHT:
                seams_x[row, column] = edge_cost(
                    colours, addresses[row, column], addresses[row, right], 1, eta, exponent
                )
            if (patch[place] >= 0 or patch[place + to_below] >= 0) and not free & FREE_BELOW:
                seams_y[row, column] = edge_cost(
                    colours, addresses[row, column], addresses[below, column], stride, eta,
                    exponent,
                )  # fmt: skip
            column = right
