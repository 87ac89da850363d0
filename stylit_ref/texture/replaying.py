"""``replay_texture``: other maps of the exemplars through the coordinates of a texture."""

from collections.abc import Sequence
from typing import Literal, TypeVar

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.files.texture_field import TextureField

Value = TypeVar("Value", bound=np.uint8 | np.uint16 | np.float32)
Kind = Literal["colours", "labels", "normals"]
KINDS: tuple[Kind, ...] = "colours", "labels", "normals"

_ROWS = 64
"""Rows of the picture that are made at a time."""


def replay_texture(
    field: TextureField, maps: Sequence[NDArray[Value]], *, kind: Kind = "colours"
) -> NDArray[Value]:
    """Make the texture anew of other maps of its exemplars, at their own bit depth.

    With the exemplars themselves the result is the texture's image. The maps may also be an
    enlargement of the exemplars, a whole number of times as large; so is the result then.

    Parameters
    ----------
    field : TextureField
        From :class:`stylit_ref.TextureResult` or :func:`stylit_ref.read_texture_field`.
    maps : sequence of (H, W) or (H, W, c) uint8, uint16 or float32
        One for each exemplar, of the same dtype and channels.
    kind : {"colours", "labels", "normals"}
        What lies between two pixels, where a patch was deformed: the mean of both; or the nearest
        of them; or their mean, made as long again as a normal is. Normals have 3 channels, from -1
        to 1 in floating point, and from 0 to the largest integer otherwise.

    Returns
    -------
    (scale * H, scale * W) or (scale * H, scale * W, c) of the maps' dtype
        Means of integers are rounded half up.

    Raises
    ------
    InputError
        If maps do not fit the exemplars or each other.
    """
    if kind not in KINDS:
        raise InputError(f"is {kind!r}; it must be {_one_of(KINDS)}", parameter="kind")
    pictures = [_checked(given, k) for k, given in enumerate(maps, 1)]
    scale = _scale(field, pictures)
    first = pictures[0]
    for k, picture in enumerate(pictures[1:], 2):
        if picture.dtype != first.dtype or picture.shape[2] != first.shape[2]:
            raise InputError(
                f"map {k} is {picture.dtype} with {picture.shape[2]} channels, map 1 "
                f"{first.dtype} with {first.shape[2]}; give maps that are alike"
            )
    if kind == "normals" and first.shape[2] != 3:
        raise InputError(f"a map of normals has 3 channels; this one has {first.shape[2]}")
    height, width = field.coordinates.shape[:2]
    result = np.empty((height * scale, width * scale, first.shape[2]), first.dtype)
    for row in range(0, height, _ROWS):
        part = field.coordinates[row : row + _ROWS]
        result[row * scale : (row + len(part)) * scale] = _replayed(part, pictures, scale, kind)
    return result[:, :, 0] if np.ndim(maps[0]) == 2 else result


def _checked(given, number):
    picture = as_array(given, f"map {number}")
    if picture.dtype not in (np.uint8, np.uint16, np.float32) or picture.ndim not in (2, 3):
        raise InputError(
            f"map {number} is {picture.dtype} of the shape {picture.shape}; it must be uint8, "
            "uint16 or float32 of the shape (H, W) or (H, W, channels)"
        )
    return picture if picture.ndim == 3 else picture[:, :, None]


def _scale(field, pictures):
    sizes = field.exemplar_sizes
    if len(pictures) != len(sizes):
        raise InputError(
            f"exemplars of the texture: {len(sizes)}, maps that were given: {len(pictures)}; give "
            "a list with a map of each exemplar, in the same order"
        )
    scale = max(pictures[0].shape[0] // sizes[0][0], 1)
    for k, (picture, (height, width)) in enumerate(zip(pictures, sizes, strict=True), 1):
        if picture.shape[:2] != (height * scale, width * scale):
            others = "" if len(sizes) == 1 else ", all maps as many times"
            raise InputError(
                f"map {k} has {picture.shape[1]} x {picture.shape[0]} pixels, exemplar {k} had "
                f"{width} x {height}; it must be that size or a whole number of times as large"
                f"{others}"
            )
    return scale


def _replayed(coordinates, pictures, scale, kind):
    """Some rows of the picture. Positions are in quarters of a pixel of the maps."""
    coordinates = coordinates.repeat(scale, axis=0).repeat(scale, axis=1).astype(np.int64)
    rows, columns = coordinates.shape[:2]
    index = coordinates[..., 0]
    y = coordinates[..., 1] * scale + (np.arange(rows) % scale * 4)[:, None]
    x = coordinates[..., 2] * scale + (np.arange(columns) % scale * 4)[None, :]
    made = np.empty((rows, columns, pictures[0].shape[2]), pictures[0].dtype)
    for number, picture in enumerate(pictures):
        own = index == number
        if own.any():
            made[own] = _sampled(picture, y[own], x[own], kind)
    return made


def _sampled(picture, y, x, kind):
    height, width = picture.shape[:2]
    if kind == "labels":
        return picture[np.minimum((y + 2) >> 2, height - 1), np.minimum((x + 2) >> 2, width - 1)]
    top, left = y >> 2, x >> 2
    values = picture[top, left]
    between = (y & 3 != 0) | (x & 3 != 0)
    if between.any():
        top, left = top[between], left[between]
        share_y, share_x = (y[between] & 3)[:, None], (x[between] & 3)[:, None]
        below, right = np.minimum(top + 1, height - 1), np.minimum(left + 1, width - 1)
        wide = np.float64 if picture.dtype == np.float32 else np.int64
        means = (
            picture[top, left].astype(wide) * ((4 - share_y) * (4 - share_x))
            + picture[top, right].astype(wide) * ((4 - share_y) * share_x)
            + picture[below, left].astype(wide) * (share_y * (4 - share_x))
            + picture[below, right].astype(wide) * (share_y * share_x)
        )
        if kind == "normals":
            values[between] = _normalized(means / 16, picture.dtype)
        else:
            values[between] = means / 16 if wide is np.float64 else (means + 8) >> 4
    return values


def _normalized(normals, dtype):
    largest = 1.0 if dtype == np.float32 else np.iinfo(dtype).max
    signed = normals if dtype == np.float32 else normals * 2 / largest - 1
    length = np.linalg.norm(signed, axis=-1, keepdims=True)
    unit = signed / np.where(length > 0, length, 1)
    return unit if dtype == np.float32 else np.floor((unit + 1) / 2 * largest + 0.5)


def _one_of(names):
    *others, last = map(repr, names)
    return f"{', '.join(others)} or {last}"
