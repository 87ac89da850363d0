"""Options that name the guides of ``run``, and what together they say."""

import argparse
import math
from collections.abc import Sequence
from pathlib import Path

from stylit_ref.cli.parameter_options import parsed
from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import split_layer
from stylit_ref.files.disk.patterns import is_pattern
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.layers.names import SeveralLayersError
from stylit_ref.files.realtime_field import read_any_field
from stylit_ref.parameters import Number


def add_guide_options(
    group: argparse._ArgumentGroup, target: str = "TARGET", of_what: str = "of the target"
) -> None:
    """Add them.

    Parameters
    ----------
    group : argparse._ArgumentGroup
    target, of_what : str
        What the second file is called in the help, and what it is of.
    """
    group.add_argument(
        "--guide", nargs=2, action="append", required=True, metavar=("SOURCE", target),
        help=f"a render pass of what was painted, and the same pass {of_what}; repeat --guide "
        "for each pass",
    )  # fmt: skip
    group.add_argument(
        "--guide-layers", type=_names, action=_OfGuide, default={}, metavar="LAYER[,LAYER...]",
        help="of the two files of the --guide before it take these layers, a guide each: "
        "Combined,DiffDir,IndexOB; of two folders the images of these names",
    )  # fmt: skip
    group.add_argument(
        "--weight", type=parsed(Number(0, math.inf)), action=_OfGuide, dest="guide_weights",
        default={}, metavar="W",
        help="how much the --guide before it counts, against 1 for the others; with --guide-layers "
        "how much each of its layers does",
    )  # fmt: skip


def add_encoding_option(group: argparse._ArgumentGroup) -> None:
    """Add the option that says how guides become 8 bits."""
    group.add_argument(
        "--guide-encoding", default="auto", metavar="HOW",
        help="how floating-point guides become 8 bits: auto: so that hardly any value is clipped, "
        "and labels become colours; none: values outside [0, 1] are clipped; FILE.npy: as in the "
        "run that wrote it with --nnf (default %(default)s)",
    )  # fmt: skip


def guide_files(options: argparse.Namespace) -> list[tuple[str, str]]:
    """Source and target of each guide, each with its layer where ``--guide-layers`` names some.

    Raises
    ------
    InputError
        If a file is not there.
    """
    for path in (path for pair in options.guide for path in pair):
        _refuse_pattern(path)
    sides = (files_of_side(options, paths) for paths in zip(*options.guide, strict=True))
    return list(zip(*sides, strict=True))


def files_of_side(options: argparse.Namespace, paths: Sequence[str]) -> list[str]:
    """The file of each guide on one side, with its layer where ``--guide-layers`` names some.

    Parameters
    ----------
    options : argparse.Namespace
    paths : sequence of str
        A file for each ``--guide``, or a folder.

    Raises
    ------
    InputError
        If a file is not there.
    """
    files = []
    for number, path in enumerate(paths):
        layers = options.guide_layers.get(number)
        if not layers and Path(path).is_dir():
            raise InputError(f"{path}: is a folder; name its images with --guide-layers")
        files += [_layer_of(path, layer) for layer in layers] if layers else [path]
    return files


def naming_layers(error: SeveralLayersError) -> SeveralLayersError:
    """The refusal of a file with several layers, which tells the option that names them."""
    other_way = ", or name layers of both files with --guide-layers"
    return SeveralLayersError(error.file, error.best, error.names, other_way)


def guide_weights(options: argparse.Namespace) -> tuple[float, ...]:
    """The weight of each of these guides."""
    weights = []
    for number in range(len(options.guide)):
        layers = options.guide_layers.get(number, [""])
        weights += [options.guide_weights.get(number, 1.0)] * len(layers)
    return tuple(weights)


def guide_encoding(options: argparse.Namespace) -> str | Sequence[GuideEncoding]:
    """What :func:`stylit_ref.read_guides` is to do.

    Raises
    ------
    InputError
        If it is none of the choices, or the file of an earlier run has no encodings.
    """
    chosen = options.guide_encoding
    if chosen in ("auto", "none"):
        return chosen
    if not chosen.endswith(".npy"):
        raise InputError(
            f"is {chosen}; it must be auto, none, or the .npy file of an earlier run",
            parameter="guide_encoding",
        )
    encodings = read_any_field(chosen).guide_encodings
    if not encodings:
        raise InputError(f"{chosen}: does not say how the guides of its run were encoded")
    return encodings


def _refuse_pattern(path):
    """Refuse a name with a placeholder, unless a file or folder has that very name."""
    if not is_pattern(path) or Path(path).is_dir():
        return
    try:
        split_layer(path)
    except InputError:
        raise InputError(
            f"{path}: stands for the files of many frames; 'stylit-ref sequence' takes such names "
            "and stylizes every frame"
        ) from None


def _layer_of(path, layer):
    """``scene.exr`` and ``Combined`` are ``scene.exr:Combined``; a view layer may stand between.

    ``renders`` and ``FULL`` are ``renders/FULL.png``, or the only other image of that name.
    """
    if Path(path).is_dir():
        return _image_in(Path(path), layer)
    _, view_layer = split_layer(path)
    return f"{path}.{layer}" if view_layer else f"{path}:{layer}"


def _image_in(folder, name):
    images = sorted(file for file in folder.iterdir() if file.is_file() and file.suffix)
    found = [file for file in images if file.stem == name]
    if len(found) == 1:
        return str(found[0])
    if found:
        several = ", ".join(file.name for file in found)
        raise InputError(f"{folder}: has several images {name!r}: {several}; name a --guide each")
    known = ", ".join(file.stem for file in images) or "none"
    raise InputError(f"{folder}: has no image {name!r}; its images are: {known}")


def _names(text):
    names = [name.strip() for name in text.split(",")]
    if not all(names):
        raise argparse.ArgumentTypeError(f"is {text!r}; it must be names with commas between them")
    return names


class _OfGuide(argparse.Action):
    """An option of the ``--guide`` before it: number of the guide to its value."""

    def __call__(self, parser, options, value, option_string=None):
        values = getattr(options, self.dest)
        if not options.guide:
            parser.error(f"{option_string}: must follow the --guide it belongs to")
        if len(options.guide) - 1 in values:
            parser.error(f"{option_string}: the --guide before it has one already")
        setattr(options, self.dest, {**values, len(options.guide) - 1: value})
