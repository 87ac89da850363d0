"""Write pictures as one moving picture: animated WebP, without loss."""

from collections.abc import Iterable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import check_writable
from stylit_ref.files.disk.whole_file import whole_file

SUFFIX = ".webp"


def check_animation_writable(path: str | Path, channels: int) -> None:
    """Refuse a path that :func:`write_animation` could not write, before the work begins.

    Raises
    ------
    InputError
    """
    if Path(path).suffix.lower() != SUFFIX:
        raise InputError(f"{path}: the file name of an animation must end in {SUFFIX}")
    if channels not in (1, 3):
        raise InputError(
            f"{path}: an animation holds grey or three colours, and the style has {channels} "
            "channels; write numbered frames"
        )
    check_writable(path)


def write_animation(
    path: str | Path, pictures: Iterable[NDArray[np.uint8]], milliseconds: int
) -> None:
    """Write pictures of one size, one after the other, which start again at the end.

    Parameters
    ----------
    path : str or Path
        It ends in ``.webp``.
    pictures : iterable of (H, W, n) uint8
        At least one; with 1 or 3 channels.
    milliseconds : int
        How long each is shown.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    frames = [Image.fromarray(picture.squeeze()).convert("RGB") for picture in pictures]
    size = sum(frame.width * frame.height * 3 for frame in frames) + 2**16
    try:
        with whole_file(path, size) as partial:
            frames[0].save(
                partial, "WEBP", save_all=True, append_images=frames[1:],
                duration=milliseconds, loop=0, lossless=True,
            )  # fmt: skip
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror or error}") from None
