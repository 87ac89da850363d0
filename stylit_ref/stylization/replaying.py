"""``replay``: another style image through a saved nearest-neighbour field."""

import logging
from numbers import Integral
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.notes import note
from stylit_ref.passes import replay_vote
from stylit_ref.stylization.checks import size_text

Value = TypeVar("Value", bound=np.uint8 | np.uint16 | np.float32)


def replay(
    nnf: NDArray[np.int32], style: NDArray[Value], *, patch_width: int = 5, scale: int = 1
) -> NDArray[Value]:
    """Vote a style image through a nearest-neighbour field, at its own bit depth.

    With the style, the NNF and the patch width of a run the result is that run's
    image. The style may also be another rendition of the same size (16 bit, float,
    other colours), or an enlargement.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
        From :class:`stylit_ref.Result`; negative where nothing is assigned.
    style : (H, W) or (H, W, n) uint8, uint16 or float32
        ``scale`` times the size of the style the NNF was made with.
    patch_width : int
        The patch width of the run.
    scale : int
        How many times larger the style is.

    Returns
    -------
    (scale * H_B, scale * W_B) or (scale * H_B, scale * W_B, n) of the style's dtype
        Means of integers are rounded half up. Pixels that no assigned patch covers
        are 0.

    Raises
    ------
    InputError
        If the array cannot be an NNF, or points outside the style.
    """
    nnf, style = as_array(nnf, "nnf"), as_array(style, "style")
    if nnf.dtype != np.int32 or nnf.ndim != 3 or nnf.shape[2] != 2 or 0 in nnf.shape:
        raise InputError(
            f"is {nnf.dtype} of shape {nnf.shape}; it must be int32 of shape (H, W, 2)",
            parameter="nnf",
        )
    if style.dtype not in (np.uint8, np.uint16, np.float32):
        raise InputError(
            f"has dtype {style.dtype}; it must be uint8, uint16 or float32", parameter="style"
        )
    if style.ndim not in (2, 3) or 0 in style.shape:
        raise InputError(
            f"has shape {style.shape}; it must be (H, W) or (H, W, channels)", parameter="style"
        )
    if not isinstance(patch_width, Integral) or patch_width % 2 == 0 or not 1 <= patch_width <= 63:
        raise InputError(
            f"is {patch_width}; it must be an odd integer from 1 to 63", parameter="patch_width"
        )
    if not isinstance(scale, Integral) or scale < 1:
        raise InputError(f"is {scale}; it must be a positive integer", parameter="scale")
    if style.shape[0] % scale or style.shape[1] % scale:
        raise InputError(
            f"is {size_text(style.shape)}; its sides must be multiples of the scale {scale}",
            parameter="style",
        )
    radius = patch_width // 2
    assigned = nnf[nnf[:, :, 0] >= 0]
    limit = np.array(style.shape[:2]) // scale - 1 - radius
    if assigned.size and ((assigned < radius).any() or (assigned > limit).any()):
        low, high = assigned.min(axis=0).tolist(), assigned.max(axis=0).tolist()
        raise InputError(
            f"points to source pixels (y, x) from {low} to {high}, but a style of "
            f"{size_text(style.shape)} at scale {scale} has patches of width "
            f"{patch_width} only from {[radius, radius]} to {limit.tolist()}",
            parameter="nnf",
        )
    if assigned.size and (assigned.max(axis=0) * 2 < limit).all():
        note(
            f"is {scale}, but the NNF uses less than half of the style's "
            f"{size_text(style.shape)}; if the style is an enlargement, give a larger scale",
            parameter="scale",
            level=logging.WARNING,
        )
    image = style if style.ndim == 3 else style[:, :, None]
    means = np.zeros((nnf.shape[0] * scale, nnf.shape[1] * scale, image.shape[2]))
    replay_vote(np.ascontiguousarray(image), means, np.ascontiguousarray(nnf), patch_width, scale)
    if style.dtype != np.float32:
        means = np.floor(means + 0.5)
    return means.astype(style.dtype).reshape(*means.shape[:2], *style.shape[2:])
