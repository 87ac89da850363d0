"""Images that ``run`` reads."""

import argparse
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.guide_options import (
    add_guide_options,
    guide_encoding,
    guide_files,
    naming_layers,
)
from stylit_ref.errors import InputError
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.guides.read_guides import read_guides
from stylit_ref.files.layers.names import SeveralLayersError
from stylit_ref.files.picture import read_picture
from stylit_ref.files.read_image import displayed, read_mask, read_uint8
from stylit_ref.stylization.checks import check_fill, check_guides, check_mask


class ImagesIn(NamedTuple):
    """What a run is made of.

    Attributes
    ----------
    style : (H_A, W_A, n) uint8
    deep_style : (H_A, W_A, n) uint16 or float32, or None
        The style as its file has it, where that is more than 8 bits.
    source_guides, target_guides : tuple of (H, W, c) uint8
        Pairs with the same number of channels, of the style's size and of the target's.
    guide_encodings : tuple of GuideEncoding
        How each pair became 8 bits.
    mask : (H_B, W_B) bool or None
    fill : (H_B, W_B, m) uint8 or None
    """

    style: NDArray[np.uint8]
    deep_style: NDArray[np.uint16 | np.float32] | None
    source_guides: tuple[NDArray[np.uint8], ...]
    target_guides: tuple[NDArray[np.uint8], ...]
    guide_encodings: tuple[GuideEncoding, ...]
    mask: NDArray[np.bool_] | None
    fill: NDArray[np.uint8] | None


def add_input_options(group: argparse._ArgumentGroup) -> None:
    """Add the options that name them."""
    add_style_option(group)
    add_guide_options(group)


def add_style_option(group: argparse._ArgumentGroup) -> None:
    """Add ``--style``."""
    group.add_argument("--style", required=True, metavar="IMAGE", help="the painting")


def add_mask_options(group: argparse._ArgumentGroup) -> None:
    """Add the options that leave a part of the target alone."""
    group.add_argument(
        "--mask", metavar="IMAGE", help="leave the pixels of the target alone that are white here"
    )
    group.add_argument(
        "--fill", metavar="IMAGE", help="show this image there (default: transparent)"
    )


def paths_in(options: argparse.Namespace) -> list[str | None]:
    """Files that the options name, None among them."""
    guides = (path for pair in guide_files(options) for path in pair)
    earlier = options.guide_encoding if options.guide_encoding.endswith(".npy") else None
    return [options.style, options.mask, options.fill, earlier, *guides]


def read_images(options: argparse.Namespace) -> ImagesIn:
    """Read the images and refuse those that do not fit together, by their files' names.

    Parameters
    ----------
    options : argparse.Namespace
        Of the two functions above.

    Returns
    -------
    ImagesIn

    Raises
    ------
    InputError
    """
    if options.fill and not options.mask:
        raise InputError("needs a --mask that says which pixels to fill", parameter="fill")
    picture = read_picture(options.style)
    style = displayed(options.style, picture)
    deep_style = None if picture.pixels.dtype == np.uint8 else picture.pixels
    files = guide_files(options)
    try:
        guides = read_guides(files, guide_encoding(options))
    except SeveralLayersError as error:
        raise naming_layers(error) from None
    sources, (targets,) = guides.source, guides.targets
    names = ([f"--guide {path}" for path in side] for side in zip(*files, strict=True))
    check_guides(style, sources, targets, *names)
    mask = read_mask(options.mask) if options.mask else None
    fill = read_uint8(options.fill) if options.fill else None
    if mask is not None:
        check_mask(mask, targets[0].shape[:2])
    if fill is not None:
        check_fill(fill, targets[0].shape[:2])
    return ImagesIn(style, deep_style, sources, targets, guides.encodings, mask, fill)
