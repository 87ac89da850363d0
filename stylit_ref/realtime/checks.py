"""Whether what a session is given fits together."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.realtime.formulae.packed_nnf import LARGEST_SIDE

MOST_CHANNELS = 28


def check_guides(guides: ArrayLike, name: str) -> NDArray[np.uint8]:
    """(height, width, channels) uint8, or InputError."""
    guides = as_array(guides, name)
    if guides.dtype != np.uint8 or guides.ndim != 3 or not guides.size:
        raise InputError(
            f"has the shape {guides.shape} and the type {guides.dtype}; it must be an array of "
            f"height, width and channels, of the type uint8",
            parameter=name,
        )
    if guides.shape[2] > MOST_CHANNELS:
        raise InputError(
            f"has {guides.shape[2]} channels; it must have at most {MOST_CHANNELS}; pack them",
            parameter=name,
        )
    check_sides(guides.shape[:2], name)
    return guides


def check_sides(size: tuple[int, ...], name: str) -> None:
    """Refuse sides that an entry of the NNF cannot hold."""
    if max(size) > LARGEST_SIDE:
        raise InputError(
            f"is {size[1]} x {size[0]} pixels; each side must be at most {LARGEST_SIDE}; make it "
            f"smaller",
            parameter=name,
        )


def check_style(style: ArrayLike, size: tuple[int, int]) -> NDArray[np.uint8]:
    """(height, width, 3) uint8 of the source's size, or InputError."""
    style = as_array(style, "style")
    if style.dtype != np.uint8 or style.ndim != 3 or style.shape[2] != 3:
        raise InputError(
            f"has the shape {style.shape} and the type {style.dtype}; it must be an array of "
            f"height, width and 3 colours, of the type uint8",
            parameter="style",
        )
    if style.shape[:2] != size:
        raise InputError(
            f"is {style.shape[1]} x {style.shape[0]} pixels, but the source guides are {size[1]} x "
            f"{size[0]}; they must be as large as each other",
            parameter="style",
        )
    return style


def check_labels(
    labels: ArrayLike | None, size: tuple[int, int], name: str
) -> NDArray[np.uint8] | None:
    """A copy, (height, width) uint8 of a size; None; or InputError."""
    if labels is None:
        return None
    labels = as_array(labels, name)
    if labels.dtype != np.uint8 or labels.shape != size:
        raise InputError(
            f"has the shape {labels.shape} and the type {labels.dtype}; it must have a uint8 for "
            f"each of {size[1]} x {size[0]} pixels",
            parameter=name,
        )
    return labels.copy()


def check_weights(weights: ArrayLike | None, channels: int) -> tuple[int, ...]:
    """An integer from 0 for each channel, 1 by default; or InputError."""
    if weights is None:
        return (1,) * channels
    weights = as_array(weights, "weights")
    if weights.dtype.kind not in "iu" or weights.shape != (channels,) or (weights < 0).any():
        raise InputError(
            f"must be {channels} integers from 0, one for each channel of the guides",
            parameter="weights",
        )
    return tuple(int(weight) for weight in weights)


def check_nnf(
    nnf: ArrayLike, grid: tuple[int, int], first: tuple[int, int], last: tuple[int, int]
) -> NDArray[np.int32]:
    """(rows, columns, 2) int32 whose patches lie in the source, or InputError."""
    nnf = as_array(nnf, "nnf")
    if nnf.dtype.kind not in "iu" or nnf.shape != (*grid, 2):
        raise InputError(
            f"has the shape {nnf.shape}; it must have y and x for each of {grid[0]} x {grid[1]} "
            f"entries",
            parameter="nnf",
        )
    if (nnf < first).any() or (nnf > last).any():
        raise InputError(
            f"has a patch outside the source; y must be from {first[0]} to {last[0]}, x from "
            f"{first[1]} to {last[1]}",
            parameter="nnf",
        )
    return nnf.astype(np.int32)
