"""When a match of the last frame has grown old (ours; the thesis begins every frame anew)."""

from numba import njit

OLD = 4
"""How many times the guides of an old match differ as much as those of a fresh one."""


@njit
def coarse(position: int, level: int) -> int:
    """A coordinate of a patch of level 0 at a coarser level."""
    return position >> level


@njit
def fine(position: int, level: int, step: int, entry: int, parent: int) -> int:
    """A coordinate of a patch of level 0, from that of the entry ``parent`` of a coarser level.

    Positions grow, and so does the parent's place in the target: the rest of the way is the same in
    source and target.
    """
    return (position << level) + step * (entry - (parent << level))


@njit
def is_old(own: int, fresh: int) -> bool:
    """Whether a match has grown old, by the guides' distances of it and of a fresh one."""
    return own > OLD * fresh
