"""What ``sequence`` and ``views`` read: a style, and a shot of files that fit together."""

import argparse
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.guide_options import guide_encoding, naming_layers
from stylit_ref.cli.motion_files import MotionFiles
from stylit_ref.cli.motion_look import check_motion_files
from stylit_ref.cli.paintings import side_by_side
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.cli.scene_files import SceneFiles, check_positions_files
from stylit_ref.cli.shot_problems import ShotProblems
from stylit_ref.errors import InputError
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.guides.remarks import GuideRemarks
from stylit_ref.files.guides.survey import GuideLook, look_at, read_source_guide
from stylit_ref.files.layers.names import SeveralLayersError
from stylit_ref.files.picture import read_picture
from stylit_ref.files.read_image import displayed, read_mask, read_uint8
from stylit_ref.stylization.checks import (
    check_fill,
    check_mask,
    check_source_guides,
    size_text,
)
from stylit_ref.views.file_shot import FileShot


class Times(NamedTuple):
    """The guide of time (:mod:`stylit_ref.views.keyframes`).

    Attributes
    ----------
    paintings, frames : sequences of int
        Its value in every painting, and in every frame.
    """

    paintings: Sequence[int]
    frames: Sequence[int]


class ShotFiles(NamedTuple):
    """The files of a shot.

    Attributes
    ----------
    paintings : sequence of str
        One, or several painted frames.
    source_guides : sequence of sequence of str
        For every painting the file of each guide.
    names : sequence of str
        What the frames are called.
    guides : sequence of sequence of str
        For every frame the file of each guide.
    motion : mapping from (int, int) to MotionFiles
        By ``(to, other)``.
    problems : ShotProblems
        It knows the patterns of the files.
    masks : sequence of str, optional
        For every frame the image that is white where the frame is left alone.
    fills : sequence of str, optional
        For every frame the image that is shown there.
    times : Times, optional
        Where several frames of the shot were painted.
    grid : tuple of 2 int, optional
        Rows and columns, if the frames are a grid of views, row by row.
    cameras : sequence of mapping, optional
        What is known of the camera of every frame.
    scene : SceneFiles, optional
        What the frames show.
    """

    paintings: Sequence[str]
    source_guides: Sequence[Sequence[str]]
    names: Sequence[str]
    guides: Sequence[Sequence[str]]
    motion: Mapping[tuple[int, int], MotionFiles]
    problems: ShotProblems
    masks: Sequence[str] = ()
    fills: Sequence[str] = ()
    times: Times | None = None
    grid: tuple[int, int] | None = None
    cameras: Sequence[Mapping[str, Any]] | None = None
    scene: SceneFiles = SceneFiles()


class ShotIn(NamedTuple):
    """A shot that has been looked at.

    Attributes
    ----------
    style : (H_A, W_A, n) uint8
        All paintings side by side.
    deep_style : (H_A, W_A, n) uint16 or float32, or None
        The style as its files have it, where that is more than 8 bits.
    source_guides : tuple of (H_A, W_A, c) uint8
        That of time behind them, if there is one.
    shot : FileShot
    """

    style: NDArray[np.uint8]
    deep_style: NDArray[np.uint16 | np.float32] | None
    source_guides: tuple[NDArray[np.uint8], ...]
    shot: FileShot


def read_shot(options: argparse.Namespace, files: ShotFiles, line: ProgressLine) -> ShotIn:
    """Read style and source guides, look at every frame, and refuse what does not fit together.

    Parameters
    ----------
    options : argparse.Namespace
        With ``--guide-encoding``.
    files : ShotFiles
    line : ProgressLine
        Tells how many frames have been looked at.

    Returns
    -------
    ShotIn

    Raises
    ------
    InputError
        One for all frames.
    """
    paintings = files.paintings
    pictures = [read_picture(painting) for painting in paintings]
    styles = [displayed(*each) for each in zip(paintings, pictures, strict=True)]
    style = side_by_side(styles, paintings)
    pixels = side_by_side([picture.pixels for picture in pictures], paintings)
    encodings = _encodings(options, len(files.guides[0]))
    looks = _look_at_all(options, files, encodings[0] == "auto", line)
    guides, chosen = _read_source_guides(files, styles, looks, encodings)
    channels = tuple(guide.shape[2] for guide in guides)
    if files.times:
        columns = np.repeat(np.uint8(files.times.paintings), styles[0].shape[1])
        guides = (*guides, np.tile(columns[:, None], (style.shape[0], 1, 1)))
    shot = FileShot(
        tuple(files.names),
        looks[0][len(paintings)].size,
        tuple(map(tuple, files.guides)),
        chosen,
        channels,
        files.motion,
        tuple(files.masks),
        tuple(files.times.frames) if files.times else (),
    )
    return ShotIn(style, None if pixels.dtype == np.uint8 else pixels, guides, shot)


def _read_source_guides(files, styles, looks, encodings):
    """Each guide of all paintings side by side, and its encoding."""
    remarks, of_paintings, chosen = GuideRemarks(), [], ()
    for sources, style in zip(files.source_guides, styles, strict=True):
        read = [
            read_source_guide(*each, remarks)
            for each in zip(sources, files.guides[0], looks, encodings, strict=True)
        ]
        guides, chosen = zip(*read, strict=True)
        check_source_guides(style, guides, [f"--guide {source}" for source in sources])
        of_paintings.append(guides)
    remarks.note()
    guides = (side_by_side(each, files.paintings) for each in zip(*of_paintings, strict=True))
    return tuple(guides), chosen


def _encodings(options, guides) -> Sequence[str] | Sequence[GuideEncoding]:
    chosen = guide_encoding(options)
    if isinstance(chosen, str):
        return [chosen] * guides
    if len(chosen) != guides:
        raise InputError(
            f"holds {len(chosen)} encodings for {guides} guides; each guide needs one",
            parameter="guide_encoding",
        )
    return chosen


def _look_at_all(options, files, needs_values, line) -> list[list[GuideLook]]:
    """For each guide a look at the source and at all frames."""
    sides, looks, problems = [*files.source_guides, *files.guides], [], files.problems
    for number, side in enumerate(sides):
        line.look(number, len(sides) - 1)
        for path in side:
            try:
                looks.append(look_at(path, needs_values=needs_values))
            except SeveralLayersError as error:
                told = naming_layers(error) if "guide_layers" in options else error
                problems.add(told.sentence, path)
            except InputError as error:
                problems.add(error.sentence, path)
    guides, size = len(files.guides[0]), None
    by_guide = [looks[number::guides] for number in range(guides)]
    if len(looks) == guides * len(sides):
        size = by_guide[0][len(files.paintings)].size
        _add_misfits(files, by_guide)
    if options.run and size:
        check_positions_files(files.scene, files.names, files.cameras, size, problems)
    check_motion_files(files.motion.values(), size, problems)
    _check_masks(files, size)
    _check_fills(files, size)
    problems.refuse()
    return by_guide


def _check_masks(files, size):
    """Masks of another size, and those that leave nothing to stylize."""
    for path in files.masks:
        try:
            mask = read_mask(path)
            if size:
                check_mask(mask, size)
        except InputError as error:
            said = error.sentence if error.parameter is None else f"{path}: {error.sentence}"
            files.problems.add(said, path)


def _check_fills(files, size):
    """Fills of another size, and with other colours than the first."""
    channels = None
    for path in dict.fromkeys(files.fills):
        try:
            fill = np.atleast_3d(read_uint8(path))
            check_fill(fill, size or fill.shape[:2])
            channels = channels or fill.shape[2]
            if fill.shape[2] != channels:
                raise InputError(
                    f"{path}: has {fill.shape[2]} channels, and {files.fills[0]} {channels}; all "
                    "must have as many"
                )
        except InputError as error:
            said = error.sentence if error.parameter is None else f"{path}: {error.sentence}"
            files.problems.add(said, path)


def _add_misfits(files, looks):
    """Frames of another size than the first, and with other colours than most."""
    paintings = len(files.paintings)
    first, size = files.guides[0][0], looks[0][paintings].size
    for frame, paths in enumerate(files.guides, paintings):
        for path, of_guide in zip(paths, looks, strict=True):
            look = of_guide[frame]
            if look.size != size:
                files.problems.add(
                    f"{path}: is {size_text(look.size)} but {first} is {size_text(size)}; all "
                    "frames must have the same size",
                    path,
                )
            colours = max(each.colours for each in of_guide)
            if look.colours not in (1, colours):
                files.problems.add(
                    f"{path}: has {look.colours} channels, and others of this guide {colours}", path
                )
