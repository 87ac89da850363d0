"""``stylit-ref example``: the bundled scenes, copied to where they can be played with."""

import shlex
import shutil
from pathlib import Path
from tempfile import TemporaryDirectory

from stylit_ref.errors import InputError
from stylit_ref.files.output_file import real_path


def add_parser(commands):
    """Add the command."""
    parser = commands.add_parser(
        "example",
        help="copy the bundled scenes and say how to stylize one",
        description="Copy the bundled scenes, seven targets, a house, and a sphere painted in four "
        "styles, into a new folder, and print a command that stylizes one.",
        allow_abbrev=False,
    )
    parser.set_defaults(command=run, parser=parser)
    parser.add_argument("folder", metavar="FOLDER", help="new folder for them")


def run(options):
    """Copy them, whole or not at all, and print a command that stylizes one.

    Raises
    ------
    InputError
        If the folder is there already or cannot be made, or the scenes are not installed.
    """
    folder, place = Path(options.folder), real_path(options.folder)
    if place.exists():
        raise InputError(f"{folder}: exists; name a new folder")
    try:
        from data_gen import guides
    except ModuleNotFoundError:
        raise InputError("the scenes are not installed with this package") from None
    _copy_whole(Path(guides.__file__).with_name("bundled"), folder, place)
    print(_command(folder, guides.LIGHT_PASSES))


def _command(folder, guides):
    """A command that stylizes one of the scenes, guided as in Fišer et al. 2016."""
    source, target = folder / "source", folder / "teapot"
    words = ["stylit-ref", "run", "--style", source / "styles" / "oil.png"]
    for guide in guides:
        words += ["--guide", source / f"{guide}.png", target / f"{guide}.png"]
    return shlex.join(map(str, [*words, "--output", folder / "stylized.png"]))


def _copy_whole(bundled, folder, place):
    """Copy to where ``folder`` leads: it appears whole or not at all, with those it is in."""
    try:
        first = [part for part in (place, *place.parents) if not part.exists()][-1]
        with TemporaryDirectory(prefix=".", dir=first.parent) as partial:
            _copy(bundled, Path(partial) / place.relative_to(first.parent))
            (Path(partial) / first.name).rename(first)
    except OSError as error:
        raise InputError(f"{folder}: cannot be written: {error.strerror}") from None


def _copy(folder, copy):
    """Copy all files; unlike shutil's copy, it ends at the first that fails."""
    for file in filter(Path.is_file, folder.rglob("*")):
        place = copy / file.relative_to(folder)
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, place)
