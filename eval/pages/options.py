"""Options that several reports share."""

from pathlib import Path

from eval.pages.page import BUILT
from eval.scenes import BUNDLED, load_scene


def add_scene(parser, default):
    """``--scene``, ``--data`` and ``--step``, for :func:`scene_of`."""
    parser.add_argument(
        "--scene", default=default,
        help=f"TARGET/STYLE of the data set, or the folder of your own scene (default {default})",
    )  # fmt: skip
    add_data(parser)
    parser.add_argument(
        "--step", type=int, default=1, help="keep only every STEPth row and column (default 1)"
    )


def add_data(parser):
    """``--data``."""
    parser.add_argument("--data", default=BUNDLED, help="folder of the data set (default: bundled)")


def add_output(parser, default):
    """``--output``, for :func:`folder_of`."""
    parser.add_argument(
        "--output", type=Path, help=f"folder of the report (default: {BUILT}/{default})"
    )


def add_seed(parser):
    """``--seed``."""
    parser.add_argument("--seed", type=int, default=0, help="seed of every run (default 0)")


def add_numbers(parser):
    """``--numbers``."""
    parser.add_argument(
        "--numbers", action="store_true", help="write no images, for scenes you may not share"
    )


def scene_of(options):
    """Read the scene that the options name."""
    return load_scene(options.scene, options.data, options.step)


def folder_of(options, name):
    """The folder that ``--output`` names, or the report's default."""
    return options.output or BUILT / name
