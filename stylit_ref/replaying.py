"""``replay``: another style image through a saved nearest-neighbour field."""

import numpy as np
from numba import njit, prange

from stylit_ref.errors import InputError


@njit(parallel=True)
def _vote_scaled(style, output, nnf, radius, scale):
    """Mean of the votes, as :func:`stylit_ref.passes.vote.vote`, ``scale`` pixels for one."""
    height, width = nnf.shape[:2]
    for fine_y in prange(output.shape[0]):
        totals = np.zeros(style.shape[2], np.float64)
        y, offset_y = fine_y // scale, fine_y % scale
        for fine_x in range(output.shape[1]):
            x, offset_x = fine_x // scale, fine_x % scale
            totals[:] = 0
            votes = 0
            for near_y in range(max(y - radius, 0), min(y + radius + 1, height)):
                for near_x in range(max(x - radius, 0), min(x + radius + 1, width)):
                    if nnf[near_y, near_x, 0] >= 0:
                        source_y = (nnf[near_y, near_x, 0] - (near_y - y)) * scale + offset_y
                        source_x = (nnf[near_y, near_x, 1] - (near_x - x)) * scale + offset_x
                        for c in range(style.shape[2]):
                            totals[c] += style[source_y, source_x, c]
                        votes += 1
            if votes:
                output[fine_y, fine_x] = totals / votes


def replay(
    nnf: np.ndarray, style: np.ndarray, *, patch_width: int = 5, scale: int = 1
) -> np.ndarray:
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
        The run's.
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
        If the NNF is not one, or points outside the style.
    """
    nnf, style = np.asarray(nnf), np.asarray(style)
    if nnf.dtype != np.int32 or nnf.ndim != 3 or nnf.shape[2] != 2 or 0 in nnf.shape:
        raise InputError(
            f"the NNF is {nnf.dtype} of shape {nnf.shape}; it must be int32 of shape (H, W, 2)"
        )
    if style.dtype not in (np.uint8, np.uint16, np.float32):
        raise InputError(f"style has dtype {style.dtype}; it must be uint8, uint16 or float32")
    if style.ndim not in (2, 3) or 0 in style.shape:
        raise InputError(f"style has shape {style.shape}; it must be (H, W) or (H, W, channels)")
    if patch_width < 1 or patch_width % 2 == 0:
        raise InputError(f"patch_width is {patch_width}; it must be odd")
    if scale < 1 or style.shape[0] % scale or style.shape[1] % scale:
        raise InputError(
            f"the style is {style.shape[1]}x{style.shape[0]}; "
            f"its sides must be multiples of the scale {scale}"
        )
    radius = patch_width // 2
    assigned = nnf[nnf[:, :, 0] >= 0]
    limit = np.array(style.shape[:2]) // scale - 1 - radius
    if assigned.size and ((assigned < radius).any() or (assigned > limit).any()):
        raise InputError(
            f"the NNF points to source pixels up to (y, x) = {tuple(assigned.max(axis=0))}, "
            f"but a style of {style.shape[1]}x{style.shape[0]} at scale {scale} has patches of "
            f"width {patch_width} only up to {tuple(limit)}"
        )
    image = style if style.ndim == 3 else style[:, :, None]
    means = np.zeros((nnf.shape[0] * scale, nnf.shape[1] * scale, image.shape[2]))
    _vote_scaled(image, means, nnf, radius, scale)
    if style.dtype != np.float32:
        means = np.floor(means + 0.5)
    return means.astype(style.dtype).reshape(*means.shape[:2], *style.shape[2:])
