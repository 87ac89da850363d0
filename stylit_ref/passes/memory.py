"""Memory of the arrays of a run; on the CPU nothing needs to be copied."""

import numpy as np
from numpy.typing import DTypeLike, NDArray


def upload(array: np.ndarray) -> np.ndarray:
    """The array, in the memory that the passes work on.

    Parameters
    ----------
    array : array
    """
    return np.ascontiguousarray(array)


def download(array: np.ndarray) -> np.ndarray:
    """An array of the passes as a NumPy array.

    Parameters
    ----------
    array : array
        Made by a pass or by :func:`upload`.
    """
    return array


def wait() -> None:
    """Return when all passes that were called have finished: on the CPU at once."""


def zeros(shape: int | tuple[int, ...], dtype: DTypeLike) -> np.ndarray:
    """An array of zeros for the passes.

    Parameters
    ----------
    shape : tuple of int
    dtype : dtype
    """
    return np.zeros(shape, dtype)


def repeat_edge(image: NDArray[np.uint8], radius: int) -> NDArray[np.uint8]:
    """An image with its edge pixels repeated ``radius`` times on every side.

    Parameters
    ----------
    image : (H, W, C) uint8
    radius : int

    Returns
    -------
    (H + 2 radius, W + 2 radius, C) uint8
    """
    return np.pad(image, ((radius, radius), (radius, radius), (0, 0)), mode="edge")
