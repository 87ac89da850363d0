"""``replay``: another style image through a saved nearest-neighbour field."""

import logging
from numbers import Integral
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.files.field import Field
from stylit_ref.notes import note
from stylit_ref.passes import replay_vote
from stylit_ref.stylization.checks import check_fill, size_text
from stylit_ref.stylization.mask import fill_masked, wholly_assigned
from stylit_ref.stylization.params import Params

Value = TypeVar("Value", bound=np.uint8 | np.uint16 | np.float32)


def replay(
    nnf: NDArray[np.int32] | Field,
    style: NDArray[Value],
    *,
    patch_width: int | None = None,
    scale: int | None = None,
    mask: NDArray[np.bool_] | None = None,
    fill: NDArray[Value] | None = None,
) -> NDArray[Value]:
    """Vote a style image through a nearest-neighbour field, at its own bit depth.

    With the style of a run, its fill and its :class:`stylit_ref.Field` the result is that run's
    image. The style may also be another rendition of the same size (16 bit, float, other
    colours), or an enlargement.

    Parameters
    ----------
    nnf : Field or (H_B, W_B, 2) int32
        From :func:`stylit_ref.read_nnf`, or the array of :class:`stylit_ref.Result`, which is
        negative where nothing is assigned.
    style : (H, W) or (H, W, n) uint8, uint16 or float32
        ``scale`` times the size of the style the NNF was made with.
    patch_width : int, optional
        The patch width of the run. A field may know it; if it does not, the default is that of
        :class:`stylit_ref.Params`.
    scale : int, optional
        How many times larger the style is. By default what the sizes say, if the field knows the
        size of the run's style; else 1.
    mask : (H_B, W_B) bool, optional
        True where the target is left alone; at ``scale`` times that size too. By default the mask
        of the field; if it knows none, the pixels that not all of their patches are assigned to.
    fill : (H_B, W_B) or (H_B, W_B, m) of the style's dtype, optional
        What masked pixels show, as for :func:`stylit_ref.stylize`; at ``scale`` times that size
        too. Without it they are transparent, and the image has an alpha channel.

    Returns
    -------
    (scale * H_B, scale * W_B) or (scale * H_B, scale * W_B, n) of the style's dtype
        Means of integers are rounded half up. Where pixels are masked, with the channels that
        the fill adds.

    Raises
    ------
    InputError
        If the array cannot be an NNF, or points outside the style; if an argument contradicts
        what the field knows; if the mask shows pixels that the run left alone.
    """
    field = nnf if isinstance(nnf, Field) else Field(as_array(nnf, "nnf"))
    style = as_array(style, "style")
    _check_arrays(field.nnf, style)
    is_guess = patch_width is None and field.patch_width is None
    patch_width = _known_width(field, patch_width)
    scale = _known_scale(field, style, scale)
    _check_reach(field, style, patch_width, scale)
    if is_guess:
        _doubt_width(field.nnf, style, patch_width, scale)
    masked = _masked(field, mask, patch_width, scale)

    image = style if style.ndim == 3 else style[:, :, None]
    means = np.zeros((field.nnf.shape[0] * scale, field.nnf.shape[1] * scale, image.shape[2]))
    replay_vote(
        np.ascontiguousarray(image), means, np.ascontiguousarray(field.nnf), patch_width, scale,
        field.vote_outliers,
    )  # fmt: skip
    if style.dtype != np.float32:
        means = np.floor(means + 0.5)
    replayed = means.astype(style.dtype)
    if masked is not None:
        replayed = fill_masked(replayed, masked, _fill(field, style, fill, scale))
    elif fill is not None:
        raise InputError(
            "needs a mask that says which pixels to fill, and the run had none", parameter="fill"
        )
    return replayed[:, :, 0] if style.ndim == 2 and replayed.shape[2] == 1 else replayed


def _check_arrays(nnf, style):
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


def _known_width(field, patch_width):
    """The patch width that is given or known, or the default."""
    if patch_width is None:
        patch_width = Params().patch_width if field.patch_width is None else field.patch_width
    if not isinstance(patch_width, Integral) or patch_width % 2 == 0 or not 1 <= patch_width <= 63:
        raise InputError(
            f"is {patch_width}; it must be an odd integer from 1 to 63", parameter="patch_width"
        )
    if field.patch_width not in (None, patch_width):
        raise InputError(
            f"is {patch_width}, but the field is of a run with patches of width "
            f"{field.patch_width}; leave it out",
            parameter="patch_width",
        )
    return patch_width


def _known_scale(field, style, scale):
    """The scale that is given, or that the sizes say."""
    size = style.shape[:2]
    if scale is not None and (not isinstance(scale, Integral) or scale < 1):
        raise InputError(f"is {scale}; it must be a positive integer", parameter="scale")
    if field.style_size is None:
        scale = 1 if scale is None else scale
        if size[0] % scale or size[1] % scale:
            raise InputError(
                f"is {size_text(size)}; its sides must be multiples of the scale {scale}",
                parameter="style",
            )
        return scale
    known = scale or max(size[0] // field.style_size[0], 1)
    if size != (known * field.style_size[0], known * field.style_size[1]):
        larger = f"{scale} times" if scale else "that size or a whole number of times"
        raise InputError(
            f"is {size_text(size)}, but the style of the run was {size_text(field.style_size)}; "
            f"it must be {larger} as large",
            parameter="style",
        )
    return known


def _check_reach(field, style, patch_width, scale):
    """The NNF stays inside the style; a note if it stays so far inside that something is amiss."""
    radius = patch_width // 2
    assigned = field.nnf[field.nnf[:, :, 0] >= 0]
    if not assigned.size:
        raise InputError("assigns nothing, so there is nothing to show", parameter="nnf")
    low, high = assigned.min(axis=0), assigned.max(axis=0)
    limit = np.array(style.shape[:2]) // scale - 1 - radius
    if (low < radius).any() or (high > limit).any():
        raise InputError(
            f"points to source pixels (y, x) from {low.tolist()} to {high.tolist()}, but a style "
            f"of {size_text(style.shape)} at scale {scale} has patches of width "
            f"{patch_width} only from {[radius, radius]} to {limit.tolist()}",
            parameter="nnf",
        )
    if field.style_size is None and (high * 2 < limit).all():
        note(
            f"is {scale}, but the NNF uses less than half of the style's "
            f"{size_text(style.shape)}; if the style is an enlargement, give a larger scale",
            parameter="scale",
            level=logging.WARNING,
        )


def _doubt_width(nnf, style, patch_width, scale):
    """A note if wider patches would explain how far the NNF stays from the style's edges."""
    assigned = nnf[nnf[:, :, 0] >= 0]
    last = np.array(style.shape[:2]) // scale - 1
    nearest = int(min(assigned.min(), (last - assigned).min()))
    if nearest > patch_width // 2:
        note(
            f"is {patch_width} by default, but the NNF stays {nearest} pixels away from the edges "
            f"of the style, as patches of width {2 * nearest + 1} do; give the patch width of the "
            "run",
            parameter="patch_width",
            level=logging.WARNING,
        )


def _masked(field, mask, patch_width, scale):
    """The pixels of the replayed image that are left alone, or None if there is no mask."""
    assigned = field.nnf[:, :, 0] >= 0
    shown = wholly_assigned(assigned, patch_width)
    if not shown.any():
        raise InputError("assigns too little to show a single pixel", parameter="nnf")
    shown = _enlarged(shown, shown.shape, scale)
    mask = field.mask if mask is None else as_array(mask, "mask")
    if mask is None:
        return None if shown.all() else ~shown
    if mask.dtype != bool or mask.ndim != 2:
        raise InputError(
            f"is {mask.dtype} of shape {mask.shape}; it must be bool of shape (H, W)",
            parameter="mask",
        )
    masked = _enlarged(mask, assigned.shape, scale)
    if masked.shape != shown.shape:
        raise InputError(
            f"is {size_text(mask.shape)} but the target is {size_text(assigned.shape)}; they must "
            "have the same size",
            parameter="mask",
        )
    left_alone = np.count_nonzero(~(masked | shown))
    if left_alone:
        raise InputError(
            f"shows {left_alone} pixels that the run left alone; it must cover the mask of the run",
            parameter="mask",
        )
    if masked.all():
        raise InputError("covers the whole target, so nothing is left to show", parameter="mask")
    return masked


def _fill(field, style, fill, scale):
    """The fill at the size of the replayed image, or None."""
    if fill is None:
        return None
    fill = as_array(fill, "fill")
    if fill.dtype != style.dtype:
        raise InputError(
            f"has dtype {fill.dtype}; it must be that of the style, {style.dtype}", parameter="fill"
        )
    height, width = field.nnf.shape[:2]
    fill = _enlarged(fill, (height, width), scale)
    check_fill(fill, (height * scale, width * scale))
    return fill


def _enlarged(image, size, scale):
    """The image with every pixel repeated, if it has the target's ``size``."""
    return image.repeat(scale, 0).repeat(scale, 1) if image.shape[:2] == size else image
