"""A square moves in front of a ground that moves the other way: all that is true of them."""

import numpy as np

from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.conventions import FrameMotion

SIZE = 20, 32
GROUND, SQUARE = (-1, 0), (3, 1)
"""(x, y) in pixels a frame."""
SIDE = 7


def labels_of(frame):
    """2 on the square, 1 on the ground."""
    labels = np.ones(SIZE, np.uint32)
    left, top = 5 + SQUARE[0] * frame, 4 + SQUARE[1] * frame
    labels[top : top + SIDE, left : left + SIDE] = 2
    return labels


def depth_of(frame):
    """The square is nearer."""
    return np.where(labels_of(frame) == 2, 5, 10).astype(np.float32)


def motion(frame, other):
    """The true motion of every pixel, and what the other frame shows."""
    on_square = (labels_of(frame) == 2)[:, :, None]
    field = (other - frame) * np.where(on_square, SQUARE, GROUND).astype(np.float32)
    y, x = np.mgrid[: SIZE[0], : SIZE[1]]
    row, column = (y + field[:, :, 1]).astype(int), (x + field[:, :, 0]).astype(int)
    inside = (row >= 0) & (row < SIZE[0]) & (column >= 0) & (column < SIZE[1])
    there = labels_of(other)[np.clip(row, 0, SIZE[0] - 1), np.clip(column, 0, SIZE[1] - 1)]
    return Motion(field, inside & (there == labels_of(frame)))


def picture(frame):
    """Noise on the ground and on the square, (H, W, 3) uint8."""
    rng = np.random.default_rng(0)
    wide = rng.integers(0, 256, (*SIZE, 3), dtype=np.uint8)
    seen = np.roll(wide, (GROUND[1] * frame, GROUND[0] * frame), axis=(0, 1))
    seen[labels_of(frame) == 2] = rng.integers(0, 256, (SIDE * SIDE, 3), dtype=np.uint8)
    return seen


def unmasked(motion):
    """The field alone, as most programs write it."""
    return Motion(motion.field, np.ones(SIZE, bool))


def frame_motion(frame, *, forward=True, backward=True):
    """What a file without a mask holds."""
    return FrameMotion(
        unmasked(motion(frame, frame + 1)) if forward else None,
        unmasked(motion(frame, frame - 1)) if backward else None,
    )
