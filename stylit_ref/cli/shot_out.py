"""What ``sequence`` and ``views`` write of each frame."""

import argparse
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.deep_images import holds_bits_of
from stylit_ref.cli.shot_in import ShotFiles, ShotIn
from stylit_ref.files.colour.bit_depth import to_depth
from stylit_ref.files.colour.profile import (
    ColourProfile,
    note_another_profile,
    read_colour_profile,
)
from stylit_ref.files.disk.paths import check_distinct
from stylit_ref.files.field import Field
from stylit_ref.files.nnf_file import check_nnf_writable, write_nnf
from stylit_ref.files.read_image import read_image, read_uint8
from stylit_ref.files.write_image import check_image_writable, write_image
from stylit_ref.stylization.mask import fill_masked, filled_channels
from stylit_ref.stylization.params import Params
from stylit_ref.stylization.replaying import replay
from stylit_ref.views.file_shot import FileShot
from stylit_ref.views.frame_result import FrameResult
from stylit_ref.views.run_files import files_of_run, files_to_replace


class ShotOut(NamedTuple):
    """The files of every frame, and what they are made with.

    Attributes
    ----------
    pictures : sequence of str
    fields : sequence of str
        Empty where no NNF is to be written.
    params : Params
    style_size : tuple of 2 int
    channels : int
        Of the style.
    shot : FileShot
    profile : ColourProfile
        What the file of the first painting says of its colours; the pictures say it too.
    deep_style : (H_A, W_A, n) uint16 or float32, or None
        What pictures are made of if they have more than 8 bits.
    fills : sequence of str
        For every frame what is shown where it is left alone; empty where nothing is.
    """

    pictures: Sequence[str]
    fields: Sequence[str]
    params: Params
    style_size: tuple[int, int]
    channels: int
    shot: FileShot
    profile: ColourProfile
    deep_style: NDArray[np.uint16 | np.float32] | None
    fills: Sequence[str]

    def writing(self, result: FrameResult) -> Callable[[], None]:
        """Make a frame; what is returned writes it, each file whole or not at all."""
        field = Field(
            result.nnf,
            self.params.patch_width,
            self.params.vote_outliers,
            self.style_size,
            self.shot.mask(result.frame),
            self.shot.encodings,
        )
        image = result.image
        if self.deep_style is not None:
            fill = None
            if self.fills:
                fill = to_depth(read_image(self.fills[result.frame]), self.deep_style.dtype)
            image = replay(field, self.deep_style, fill=fill)
        elif self.fills:
            opaque = image[:, :, : self.channels]
            image = fill_masked(opaque, field.mask, read_uint8(self.fills[result.frame]))
        return partial(self._write, result.frame, image, field)

    def _write(self, frame, image, field):
        write_image(self.pictures[frame], image, profile=self.profile)
        if self.fields:
            write_nnf(self.fields[frame], field)


def check_shot_outputs(
    options: argparse.Namespace,
    files: ShotFiles,
    shot: ShotIn,
    params: Params,
    pictures: Sequence[str],
    fields: Sequence[str],
) -> ShotOut:
    """Refuse files that cannot be written, or would overwrite others.

    Parameters
    ----------
    options : argparse.Namespace
    files : ShotFiles
    shot : ShotIn
    params : Params
    pictures, fields : sequences of str
        The files of every frame; no fields where none are to be written.

    Returns
    -------
    ShotOut

    Raises
    ------
    InputError
    """
    channels = shot.style.shape[2]
    if files.masks:
        fill = np.atleast_3d(read_uint8(files.fills[0])).shape[2] if files.fills else None
        channels = filled_channels(channels, fill)
    for picture in pictures:
        check_image_writable(picture, channels)
    for field in fields:
        check_nnf_writable(field)
    earlier = options.guide_encoding if options.guide_encoding.endswith(".npy") else None
    guides = {path for side in (*files.source_guides, *files.guides) for path in side}
    motion = {path for source in files.motion.values() for path in source.files}
    check_distinct(
        [*pictures, *fields, *_files_of_run(options, shot)],
        [*files.paintings, *files.masks, *files.fills, earlier, *guides, *motion],
    )
    deep_style = shot.deep_style
    if deep_style is not None and not holds_bits_of(deep_style, pictures[0], channels):
        deep_style = None
    profile = read_colour_profile(files.paintings[0])
    if files.fills:
        note_another_profile(files.fills[0], profile)
    return ShotOut(
        pictures,
        fields,
        params,
        shot.style.shape[:2],
        shot.style.shape[2],
        shot.shot,
        profile,
        deep_style,
        files.fills,
    )


def _files_of_run(options, shot) -> set[Path]:
    """What ``--run`` writes, and what it removes of a RUN that is there."""
    if not options.run:
        return set()
    files = files_of_run(shot.shot.names, shot.shot.pairs, shot.style, shot.source_guides)
    return {*files_to_replace(options.run), *(Path(options.run, name) for name in files.names)}
