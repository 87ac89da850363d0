"""What there is to look at: buffers, where each pixel came from, and what is used how often."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.field import Field
from stylit_ref.files.realtime_field import RealtimeField


def as_colours(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A buffer of any channels as a picture.

    Parameters
    ----------
    image : (H, W, n) uint8
        Grey, or colours; with alpha or without.

    Returns
    -------
    (H, W, 3) uint8
        Without alpha.
    """
    colours = image[:, :, :1] if image.shape[2] < 3 else image[:, :, :3]
    return np.ascontiguousarray(np.broadcast_to(colours, (*image.shape[:2], 3)))


def places_of(field: Field | RealtimeField) -> NDArray[np.int64]:
    """Where each pixel of the target came from; between entries of a grid, by the nearest.

    Returns
    -------
    (H_B, W_B, 2) int64
        y and x of the source.
    """
    if isinstance(field, Field):
        return field.nnf.astype(np.int64)
    spacing = field.spacing
    y, x = (np.arange(side) for side in field.target_size)
    rows, columns = field.nnf.shape[:2]
    a = np.minimum((y + spacing // 2) // spacing, rows - 1)
    b = np.minimum((x + spacing // 2) // spacing, columns - 1)
    moved = np.stack(
        np.broadcast_arrays((y - a * spacing)[:, None], (x - b * spacing)[None]), axis=-1
    )
    last = np.array(field.style_size) - 1
    return (field.nnf[a[:, None], b[None]] + moved).clip(0, last)


def nnf_picture(field: Field | RealtimeField, style_size: tuple[int, int]) -> NDArray[np.uint8]:
    """The NNF in colours: the hue is the direction from the middle of the source.

    Its middle is white, and colours are the stronger the farther from it.

    Returns
    -------
    (H_B, W_B, 3) uint8
    """
    places = places_of(field)
    return hue_circle(style_size)[places[..., 0], places[..., 1]]


def hue_circle(size: tuple[int, int]) -> NDArray[np.uint8]:
    """The colour of every place of a source, (height, width, 3)."""
    y, x = np.mgrid[: size[0], : size[1]]
    down, right = (2 * y + 1) / size[0] - 1, (2 * x + 1) / size[1] - 1
    hue = 6 * (np.arctan2(-down, right) / (2 * np.pi) % 1)[..., None]
    strength = np.minimum(np.hypot(down, right), 1)[..., None]
    pure = (np.abs((hue + np.array([0, 4, 2])) % 6 - 3) - 1).clip(0, 1)
    return (255 * (1 - strength + strength * pure) + 0.5).astype(np.uint8)


def usage_counts(field: Field | RealtimeField, style_size: tuple[int, int]) -> NDArray[np.int64]:
    """How many patches cover each pixel of the source, one for each pixel of the target: Ω.

    Entries of a grid stand for the pixels around them, so that the grid is not seen.

    Returns
    -------
    (H_A, W_A) int64
    """
    width = field.patch_width or 1
    radius = width // 2
    height, columns = style_size
    centres = np.zeros((height + width, columns + width), np.int64)
    y, x = places_of(field).reshape(-1, 2).T
    np.add.at(centres, (y + radius + 1, x + radius + 1), 1)
    sums = centres.cumsum(axis=0).cumsum(axis=1)
    sums = sums[width:] - sums[:-width]
    return sums[:, width:] - sums[:, :-width]


def usage_picture(field: Field | RealtimeField, style_size: tuple[int, int]) -> NDArray[np.uint8]:
    """How often the source is used, as heat: black is never, then red, yellow, white.

    The scale is logarithmic, since a few places are used far more than others.

    Returns
    -------
    (H_A, W_A, 3) uint8
    """
    heat = np.log1p(usage_counts(field, style_size))
    heat /= max(heat.max(), 1e-9)
    return (255 * (3 * heat[..., None] - [0, 1, 2]).clip(0, 1) + 0.5).astype(np.uint8)
