"""Where a coarser level's match points to on the next finer one."""

from numba import njit


@njit
def upsampled(position: int, step: int, entry: int, parent: int) -> int:
    """A coordinate of a patch, from that of the entry's parent.

    Positions double, and so do the parent's place in the target: the rest of the way is the same in
    source and target.
    """
    return 2 * position + step * (entry - 2 * parent)
