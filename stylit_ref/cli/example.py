"""``stylit-ref example``: the bundled scenes, copied to where they can be played with."""

import argparse
import shlex
import shutil
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from stylit_ref.cli.parser import Parser
from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import real_path
from stylit_ref.files.disk.whole_file import temporary_name

_MANIFEST = "manifest.json"


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "example",
        help="copy the bundled scenes and say how to stylize one",
        description="Copy the bundled scenes into a folder: seven targets, a house, and a sphere "
        "painted in four\nstyles. Print a command that stylizes one, and one for three frames of a "
        "camera that\nmoves. In a folder of scenes, copy only what is missing.",
    )
    parser.set_defaults(command=run, parser=parser)
    parser.add_argument("folder", metavar="FOLDER", help="where to copy them, for instance scenes")


def run(options: argparse.Namespace) -> None:
    """Copy them and print commands that stylize one, and three frames of the house.

    A new folder appears whole or not at all. In one that has them already, files that are missing
    are copied and all others stay.

    Raises
    ------
    InputError
        If the folder holds other files or cannot be made, or the scenes are not installed.
    """
    folder, place = Path(options.folder), real_path(options.folder)
    try:
        from data_gen import guides
    except ModuleNotFoundError:
        raise InputError("the scenes are not installed with this package") from None
    bundled = Path(guides.__file__).with_name("bundled")
    if place.is_file():
        raise InputError(f"{folder}: is a file; name a new folder")
    if not place.exists():
        _copy_whole(bundled, folder, place)
    elif _is_empty(place) or _is_copy(place, bundled):
        _complete(bundled, folder, place)
    else:
        raise InputError(f"{folder}: holds other files; name a new folder")
    print(f"The scenes are in {folder}. To stylize one, run here:", file=sys.stderr)
    passes = *guides.LIGHT_PASSES, "IDMASK"
    print(_command(folder, passes))
    print(
        "To stylize three frames of a camera that moves around the house:\n"
        f"{_sequence(folder, passes)}",
        file=sys.stderr,
    )


def _is_empty(place):
    return place.is_dir() and not any(place.iterdir())


def _is_copy(place, bundled):
    """Whether a folder was made by this command, whole or not."""
    manifest = place / _MANIFEST
    return manifest.is_file() and manifest.read_bytes() == (bundled / _MANIFEST).read_bytes()


def _command(folder, guides):
    """A command that stylizes one of the scenes.

    Its guides are those of Fišer et al. 2016, and one that tells objects apart: without it paint
    spills from one thing onto another that is lit alike.
    """
    folder = _no_option(folder)
    words = ["stylit-ref", "run", *_painted(folder, guides, "teapot")]
    return shlex.join([*words, "--output", f"{folder}/stylized.png"])


def _sequence(folder, guides):
    """A command that stylizes a row of views of the house, as frames of a shot."""
    folder = _no_option(folder)
    words = ["stylit-ref", "sequence", "--preset", "fast", *_painted(folder, guides, "house/1_%d")]
    words += ["--motion", f"{folder}/house/motion/1_%d_to_1_%d.exr"]
    words += ["--ids", f"{folder}/house/1_%d/IDMASK.png"]
    return shlex.join([*words, "--output", f"{folder}/house.%d.png"])


def _painted(folder, guides, target):
    """Options for the oil painting of the sphere, and its guides beside those of a target."""
    words = ["--style", f"{folder}/source/styles/oil.png"]
    for guide in guides:
        words += ["--guide", f"{folder}/source/{guide}.png", f"{folder}/{target}/{guide}.png"]
    return words


def _no_option(folder):
    """The folder by a name that a command line does not take for an option."""
    return f"./{folder}" if str(folder).startswith("-") else str(folder)


def _copy_whole(bundled, folder, place):
    """Copy to where ``folder`` leads: it appears whole or not at all, with those it is in."""
    try:
        first = [part for part in (place, *place.parents) if not part.exists()][-1]
        with TemporaryDirectory(prefix=".", dir=first.parent) as partial:
            _copy(bundled, Path(partial) / place.relative_to(first.parent))
            (Path(partial) / first.name).rename(first)
    except OSError as error:
        raise InputError(f"{folder}: cannot be written: {error.strerror}") from None


def _complete(bundled, folder, place):
    """Copy what is missing, the manifest first: by it a later call knows the folder."""
    try:
        for file in sorted(_files(bundled), key=lambda file: file.name != _MANIFEST):
            copy = place / file.relative_to(bundled)
            if not copy.exists():
                copy.parent.mkdir(parents=True, exist_ok=True)
                with temporary_name(copy) as partial:
                    shutil.copyfile(file, partial)
                    partial.rename(copy)
    except OSError as error:
        raise InputError(f"{folder}: cannot be written: {error.strerror}") from None


def _copy(folder, copy):
    """Copy all files; unlike shutil's copy, it ends at the first that fails."""
    for file in _files(folder):
        place = copy / file.relative_to(folder)
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, place)


def _files(folder):
    return filter(Path.is_file, folder.rglob("*"))
