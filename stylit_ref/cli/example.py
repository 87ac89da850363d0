"""The bundled scenes, copied to where they can be played with."""

import shlex
import shutil
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory

from stylit_ref.errors import InputError
from stylit_ref.files.output_file import real_path

GUIDES = "FULL", "LDE", "LSE", "LDDE", "LD12E"
"""Light passes that guide the example, as in Fišer et al. 2016."""


def write_example(folder):
    """Copy the bundled scenes into a new folder.

    Parameters
    ----------
    folder : str or Path
        Appears whole or not at all, and so do missing folders that it is in.

    Returns
    -------
    str
        A command that stylizes one of them.

    Raises
    ------
    InputError
        If the folder is there already or cannot be made, or the scenes are not installed.
    """
    folder, place = Path(folder), real_path(folder)
    if place.exists():
        raise InputError(f"{folder}: exists; name a new folder")
    try:
        bundled = Path(import_module("data_gen").__file__).with_name("bundled")
        first = [part for part in (place, *place.parents) if not part.exists()][-1]
        with TemporaryDirectory(prefix=".", dir=first.parent) as partial:
            _copy(bundled, Path(partial) / place.relative_to(first.parent))
            (Path(partial) / first.name).rename(first)
    except ModuleNotFoundError:
        raise InputError("the scenes are not installed with this package") from None
    except OSError as error:
        raise InputError(f"{folder}: cannot be written: {error.strerror}") from None
    source, target = folder / "source", folder / "teapot"
    words = ["stylit-ref", "run", "--style", source / "styles" / "oil.png"]
    for guide in GUIDES:
        words += ["--guide", source / f"{guide}.png", target / f"{guide}.png"]
    return shlex.join(map(str, [*words, "--output", folder / "stylized.png"]))


def _copy(folder, copy):
    """Copy all files; unlike shutil's copy, it ends at the first that fails."""
    for file in filter(Path.is_file, folder.rglob("*")):
        place = copy / file.relative_to(folder)
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, place)
