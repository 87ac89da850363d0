"""Masks of ``texture`` and ``edit-texture``."""

import logging

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.picture import read_picture
from stylit_ref.files.read_image import read_mask
from stylit_ref.notes import note

_MANY_GREYS, _LEVELS_OF_A_DRAWING = 0.2, 16
"""A mask with more of both is hardly one that was drawn, even with soft edges."""


def read_mask_of(path: str, size: tuple[int, int], what: str) -> NDArray[np.bool_]:
    """Read what is white in a mask of ``what``, which has this height and width.

    A note tells of a mask that looks like a photograph.

    Raises
    ------
    InputError
        If it cannot be read, or has another size.
    """
    white = read_mask(path)
    if white.shape != size:
        raise InputError(
            f"{path}: has {white.shape[1]} x {white.shape[0]} pixels, and {what} {size[1]} x "
            f"{size[0]}; make it as large"
        )
    pixels, alpha_channel = read_picture(path)[:2]
    most = 1 if pixels.dtype == np.float32 else np.iinfo(pixels.dtype).max
    shown = pixels[:, :, :alpha_channel].mean(axis=2) / most
    greys = shown[(shown > 0.1) & (shown < 0.9)]
    share = greys.size / shown.size
    if share > _MANY_GREYS and len(np.unique(greys)) > _LEVELS_OF_A_DRAWING:
        note(
            f"{path}: {share:.0%} of it is neither black nor white; a mask is white where it is at "
            "least half as bright as it can be",
            level=logging.WARNING,
        )
    return white
