"""What ``texture`` is asked for: a texture, or a repair of a picture."""

import argparse
import logging
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.texture_images import Source, read_colours, read_labels
from stylit_ref.cli.texture_masks import read_mask_of
from stylit_ref.errors import InputError
from stylit_ref.files.texture_field import read_texture_field
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.notes import note
from stylit_ref.texture.complete import complete_texture, make_tileable
from stylit_ref.texture.overlay import overlay
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.synthesize import (
    Progress,
    TextureResult,
    synthesize_texture,
    texture_session,
)


class Task(NamedTuple):
    """What is to be done.

    Attributes
    ----------
    run : callable
        Does it; called with what is called after each iteration.
    pixels : int
        How many pixels may change.
    overlay : callable, optional
        Draws the seams of a texture that was made, and the patches of one more iteration.
    hole : (H, W) bool, optional
        What is filled.
    """

    run: Callable[[Progress], TextureResult]
    pixels: int
    overlay: Callable[[TextureResult], NDArray[np.uint8]] | None = None
    hole: NDArray[np.bool_] | None = None


def task_of(options: argparse.Namespace, params: TextureParams, sources: Sequence[Source]) -> Task:
    """Read what else the task needs, beside the exemplars.

    Raises
    ------
    InputError
    """
    colours = [source.colours for source in sources]
    if options.complete:
        return _completion(options, params, colours)
    if options.tile_in_place:
        return _tiling(options, params, colours[0])
    return _synthesis(options, params, colours)


def _completion(options, params, colours):
    white = read_mask_of(options.mask, colours[0].shape[:2], options.complete)
    hole = ~white if options.inverted_mask else white
    if not hole.any() or hole.all():
        colour = "black" if options.inverted_mask else "white"
        how = "no" if not hole.any() else "nothing but"
        raise InputError(
            f"{options.mask} has {how} {colour} pixels; mark the holes alone in {colour}",
            parameter="mask",
        )
    if options.radius is None and not options.exemplar:
        params = _fitted_to_known(options.complete, hole, params)
    return Task(
        lambda progress: complete_texture(
            colours[0], hole, params, exemplars=colours[1:], unlocked=options.unlocked,
            seed=options.seed, threads=options.threads, progress=progress,
        ),
        hole.size if options.unlocked else int(hole.sum()),
        hole=hole,
    )  # fmt: skip


def _fitted_to_known(path, hole, params):
    """Parameters with a radius of which a patch fits between the holes."""
    from scipy.ndimage import distance_transform_edt  # imported late: SciPy takes long to load

    clearance = int(distance_transform_edt(np.pad(~hole, 1)).max())
    fits = 2 * clearance - 1
    if params.radius <= fits:
        return params
    note(
        f"is {params.radius}, but {fits} is used: between its holes, {path} has no room for larger "
        "patches",
        parameter="radius",
        level=logging.WARNING,
    )
    return replace(params, radius=fits, radius_end=min(params.radius_end, fits))


def _tiling(options, params, picture):
    height, width = picture.shape[:2]
    band = max(1, min(64, min(height, width) // 4)) if options.band is None else options.band
    return Task(
        lambda progress: make_tileable(
            picture, band, params, seed=options.seed, threads=options.threads, progress=progress
        ),
        height * width,
    )


def _synthesis(options, params, colours):
    start = read_texture_field(options.start) if options.start else None
    labels = guide = None
    if options.labels:
        labels = read_labels(options.labels, options.exemplar, options.size)
    if options.guide_target:
        guide = read_colours(options.guide_target)
    sizes = [given.shape[:2] for given in (labels, guide) if given is not None]
    if start is not None:
        sizes.append(_size_of_start(options, start, params))
    size = options.size or sizes[0]
    given = {
        "seed": options.seed,
        "labels": labels,
        "shares": options.shares,
        "source_guides": [read_colours(path) for path in options.guide_source] or None,
        "target_guide": guide,
    }

    def drawn(result):
        with using_threads(options.threads):
            return overlay(texture_session(colours, size, params, start=result.field, **given))

    return Task(
        lambda progress: synthesize_texture(
            colours, size, params, start=start, threads=options.threads, progress=progress, **given
        ),
        size[0] * size[1],
        drawn,
    )


def _size_of_start(options, start, params):
    height, width = start.coordinates.shape[:2]
    if options.size not in (None, (height, width)):
        raise InputError(
            f"{options.start}: has {width} x {height} pixels, and --size is {options.size[1]} x "
            f"{options.size[0]}; leave --size out"
        )
    if start.iterations >= params.iterations and not options.save_overlay:
        note(
            f"{options.start}: has {start.iterations} iterations already; give --iterations a "
            "larger number to go on",
            level=logging.WARNING,
        )
    return height, width
