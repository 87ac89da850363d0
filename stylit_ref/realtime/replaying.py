"""Another style image through a saved sparse NNF."""

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.files.realtime_field import RealtimeField
from stylit_ref.realtime.formulae.grid import covered_from_left, covered_from_right

Value = TypeVar("Value", bound=np.uint8 | np.uint16 | np.float32)


def replay_realtime(field: RealtimeField, style: NDArray[Value]) -> NDArray[Value]:
    """Blend a style image through a saved field, at its own bit depth.

    With the style of the frame the result is that frame.

    Parameters
    ----------
    field : RealtimeField
    style : (H, W, n) uint8, uint16 or float32
        A whole number of times as large as the style of the frame; so is the result, then.

    Returns
    -------
    (H_B, W_B, n) of the style's dtype
        Means of integers are rounded half up.

    Raises
    ------
    InputError
        If the style has another size, type or shape.
    """
    style = _checked(style)
    scale = max(style.shape[0] // field.style_size[0], 1)
    if style.shape[:2] != tuple(scale * side for side in field.style_size):
        raise InputError(
            f"is {style.shape[1]}x{style.shape[0]}, but the style of the run was "
            f"{field.style_size[1]}x{field.style_size[0]}; it must be that size or a whole number "
            "of times as large",
            parameter="style",
        )
    (rows, row_steps), (columns, column_steps) = (
        _entries(side, field.spacing, field.patch_width // 2, entries, scale)
        for side, entries in zip(field.target_size, field.nnf.shape, strict=False)
    )
    total = np.zeros((len(rows[0]), len(columns[0]), style.shape[2]))
    for row, row_step in zip(rows, row_steps, strict=True):
        for column, column_step in zip(columns, column_steps, strict=True):
            centre = field.nnf[np.ix_(row, column)]
            y = scale * centre[..., 0] + row_step[:, None]
            x = scale * centre[..., 1] + column_step
            total += style[y.clip(0, style.shape[0] - 1), x.clip(0, style.shape[1] - 1)]
    return _as_colours(total / 4, style.dtype)


def replay_dense(nnf: NDArray[np.int32], style: NDArray[Value], patch_width: int) -> NDArray[Value]:
    """Average a style image through a dense NNF, as ``dense_finish`` does, at its own bit depth.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32
        From :meth:`stylit_ref.realtime.session.Session.dense_nnf`.
    style : (H_A, W_A, n) uint8, uint16 or float32
    patch_width : int

    Returns
    -------
    (H_B, W_B, n) of the style's dtype
        Means of integers are rounded half up.

    Raises
    ------
    InputError
        If the style has another type or shape.
    """
    style = _checked(style)
    height, width = nnf.shape[:2]
    total, patches = np.zeros((height, width, style.shape[2])), np.zeros((height, width, 1))
    steps = range(-(patch_width // 2), patch_width // 2 + 1)
    for step_y in steps:
        for step_x in steps:
            shown = _overlap(height, step_y), _overlap(width, step_x)
            centre = nnf[_overlap(height, -step_y), _overlap(width, -step_x)]
            y = (centre[..., 0] + step_y).clip(0, style.shape[0] - 1)
            x = (centre[..., 1] + step_x).clip(0, style.shape[1] - 1)
            total[shown] += style[y, x]
            patches[shown] += 1
    return _as_colours(total / patches, style.dtype)


def _overlap(side: int, step: int) -> slice:
    """Along a side, the pixels that are ``step`` behind another one."""
    return slice(max(step, 0), max(side + min(step, 0), 0))


def _checked(style: NDArray[Value]) -> NDArray[Value]:
    style = as_array(style, "style")
    if style.dtype not in (np.uint8, np.uint16, np.float32) or style.ndim != 3 or not style.size:
        raise InputError(
            f"is {style.dtype} of shape {style.shape}; it must be uint8, uint16 or float32 of "
            "shape (H, W, channels)",
            parameter="style",
        )
    return style


def _as_colours(mean: NDArray[np.float64], dtype: "np.dtype[Value]") -> NDArray[Value]:
    return (mean if dtype == np.float32 else np.floor(mean + 0.5)).astype(dtype)


def _entries(
    side: int, step: int, radius: int, entries: int, scale: int
) -> tuple[list[NDArray[np.int64]], list[NDArray[np.int64]]]:
    """Along a side: the two entries whose patches cover a pixel, and how far it is from each.

    A pixel that one patch covers has it twice.
    """
    fine = np.arange(side * scale)
    pixels = fine // scale
    left = pixels // step
    right = np.minimum(left + 1, entries - 1)
    offset = pixels % step
    by_left = np.array(covered_from_left(step, radius))[offset]
    by_right = np.array(covered_from_right(step, radius))[offset] & (left + 1 < entries)
    one = np.where(by_left | ~by_right, left, right)
    other = np.where(by_right, right, left)
    return [one, other], [fine - scale * step * one, fine - scale * step * other]
