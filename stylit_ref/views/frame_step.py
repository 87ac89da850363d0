"""Progress of a coherent run."""

from dataclasses import dataclass


@dataclass(frozen=True)
class FrameStep:
    """A frame has done a search-vote iteration of a level, or begun the level.

    Attributes
    ----------
    frame, frames : int
        The frame, from 0, and how many there are.
    name : str
        What the shot calls it.
    level, levels : int
        Pyramid level, 1 the coarsest, and their number.
    vote, votes : int
        Iterations that the frame has done at the level, 0 when it begins, and how many there are.
    done : float
        Share of the work of all frames that is done, up to 1. Whatever a work folder held counts
        as done.
    """

    frame: int
    frames: int
    name: str
    level: int
    levels: int
    vote: int
    votes: int
    done: float
