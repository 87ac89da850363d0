"""Find what someone asks to look at."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError, shown
from stylit_ref.studio.engine.follower import Follower
from stylit_ref.studio.engine.looks import as_colours, nnf_picture, usage_picture
from stylit_ref.studio.engine.shown import Shown

_KNOWN = "style, nnf, usage, level:N, A:BUFFER or B:BUFFER"


def picture_of(what: str, follower: Follower, last: Callable[[], Shown]) -> NDArray[np.uint8]:
    """A picture to look at.

    Parameters
    ----------
    what : str
        ``style``, the painting; ``A:LDE`` or ``B:LDE``, a buffer; ``level:2``, B' of a level;
        ``nnf`` or ``usage`` of the picture that was shown last.
    follower : Follower
    last : callable
        The picture that was shown last.

    Returns
    -------
    (H, W, 3) uint8

    Raises
    ------
    InputError
        If there is no such thing, or not yet.
    """
    kind, _, name = what.partition(":")
    match kind, name:
        case "style", "":
            return follower.painting.copy()
        case "nnf", "":
            return nnf_picture(last().field, follower.scene.size)
        case "usage", "":
            return usage_picture(last().field, follower.scene.size)
        case "level", number if number.isascii() and number.isdigit():
            return follower.level_picture(int(number))
        case "A" | "B", _:
            scene = follower.scene
            buffers = scene.source if kind == "A" else scene.target(follower.step)
            if name not in buffers:
                raise InputError(
                    f"no buffer is called {shown(name)}; there are {', '.join(buffers)}"
                )
            return as_colours(buffers[name])
    raise InputError(f"nothing is called {shown(what)} to look at; say {_KNOWN}")
