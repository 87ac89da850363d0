"""The bundled scenes, copied to where they can be played with."""

import shlex
import shutil
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory

from stylit_ref.errors import InputError
from stylit_ref.output_file import check_folder

GUIDES = "FULL", "LDE", "LSE", "LDDE", "LD12E"
"""Light passes that guide the example, as in Fišer et al. 2016."""


def write_example(folder):
    """Copy the bundled scenes into a new folder.

    Parameters
    ----------
    folder : str or Path
        Appears whole or not at all.

    Returns
    -------
    str
        A command that stylizes one of them.

    Raises
    ------
    InputError
        If the folder is there already or cannot be made, or the scenes are not installed.
    """
    folder = Path(folder)
    if folder.exists():
        raise InputError(f"{folder}: exists; name a new folder")
    check_folder(folder)
    try:
        bundled = Path(import_module("data_gen").__file__).with_name("bundled")
        folder.parent.mkdir(parents=True, exist_ok=True)
        with TemporaryDirectory(prefix=".", dir=folder.parent) as partial:
            shutil.copytree(bundled, Path(partial) / folder.name).rename(folder)
    except ModuleNotFoundError:
        raise InputError("the scenes are not installed with this package") from None
    except OSError as error:
        raise InputError(f"{folder}: cannot be written: {error.strerror or error}") from None
    source, target = folder / "source", folder / "teapot"
    words = ["stylit-ref", "run", "--style", source / "styles" / "oil.png"]
    for guide in GUIDES:
        words += ["--guide", source / f"{guide}.png", target / f"{guide}.png"]
    return shlex.join(map(str, [*words, "--output", folder / "stylized.png"]))
