"""Whether a painting, or a rectangle of it, can be taken."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.studio.engine.scene import Scene


def check_painting(painting: NDArray[np.uint8], scene: Scene) -> NDArray[np.uint8]:
    """Refuse what is no painting for a scene.

    Parameters
    ----------
    painting : (H_A, W_A, 3) uint8
    scene : Scene

    Raises
    ------
    InputError
    """
    painting = _checked(painting, "painting")
    if painting.shape[:2] != scene.size:
        raise InputError(
            f"is {painting.shape[1]}x{painting.shape[0]}, but {scene.title} is painted at "
            f"{scene.size[1]}x{scene.size[0]}; they must be as large as each other",
            parameter="painting",
        )
    return painting


def check_rectangle(
    x: int, y: int, pixels: NDArray[np.uint8], size: tuple[int, int]
) -> NDArray[np.uint8]:
    """Refuse a rectangle that does not lie in a painting; a copy of its pixels.

    Parameters
    ----------
    x, y : int
        Its left upper pixel.
    pixels : (h, w, 3) uint8
    size : tuple of int
        Height and width of the painting.

    Raises
    ------
    InputError
    """
    pixels = _checked(pixels, "pixels")
    height, width = pixels.shape[:2]
    if not (0 <= x <= size[1] - width and 0 <= y <= size[0] - height):
        raise InputError(
            f"are {width}x{height} at x {x}, y {y}, and the painting is {size[1]}x{size[0]}; they "
            "must lie in it",
            parameter="pixels",
        )
    return pixels.copy()


def _checked(image, name):
    image = as_array(image, name)
    if image.dtype != np.uint8 or image.ndim != 3 or image.shape[2] != 3 or not image.size:
        raise InputError(
            f"has the shape {image.shape} and the type {image.dtype}; it must be height, width and "
            "3 colours of uint8",
            parameter=name,
        )
    return image
