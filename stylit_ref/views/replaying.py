"""``replay_run``: another style through all frames of a RUN."""

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from stylit_ref.stylization.replaying import replay
from stylit_ref.views.run_folder import Run

Value = TypeVar("Value", bound=np.uint8 | np.uint16 | np.float32)


class ReplayedFrame(NamedTuple):
    """A frame of a RUN in another style.

    Attributes
    ----------
    frame : int
    name : str
    image : array
        As of :func:`stylit_ref.replay`.
    """

    frame: int
    name: str
    image: NDArray[np.uint8 | np.uint16 | np.float32]


def replay_run(
    run: Run | str | Path, style: NDArray[Value], *, scale: int | None = None
) -> Iterator[ReplayedFrame]:
    """Vote a style image through the fields of all frames, at its own bit depth.

    With the style of the RUN the images are its pictures. The style may also be another rendition
    of the same size (16 bit, float, other colours), or an enlargement.

    Parameters
    ----------
    run : Run, str or Path
        A RUN, or its folder.
    style : (H, W) or (H, W, n) uint8, uint16 or float32
        ``scale`` times the size of the RUN's style.
    scale : int, optional
        By default what the sizes say.

    Yields
    ------
    ReplayedFrame
        One after the other; a frame is read when it is its turn.

    Raises
    ------
    InputError
        If the folder is no RUN, a file of it is damaged, or the style has another size.
    """
    run = run if isinstance(run, Run) else Run(run)
    for frame, name in enumerate(run.names):
        yield ReplayedFrame(frame, name, replay(run.field(frame), style, scale=scale))
