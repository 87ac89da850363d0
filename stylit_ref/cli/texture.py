"""``stylit-ref texture``: textures that look like an exemplar, and repairs of pictures."""

import argparse
import sys
from contextlib import nullcontext
from functools import partial
from time import perf_counter

from stylit_ref.cli.finished import tell_finished
from stylit_ref.cli.parser import Parser
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.cli.texture_files import TextureFiles
from stylit_ref.cli.texture_images import fitted_to, read_sources
from stylit_ref.cli.texture_options import (
    add_texture_options,
    check_options,
    chosen_texture_params,
)
from stylit_ref.cli.texture_task import task_of
from stylit_ref.machine.interruption import put_off_interruptions
from stylit_ref.texture.iteration import Iteration
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
        params = fitted_to(params, sources)
    task = task_of(options, params, sources)
    inputs = [*paths, options.mask, options.labels, options.guide_target, *options.guide_source]
    files = TextureFiles(options, sources, [*inputs, options.start])
    interruptions = put_off_interruptions if options.keep_interrupted else _never
    with ProgressLine(options.quiet) as line:
        line.compile(lambda: kernels_of_texture(params))
        with interruptions() as interrupted:

            def progress(iteration: Iteration) -> bool:
                told = _told(iteration, params, task.pixels)
                line.tell(iteration.number / params.iterations, told)
                return interrupted()

            result = task.run(progress)
    image = files.picture(result)
    files.write(image, result, task.overlay and partial(task.overlay, result))
    if options.unlocked:
        _tell_changed(sources[0].colours, result.image, task.hole)
    if not options.quiet:
        if result.history:
            print(_told(result.history[-1], params, task.pixels), file=sys.stderr)
        tell_finished(options.output, image, perf_counter() - start, *files.others)


def _never():
    """In place of :func:`put_off_interruptions`, where Ctrl-C ends the work at once."""
    return nullcontext(lambda: False)


def _told(iteration, params, pixels):
    return (
        f"iteration {iteration.number} of {params.iterations}, cost "
        f"{iteration.cost / pixels:.3g} a pixel, {iteration.accepted} of {iteration.cells} patches "
        "accepted"
    )


def _tell_changed(before, after, hole):
    changed = (before != after).any(axis=-1) & ~hole
    print(f"{changed.sum()} of {(~hole).sum()} known pixels changed", file=sys.stderr)
