"""``stylit-ref texture``: textures that look like an exemplar, and repairs of pictures."""

import argparse
import sys
from collections.abc import Callable
from contextlib import nullcontext
from dataclasses import replace
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.deep_images import holds_bits_of
from stylit_ref.cli.finished import tell_finished
from stylit_ref.cli.parser import Parser
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.cli.texture_images import Source, read_colours, read_labels, read_sources
from stylit_ref.cli.texture_options import (
    add_texture_options,
    check_options,
    chosen_texture_params,
)
from stylit_ref.errors import InputError
from stylit_ref.files.colour.profile import read_colour_profile
from stylit_ref.files.disk.paths import check_distinct
from stylit_ref.files.read_image import read_mask
from stylit_ref.files.texture_field import check_texture_field_writable, write_texture_field
from stylit_ref.files.write_image import check_image_writable, write_image
from stylit_ref.machine.interruption import put_off_interruptions
from stylit_ref.machine.kernel import compile_missing
from stylit_ref.notes import note
from stylit_ref.texture.complete import complete_texture, make_tileable
from stylit_ref.texture.iteration import Iteration
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.replaying import replay_texture
from stylit_ref.texture.synthesize import Progress, TextureResult, synthesize_texture
from stylit_ref.texture.warm_up import kernels_of_texture

_USAGE = "%(prog)s --exemplar IMAGE --size WxH --output IMAGE [options]"

_DESCRIPTION = """\
Make a texture of any size that looks like an exemplar and tiles, by stitching patches of it:

  stylit-ref texture --exemplar pebbles.png --size 1024x1024 --output texture.png

Or fill the holes of a picture with patches of what is known:

  stylit-ref texture --complete wall.png --mask holes.png --output completed.png

Or change a picture near its borders so that it tiles:

  stylit-ref texture --tile-in-place wall.png --output tiling.png"""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "texture",
        help="make a texture that looks like an exemplar and tiles; repair a picture",
        usage=_USAGE,
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    add_texture_options(parser)


def run(options: argparse.Namespace) -> None:
    """Read, synthesize, write; all is checked before the work starts."""
    start = perf_counter()
    check_options(options)
    params = chosen_texture_params(options)
    paths = [*filter(None, [options.complete or options.tile_in_place]), *options.exemplar]
    sources = read_sources(paths)
    if options.radius is None:
        params = _fitted_to(params, sources)
    made, pixels = _task(options, params, sources)
    profile = read_colour_profile(paths[0])
    deep = sources[0].is_deep and holds_bits_of(
        sources[0].pixels, options.output, sources[0].pixels.shape[2], "exemplar"
    )
    _check_outputs(options, paths, (sources[0].pixels if deep else sources[0].colours).shape[2])
    interruptions = put_off_interruptions if options.keep_interrupted else _never
    with ProgressLine(options.quiet) as line, interruptions() as interrupted:

        def progress(iteration: Iteration) -> bool:
            line.tell(iteration.number / params.iterations, _told(iteration, params, pixels))
            return interrupted()

        if line.is_shown:
            compile_missing(kernels_of_texture(params), line.compiling)
        result = made(progress)
    image = _picture(result, sources, deep)
    write_image(options.output, image, curve="srgb", profile=profile)
    if options.save_tiled:
        write_image(options.save_tiled, np.tile(image, (2, 2, 1)), curve="srgb", profile=profile)
    if options.save_coordinates:
        write_texture_field(options.save_coordinates, result.field)
    if options.complete and options.unlocked:
        _tell_changed(sources[0].colours, result.image, _hole(options))
    if not options.quiet:
        if result.history:
            print(_told(result.history[-1], params, pixels), file=sys.stderr)
        others = filter(None, (options.save_tiled, options.save_coordinates))
        tell_finished(options.output, image, perf_counter() - start, *others)


def _fitted_to(params: TextureParams, sources: list[Source]) -> TextureParams:
    """The preset's radius, or the largest that fits the smallest source."""
    height, width = min((source.colours.shape[:2] for source in sources), key=min)
    fits = 2 * ((min(height, width) + 1) // 2) - 1
    if params.radius <= fits:
        return params
    note(
        f"is {params.radius}, but {fits} is used: an exemplar has {width} x {height} pixels",
        parameter="radius",
    )
    return replace(params, radius=fits, radius_end=min(params.radius_end, fits))


def _never():
    """In place of :func:`put_off_interruptions`, where Ctrl-C ends the work at once."""
    return nullcontext(lambda: False)


def _task(
    options: argparse.Namespace, params: TextureParams, sources: list[Source]
) -> tuple[Callable[[Progress], TextureResult], int]:
    """What is to be done, and how many pixels may change by it."""
    colours = [source.colours for source in sources]
    common = {"seed": options.seed, "threads": options.threads}
    height, width = colours[0].shape[:2]
    if options.complete:
        hole = _hole(options)
        if hole.shape != (height, width):
            raise InputError(
                f"{options.mask}: has {hole.shape[1]} x {hole.shape[0]} pixels, and "
                f"{options.complete} {width} x {height}; make it as large"
            )
        return (
            lambda progress: complete_texture(
                colours[0], hole, params, exemplars=colours[1:], unlocked=options.unlocked,
                progress=progress, **common,
            ),
            hole.size if options.unlocked else max(int(hole.sum()), 1),
        )  # fmt: skip
    if options.tile_in_place:
        band = min(64, min(height, width) // 4) if options.band is None else options.band
        return (
            lambda progress: make_tileable(colours[0], band, params, progress=progress, **common),
            height * width,
        )
    labels = _labels(options)
    guide = read_colours(options.guide_target) if options.guide_target else None
    size = options.size or (labels if labels is not None else guide).shape[:2]
    guides = [read_colours(path) for path in options.guide_source] or None
    return (
        lambda progress: synthesize_texture(
            colours, size, params, labels=labels, shares=options.shares, source_guides=guides,
            target_guide=guide, progress=progress, **common,
        ),
        size[0] * size[1],
    )  # fmt: skip


def _labels(options) -> NDArray[np.uint8] | None:
    if not options.labels:
        return None
    return read_labels(options.labels, options.exemplar, options.size)


def _hole(options) -> NDArray[np.bool_]:
    white = read_mask(options.mask)
    hole = ~white if options.inverted_mask else white
    if not hole.any() or hole.all():
        colour = "black" if options.inverted_mask else "white"
        how = "no" if not hole.any() else "nothing but"
        raise InputError(
            f"{options.mask} has {how} {colour} pixels; mark the holes alone in {colour}",
            parameter="mask",
        )
    return hole


def _check_outputs(options, paths, channels):
    check_image_writable(options.output, channels)
    if options.save_tiled:
        check_image_writable(options.save_tiled, channels)
    if options.save_coordinates:
        check_texture_field_writable(options.save_coordinates)
    check_distinct(
        [options.output, options.save_tiled, options.save_coordinates],
        [*paths, options.mask, options.labels, options.guide_target, *options.guide_source],
    )


def _picture(result, sources, deep):
    """The texture, with the depth and the alpha of its exemplars where the file can hold them."""
    if not deep:
        return result.image
    return replay_texture(result.field, [source.pixels for source in sources])


def _told(iteration, params, pixels):
    return (
        f"iteration {iteration.number} of {params.iterations}, cost "
        f"{iteration.cost / pixels:.3g} a pixel, {iteration.accepted} of {iteration.cells} patches "
        "accepted"
    )


def _tell_changed(before, after, hole):
    changed = (before != after).any(axis=-1) & ~hole
    print(f"{changed.sum()} of {(~hole).sum()} known pixels changed", file=sys.stderr)
