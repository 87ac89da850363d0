"""Options that several reports have."""

from pathlib import Path

from eval.pages.page import BUILT
from eval.scenes import BUNDLED, load_scene


def add_scene(parser, default):
    """``--scene``, ``--data`` and ``--step``, for :func:`scene_of`."""
    parser.add_argument(
        "--scene", default=default,
        help=f"TARGET/STYLE of the data set, or a folder of yours (default {default})",
    )  # fmt: skip
    add_data(parser)
    parser.add_argument("--step", type=int, default=1, help="keep every STEPth pixel (default 1)")


def add_data(parser):
    """``--data``."""
    parser.add_argument("--data", default=BUNDLED, help="folder of a data set (default: bundled)")


def add_output(parser, default):
    """``--output``, for :func:`folder_of`."""
    parser.add_argument("--output", type=Path, help=f"folder (default: {BUILT}/{default})")


def add_seed(parser):
    """``--seed``."""
    parser.add_argument("--seed", type=int, default=0, help="of every run (default 0)")


def add_numbers(parser):
    """``--numbers``."""
    parser.add_argument(
        "--numbers", action="store_true", help="no images, for scenes that are not yours to share"
    )


def scene_of(options):
    """The scene that is asked for."""
    return load_scene(options.scene, options.data, options.step)


def folder_of(options, name):
    """The folder that is asked for, or the report's own."""
    return options.output or BUILT / name
