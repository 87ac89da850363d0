"""The motion between any two frames of a sequence, from what their files hold."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.notes import note
from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.composition import composed
from stylit_ref.views.motion.conventions import FrameMotion
from stylit_ref.views.motion.inversion import inverted, unhidden
from stylit_ref.views.motion.silhouettes import along_silhouettes, silhouettes_of
from stylit_ref.views.motion.visibility import cancelling, same_labels

_WITHOUT_SILHOUETTES = (
    "neither depth nor IDs are known of both frames, so strokes beside a silhouette move with what "
    "lies behind them"
)


def motion_between(
    to: int,
    other: int,
    motion_of: Callable[[int], FrameMotion | None],
    *,
    depth_of: Callable[[int], NDArray[np.float32] | None] | None = None,
    labels_of: Callable[[int], NDArray[np.integer[Any]] | None] | None = None,
) -> Motion:
    """The motion from frame ``to`` into frame ``other``.

    Vectors lead from a frame to the next one or to the one before. Where they lead the wrong way
    only, they are turned around by splatting. Over several frames they are composed.

    What the other frame shows is what the mask of the file says; without a mask, where motion forth
    and back cancels; without motion back, what no other pixel of the frame covers. With IDs, a
    pixel must also lead to its own ID. Then strokes beside silhouettes take the motion of what they
    belong to (:mod:`stylit_ref.views.motion.silhouettes`), by the depth of the two frames, or by
    their IDs where depth is not known of both. If neither is, a note says so.

    Parameters
    ----------
    to, other : int
        Numbers of frames, two different ones.
    motion_of : callable
        What the file of a frame holds, by the frame's number; None without a file. For instance a
        cached :func:`stylit_ref.views.motion.reading.read_motion`.
    depth_of, labels_of : callables, optional
        Depth, (H, W) float32, farther is larger, and IDs, (H, W) of whole numbers, of a frame; None
        where they are not known.

    Returns
    -------
    Motion

    Raises
    ------
    InputError
        If vectors of a frame between are missing, or frames differ in size.
    """
    step = 1 if other > to else -1
    steps = [
        _step(frame, frame + step, motion_of, depth_of, labels_of)
        for frame in range(to, other, step)
    ]
    whole = steps[0]
    for motion in steps[1:]:
        whole = composed(whole, motion)
    depths, labels = (_of_both((to, other), what_of) for what_of in (depth_of, labels_of))
    here, there = map(silhouettes_of, depths, labels)
    if here is None or there is None:
        note(_WITHOUT_SILHOUETTES)
        return whole
    return along_silhouettes(whole, here, there)


def _step(frame, after, motion_of, depth_of, labels_of):
    """The motion from a frame into a neighbouring one."""
    here = _known(frame, motion_of)
    ahead = here.towards(after - frame)
    if ahead is not None and here.tells_visible:
        motion = ahead  # and nothing needs the motion back
    else:
        motion = _compared(frame, after, ahead, motion_of, depth_of)
    labels, others = _of_both((frame, after), labels_of)
    if labels is None or others is None:
        return motion
    return Motion(motion.field, motion.visible & same_labels(motion, labels, others))


def _compared(frame, after, ahead, motion_of, depth_of):
    """The motion whose visibility, or all of it, is found from the motion back."""
    back = _known(after, motion_of).towards(frame - after)
    if ahead is not None and back is not None:
        _check_sizes(frame, after, ahead.visible.shape, back.visible.shape)
        return Motion(ahead.field, cancelling(ahead, back))
    if ahead is None and back is None:
        raise InputError(_why_unknown(frame, after))
    depth = depth_of(frame if ahead is not None else after) if depth_of else None
    if ahead is None:
        return inverted(back, depth)
    return Motion(ahead.field, unhidden(ahead, depth))


def _of_both(frames, what_of):
    """What is known of two frames, which can only be compared if it is known of both."""
    found = tuple(what_of(frame) for frame in frames) if what_of else (None, None)
    return (None, None) if any(each is None for each in found) else found


def _known(number, motion_of):
    return motion_of(number) or FrameMotion(None, None)


def _check_sizes(frame, after, size, other_size):
    if size != other_size:
        raise InputError(
            f"the motion of frame {frame} is {size[1]}x{size[0]} and that of frame {after} "
            f"{other_size[1]}x{other_size[0]}; all frames must have the same size"
        )


def _why_unknown(frame, after):
    ways = ("forward", "backward") if after > frame else ("backward", "forward")
    return (
        f"nothing tells the motion from frame {frame} to frame {after}: there are neither "
        f"{ways[0]} vectors of frame {frame} nor {ways[1]} vectors of frame {after}; render them, "
        "or leave no frame out"
    )
