"""Images that ``run`` reads."""

import argparse
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.read_image import read_guides, read_mask, read_uint8
from stylit_ref.stylization.checks import check_fill, check_guides, check_mask


class ImagesIn(NamedTuple):
    """What a run is made of.

    Attributes
    ----------
    style : (H_A, W_A, n) uint8
    source_guides, target_guides : tuple of (H, W, c) uint8
        Pairs with the same number of channels, of the style's size and of the target's.
    mask : (H_B, W_B) bool or None
    fill : (H_B, W_B, m) uint8 or None
    """

    style: NDArray[np.uint8]
    source_guides: tuple[NDArray[np.uint8], ...]
    target_guides: tuple[NDArray[np.uint8], ...]
    mask: NDArray[np.bool_] | None
    fill: NDArray[np.uint8] | None


def add_input_options(group: argparse._ArgumentGroup) -> None:
    """Add the options that name them."""
    group.add_argument("--style", required=True, metavar="IMAGE", help="the painting")
    group.add_argument(
        "--guide", nargs=2, action="append", required=True, metavar=("SOURCE", "TARGET"),
        help="a render pass of what was painted, and the same pass of the target; repeat --guide "
        "for each pass",
    )  # fmt: skip
    group.add_argument(
        "--weight", type=float, action=_Weigh, dest="guide_weights", default={}, metavar="W",
        help="how much the --guide before it counts, against 1 for the others",
    )  # fmt: skip


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
    guides = (path for pair in options.guide for path in pair)
    return [options.style, options.mask, options.fill, *guides]


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
    style = read_uint8(options.style)
    pairs = [read_guides(source, target) for source, target in options.guide]
    sources, targets = zip(*pairs, strict=True)
    names = ([f"--guide {path}" for path in side] for side in zip(*options.guide, strict=True))
    check_guides(style, sources, targets, *names)
    mask = read_mask(options.mask) if options.mask else None
    fill = read_uint8(options.fill) if options.fill else None
    if mask is not None:
        check_mask(mask, targets[0].shape[:2])
    if fill is not None:
        check_fill(fill, targets[0].shape[:2])
    return ImagesIn(style, sources, targets, mask, fill)


class _Weigh(argparse.Action):
    """``--weight`` belongs to the ``--guide`` before it: number of the guide to its weight."""

    def __call__(self, parser, options, value, option_string=None):
        weights = getattr(options, self.dest)
        if not options.guide:
            parser.error(f"{option_string} {value:g}: must follow the --guide it weighs")
        if len(options.guide) - 1 in weights:
            parser.error(f"{option_string} {value:g}: the --guide before it has a weight already")
        setattr(options, self.dest, {**weights, len(options.guide) - 1: value})
