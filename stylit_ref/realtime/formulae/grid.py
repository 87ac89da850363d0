"""The sparse grid of the target (section 3.4.2, equation 8), and where patches may lie.

Entry ``(a, b)`` stands at pixel ``(a * step, b * step)``. With a step of ``(width + 1) / 2`` at
most four patches cover a pixel: those of the grid's cell that it lies in.
"""

from numba import njit


def grid_size(pixels: int, step: int) -> int:
    """Entries along a side."""
    return -(-pixels // step)


def level_size(pixels: int, level: int) -> int:
    """Pixels along a side at a level; 0 is the finest, and halves are rounded up."""
    return -(-pixels // (1 << level))


def covered_from_left(step: int, radius: int) -> tuple[bool, ...]:
    """For each pixel of a cell whether the patch at its beginning covers it."""
    return tuple(pixel <= radius for pixel in range(step))


def covered_from_right(step: int, radius: int) -> tuple[bool, ...]:
    """For each pixel of a cell whether the patch of the next entry covers it."""
    return tuple(step - pixel <= radius for pixel in range(step))


@njit
def first_centre(pixels: int, radius: int) -> int:
    """The least coordinate of a patch's centre in the source; patches lie inside if they can."""
    return min(radius, (pixels - 1) // 2)


@njit
def last_centre(pixels: int, radius: int) -> int:
    """The greatest coordinate of a patch's centre in the source."""
    return max(pixels - 1 - radius, (pixels - 1) // 2)


@njit
def is_of_half(row: int, column: int, parity: int) -> bool:
    """Whether an entry is searched in a half iteration (figure 20): its four neighbours are not."""
    return (row + column + parity) % 2 == 0


@njit
def covering_entries(pixel: int, step: int, radius: int, entries: int) -> tuple[int, int]:
    """The first and the last entry along a side whose patches cover a pixel."""
    first = pixel // step
    offset = pixel - first * step
    last = first + 1 if step - offset <= radius and first + 1 < entries else first
    return (last if offset > radius else first), last
