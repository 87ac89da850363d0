"""Motion as an EXR of this project: layers ``MOTION`` and ``VISIBLE``, compressed without loss."""

from pathlib import Path

import numpy as np
import OpenImageIO as oiio
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.disk.image_file import check_size, open_image, read_pixels, reason_of
from stylit_ref.files.disk.whole_file import whole_file

_CHANNELS = "MOTION.X", "MOTION.Y", "VISIBLE.Y"


def write_motion(path: str | Path, field: NDArray[np.float32], visible: NDArray[np.bool_]) -> None:
    """Write motion; a failure leaves no partial file, and the same motion gives the same bytes.

    Parameters
    ----------
    path : str or Path
        Ends in ``.exr``.
    field : (H, W, 2) float32
        (x, y) in pixels. Every value comes back as it is.
    visible : (H, W) bool

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    pixels = np.dstack([field, visible]).astype(np.float32, copy=False)
    spec = oiio.ImageSpec(*visible.shape[::-1], len(_CHANNELS), "float")
    spec.channelnames = _CHANNELS
    spec.attribute("compression", "zip")
    spec.attribute("DateTime", "")  # or it would be the time of writing
    with whole_file(path, pixels.nbytes * 9 // 8 + 2**16) as partial:
        output = oiio.ImageOutput.create(str(partial))
        written = output.open(str(partial), spec) and output.write_image(pixels)
        if not (output.close() and written):
            reason = reason_of(output.geterror, oiio.geterror)
            raise InputError(f"{path}: cannot be written: {reason}")


def read_written_motion(
    path: str | Path,
) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
    """Read what :func:`write_motion` wrote.

    :func:`stylit_ref.files.motion_file.read_vectors` reads the same file as one of many dialects,
    and sets to 0 what is no vector.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    field : (H, W, 2) float32
    visible : (H, W) bool

    Raises
    ------
    InputError
        If it cannot be read.
    """
    image = open_image(path)
    names = image.spec().channelnames
    if sorted(names) != sorted(_CHANNELS):
        raise InputError(f"{path}: has the channels {', '.join(names)}, which are not of a motion")
    check_size(path, image.spec(), len(_CHANNELS))
    pixels = read_pixels(image, 0, [names.index(name) for name in _CHANNELS], "float")
    if pixels is None:
        raise InputError(f"{path}: cannot be read: {reason_of(image.geterror)}")
    image.close()
    return np.ascontiguousarray(pixels[:, :, :2]), pixels[:, :, 2] > 0
