"""Whether a caller's buffers are what a packing reads."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError, shown


def check_buffers(
    buffers: Mapping[str, NDArray[np.uint8]], names: Sequence[str], coloured: Sequence[str] = ()
) -> list[NDArray[np.uint8]]:
    """The buffers in the order of their names.

    Parameters
    ----------
    buffers : mapping of str to (H, W) or (H, W, 3) uint8
    names : sequence of str
        The buffers that are read.
    coloured : sequence of str
        Those whose colours have a meaning, so that they must have three channels.

    Returns
    -------
    list of (H, W, n) uint8
        C-contiguous; views where the caller's arrays are.

    Raises
    ------
    InputError
        If one is missing, one is not read, or they do not fit.
    """
    if not isinstance(buffers, Mapping):
        raise InputError("must map the names of buffers to arrays", parameter="buffers")
    missing = [name for name in names if name not in buffers]
    if missing:
        raise InputError(f"lack {', '.join(missing)}; give {', '.join(names)}", parameter="buffers")
    extra = [shown(name) for name in buffers if name not in names]
    if extra:
        raise InputError(
            f"have {', '.join(extra)}, which this packing does not read; give "
            f"{', '.join(names)} alone",
            parameter="buffers",
        )
    checked = {}
    for name in names:
        array = as_array(buffers[name], name)
        if array.dtype != np.uint8 or array.ndim not in (2, 3) or array.shape[2:] not in (
            (), (1,), (3,),
        ):  # fmt: skip
            raise InputError(
                f"have {array.dtype} of the shape {array.shape} as {name}; it must be uint8 of the "
                "shape (height, width) or (height, width, 3)",
                parameter="buffers",
            )
        if 0 in array.shape:
            raise InputError(f"have no pixel in {name}", parameter="buffers")
        if name in coloured and array.shape[2:] != (3,):
            raise InputError(
                f"have {name} without colours; it must be (height, width, 3), since its colours "
                "tell things apart",
                parameter="buffers",
            )
        checked[name] = array
    first = checked[names[0]]
    for name, array in checked.items():
        if array.shape[:2] != first.shape[:2]:
            raise InputError(
                f"differ in size: {names[0]} is {_size(first)} and {name} is {_size(array)} pixels",
                parameter="buffers",
            )
    return [np.ascontiguousarray(array).reshape(*array.shape[:2], -1) for array in checked.values()]


def check_out(
    out: NDArray[np.uint8], labels: NDArray[np.uint8] | None, size: tuple[int, int], channels: int
) -> NDArray[np.uint8]:
    """The array of labels to write, empty if none is asked for; InputError if one does not fit."""
    if out.dtype != np.uint8 or out.shape != (*size, channels) or out.strides[2] != 1:
        raise InputError(
            f"is {out.dtype} of the shape {out.shape}; it must be uint8 of the shape "
            f"{(*size, channels)}, with the bytes of a pixel side by side",
            parameter="out",
        )
    if labels is None:
        return np.empty((0, 0), np.uint8)
    if labels.dtype != np.uint8 or labels.shape != size or not labels.flags.c_contiguous:
        raise InputError(
            f"are {labels.dtype} of the shape {labels.shape}; they must be contiguous uint8 of the "
            f"shape {size}",
            parameter="labels",
        )
    return labels


def _size(array: NDArray[np.uint8]) -> str:
    return f"{array.shape[1]}x{array.shape[0]}"
