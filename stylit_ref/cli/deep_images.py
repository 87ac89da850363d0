"""Style and fill with more than 8 bits, for a picture that has as many."""

import argparse
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.colour.bit_depth import to_depth
from stylit_ref.files.read_image import read_image
from stylit_ref.files.write_image import FLOAT_FORMATS, check_image_writable
from stylit_ref.notes import note


class DeepImages(NamedTuple):
    """A style and a fill at the style's own depth.

    Attributes
    ----------
    style : (H_A, W_A, n) uint16 or float32
    fill : (H_B, W_B, m) of the same dtype, or None
    """

    style: NDArray[np.uint16 | np.float32]
    fill: NDArray[np.uint16 | np.float32] | None


def read_deep_images(
    options: argparse.Namespace, style: NDArray[np.uint16 | np.float32] | None, channels: int
) -> DeepImages | None:
    """Read the fill at the style's own depth, if the output can hold it.

    It is read before the run, so that nobody can change or remove it meanwhile.

    Parameters
    ----------
    options : argparse.Namespace
        Of the images of ``run``.
    style : (H_A, W_A, n) uint16 or float32, or None
        Of :class:`~stylit_ref.cli.images_in.ImagesIn`.
    channels : int
        Of the picture.

    Returns
    -------
    DeepImages or None
        None for a style of 8 bits; and, with a note, if the format of the output has no more.
    """
    if style is None or not holds_bits_of(style, options.output, channels):
        return None
    fill = to_depth(read_image(options.fill), style.dtype) if options.fill else None
    return DeepImages(style, fill)


def holds_bits_of(style: np.ndarray, output: str, channels: int, what: str = "style") -> bool:
    """Whether a file of so many channels can hold the bit depth of a style; a note if not.

    The note calls the style ``what`` it is.
    """
    if style.dtype == np.float32 and Path(output).suffix.lower() not in FLOAT_FORMATS:
        note(
            f"{output}: holds display values of 8 bits; an .exr file keeps the floating point of "
            f"the {what}"
        )
        return False
    if style.dtype == np.uint16 and check_image_writable(output, channels, "uint16") == "uint8":
        note(
            f"{output}: holds 8 bits a channel; a .png, .tif or .exr file keeps the 16 of the "
            f"{what}"
        )
        return False
    return True
