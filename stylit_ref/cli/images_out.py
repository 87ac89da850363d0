"""Files that ``run`` writes: refused before it starts, written whole or not at all."""

import argparse
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.deep_images import DeepImages, read_deep_images
from stylit_ref.cli.images_in import ImagesIn, paths_in
from stylit_ref.files.colour.profile import (
    ColourProfile,
    note_another_profile,
    read_colour_profile,
)
from stylit_ref.files.disk.paths import check_distinct, check_folder
from stylit_ref.files.field import Field
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.nnf_file import check_nnf_writable, write_nnf
from stylit_ref.files.write_image import check_image_writable, write_image
from stylit_ref.stylization.mask import filled_channels
from stylit_ref.stylization.params import MOST_LEVELS, Params
from stylit_ref.stylization.replaying import replay
from stylit_ref.stylization.stylize import Result

_LEVEL, _GUIDE_MAP = "level_{}.png", "guide_map_{}.png"


def add_output_option(group: argparse._ArgumentGroup) -> None:
    """Add the option that names the picture."""
    group.add_argument(
        "--output", required=True, metavar="IMAGE",
        help="the picture to write; its suffix chooses the format (.png, .tif, .exr, ...)",
    )  # fmt: skip


def add_other_outputs(group: argparse._ArgumentGroup) -> None:
    """Add the options that name what else a run can write."""
    group.add_argument(
        "--nnf", metavar="FILE.npy",
        help="write where every pixel came from, for 'stylit-ref replay'",
    )  # fmt: skip
    group.add_argument(
        "--save-levels", metavar="DIR",
        help="write the picture of every pyramid level into this folder, level_1.png the "
        "coarsest; with --method guide_map the maps too",
    )  # fmt: skip


class Outputs(NamedTuple):
    """What a run writes, and what it needs for that.

    Attributes
    ----------
    options : argparse.Namespace
    params : Params
    source_size : (int, int)
        Height and width of the style.
    mask : (H_B, W_B) bool or None
    guide_encodings : tuple of GuideEncoding
        How each pair of guides became 8 bits.
    profile : ColourProfile
        What the style's file says of its colours; the pictures say it too.
    deep : DeepImages or None
        What the picture is made of if it has more than 8 bits.
    """

    options: argparse.Namespace
    params: Params
    source_size: tuple[int, int]
    mask: NDArray[np.bool_] | None
    guide_encodings: tuple[GuideEncoding, ...]
    profile: ColourProfile
    deep: DeepImages | None

    def save_level(self, level: int, image: NDArray[np.uint8]) -> None:
        """Write the image of a level, where ``--save-levels`` asks for it."""
        if self.options.save_levels:
            file = Path(self.options.save_levels) / _LEVEL.format(level)
            write_image(file, image, profile=self.profile)

    def write(self, result: Result) -> None:
        """Write all that is left to write once a run is done."""
        field = Field(
            result.nnf,
            self.params.patch_width,
            self.params.vote_outliers,
            self.source_size,
            self.mask,
            self.guide_encodings,
        )
        image = result.image
        if self.deep:
            image = replay(field, self.deep.style, fill=self.deep.fill)
        write_image(self.options.output, image, profile=self.profile)
        if self.options.save_levels:
            for level, white in enumerate(result.guide_maps, 1):
                guide_map = white[:, :, None].astype(np.uint8) * 255
                write_image(Path(self.options.save_levels) / _GUIDE_MAP.format(level), guide_map)
        if self.options.nnf:
            write_nnf(self.options.nnf, field)


def check_outputs(options: argparse.Namespace, params: Params, images: ImagesIn) -> Outputs:
    """Refuse files that cannot be written, or would overwrite others.

    Parameters
    ----------
    options : argparse.Namespace
        Of the two functions above and of the images.
    params : Params
    images : ImagesIn

    Returns
    -------
    Outputs

    Raises
    ------
    InputError
    """
    channels = images.style.shape[2]
    if images.mask is not None:
        channels = filled_channels(channels, None if images.fill is None else images.fill.shape[2])
    check_image_writable(options.output, channels)
    if options.nnf:
        check_nnf_writable(options.nnf)
    if options.save_levels:
        check_folder(options.save_levels)
    check_distinct(
        [options.output, options.nnf, options.save_levels, *_level_files(options, params)],
        paths_in(options),
    )
    profile = read_colour_profile(options.style)
    if options.fill:
        note_another_profile(options.fill, profile)
    deep = read_deep_images(options, images.deep_style, channels)
    return Outputs(
        options, params, images.style.shape[:2], images.mask, images.guide_encodings, profile, deep
    )


def _level_files(options, params):
    """What ``--save-levels`` may write."""
    if not options.save_levels:
        return []
    names = (_LEVEL, _GUIDE_MAP) if params.traits.has_guide_map else (_LEVEL,)
    numbers = range(1, MOST_LEVELS + 1)
    return [Path(options.save_levels) / name.format(k) for name in names for k in numbers]
