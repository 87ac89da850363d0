"""What a folder of rendered data holds, how it was made, and whether it is still that."""

import hashlib
import json
import os
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

NAME = "manifest.json"
_MADE_WITH = ("mitsuba", "drjit", "mitsuba-oidn", "numpy", "scipy", "scikit-image", "matplotlib")


class DataError(Exception):
    """A folder does not hold what its manifest says; the message names file and reason."""


def recipe(size, samples, seed):
    """All that decides the bytes of a data set: settings, versions, code."""
    code = hashlib.sha256()
    root = Path(__file__).parent
    for file in sorted(root.rglob("*.py")):
        code.update(file.relative_to(root).as_posix().encode())
        code.update(file.read_bytes())
    return {
        "size": f"{size[0]}x{size[1]}",
        "samples": samples,
        "seed": seed,
        "versions": {name: _version(name) for name in _MADE_WITH},
        "code": code.hexdigest()[:16],
    }


class Manifest:
    """The manifest of a folder: its recipe, and the sha256 of each file by piece.

    Parameters
    ----------
    folder : str or Path

    Raises
    ------
    DataError
        If there is none, or it cannot be read.
    """

    def __init__(self, folder):
        self.folder = Path(folder)
        try:
            content = json.loads((self.folder / NAME).read_text())
            self.recipe, self.pieces = content["recipe"], content["pieces"]
        except FileNotFoundError:
            raise DataError(f"{self.folder}: holds no {NAME}; make it with 'make data'") from None
        except (ValueError, KeyError, TypeError):
            raise DataError(f"{self.folder / NAME}: is no manifest of rendered data") from None

    @classmethod
    def open(cls, folder, new_recipe):
        """The manifest of a folder, without the pieces that another recipe made.

        Raises
        ------
        DataError
            If the folder holds something and no manifest.
        """
        folder = Path(folder)
        if (folder / NAME).exists():
            manifest = cls(folder)
        elif folder.exists() and any(folder.iterdir()):
            raise DataError(f"{folder}: holds files and no {NAME}; choose an empty folder")
        else:
            manifest = cls.__new__(cls)
            manifest.folder, manifest.recipe = folder, None
        if manifest.recipe != new_recipe:
            manifest.recipe, manifest.pieces = new_recipe, {}
        return manifest

    def path(self, file):
        """Path of one of its files, which is still what was written.

        Raises
        ------
        DataError
        """
        expected = {f: d for files in self.pieces.values() for f, d in files.items()}.get(file)
        path = self.folder / file
        if expected is None:
            raise DataError(f"{self.folder}: its {NAME} knows no {file}")
        if not path.is_file():
            raise DataError(f"{path}: is missing, though {NAME} lists it")
        if _digest(path) != expected:
            raise DataError(f"{path}: differs from what {NAME} says; make it anew with 'make data'")
        return path

    @property
    def targets(self):
        """Names of the targets that are there, the house apart."""
        return [piece for piece in self.pieces if piece != "source" and "/" not in piece]

    @property
    def styles(self):
        """Names of the styles that are there."""
        files = map(Path, self.pieces.get("source", ()))
        return [file.stem for file in files if file.parent.name == "styles"]

    def complete(self, piece):
        """Whether all files of a piece are there, unchanged."""
        try:
            return bool([self.path(file) for file in self.pieces[piece]])
        except (KeyError, DataError):
            return False

    def add(self, piece):
        """Note the files of a finished piece and save."""
        files = sorted(file for file in (self.folder / piece).rglob("*") if file.is_file())
        self.pieces[piece] = {
            file.relative_to(self.folder).as_posix(): _digest(file) for file in files
        }
        self.save()

    def save(self):
        """Write it, whole or not at all; makes the folder."""
        self.folder.mkdir(parents=True, exist_ok=True)
        content = {"recipe": self.recipe, "pieces": dict(sorted(self.pieces.items()))}
        partial = self.folder / (NAME + ".partial")
        partial.write_text(json.dumps(content, indent=1) + "\n")
        os.replace(partial, self.folder / NAME)


def _version(name):
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def _digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()
