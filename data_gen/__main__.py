"""Render a data set of scenes and paint the styles; finished parts are not made again."""

import argparse
import math
import re
import signal
import sys
from pathlib import Path

from data_gen.manifest import DataError
from data_gen.produce import produce
from data_gen.renderer import MissingRendererError
from data_gen.scenes import SCENES, USUAL

SMALLEST, LARGEST = 16, 8192


def main(arguments=None):
    """Make the missing pieces; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m data_gen", description=__doc__)
    parser.add_argument(
        "--size", type=_size, default=(1200, 912), metavar="WIDTHxHEIGHT",
        help="pixels of every image (default 1200x912)",
    )  # fmt: skip
    parser.add_argument(
        "--scenes", type=_scenes, default=USUAL,
        help=f"scenes, commas between, of {', '.join(SCENES)} (default: {', '.join(USUAL)}); the "
        "source is always made",
    )  # fmt: skip
    parser.add_argument(
        "--samples", type=_count, default=64, help="samples a pixel, a square number (default 64)"
    )
    parser.add_argument(
        "--folder", type=Path, help="folder of the data set (default build/data/WIDTHxHEIGHT)"
    )
    parser.add_argument(
        "--guides-only", action="store_true", help="write no passes.exr; the bundled set has none"
    )
    options = parser.parse_args(arguments)
    width, height = options.size
    folder = options.folder or Path("build/data") / f"{width}x{height}"
    try:
        made = produce(
            folder, options.size, options.scenes, options.samples, exr=not options.guides_only
        )
    except (DataError, MissingRendererError, OSError) as error:
        print(f"data_gen: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("data_gen: interrupted; finished pieces are kept", file=sys.stderr)
        return 130
    print(f"{folder}: {'made ' + ', '.join(made) if made else 'nothing to do, all is finished'}")
    return 0


def _size(text):
    match = re.fullmatch(r"(\d+)x(\d+)", text)
    size = tuple(map(int, match.groups())) if match else (0, 0)
    if not all(SMALLEST <= length <= LARGEST for length in size):
        raise argparse.ArgumentTypeError(
            f"is {text}; it must be WIDTHxHEIGHT, each from {SMALLEST} to {LARGEST} pixels"
        )
    return size


def _scenes(text):
    scenes = [name.strip() for name in text.split(",") if name.strip()]
    unknown = sorted(set(scenes) - set(SCENES))
    if unknown:
        raise argparse.ArgumentTypeError(
            f"there is no scene {', '.join(unknown)}; choose from {', '.join(SCENES)}"
        )
    return scenes


def _count(text):
    if (
        not text.isdecimal()
        or not 1 <= int(text) <= 4096
        or math.isqrt(int(text)) ** 2 != int(text)
    ):
        raise argparse.ArgumentTypeError(f"is {text}; it must be a square number from 1 to 4096")
    return int(text)


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as Ctrl-C
    sys.exit(main())
