"""The manifest of a data set: its files with their digests, and the recipe that made them."""

import hashlib
import json
import os
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

NAME = "manifest.json"
GUIDE_OF_EVERY_VIEW = "FULL.png"
_PARTIAL = NAME + ".partial"
_MADE_WITH = (
    "mitsuba", "drjit", "mitsuba-oidn", "numpy", "scipy", "scikit-image", "matplotlib",
    "OpenImageIO", "imageio", "pillow",
)  # fmt: skip
_MAKES_NO_BYTES = (
    "__main__.py", "manifest.py", "produce.py", "renderer.py", "turntable/__init__.py",
    "turntable/__main__.py",
)  # fmt: skip


class DataError(Exception):
    """A folder of data cannot be used; the message names the file and the reason."""


def recipe(size, samples, seed, exr):
    """Everything that decides the bytes of a data set: settings, versions of libraries, code.

    Returns
    -------
    dict
    """
    root = Path(__file__).parent
    code = hashlib.sha256()
    for file in sorted(set(root.rglob("*.py")) - {root / name for name in _MAKES_NO_BYTES}):
        code.update(file.relative_to(root).as_posix().encode() + file.read_bytes())
    return {
        "size": f"{size[0]}x{size[1]}",
        "samples": samples,
        "seed": seed,
        "exr": exr,
        "versions": {name: _version(name) for name in _MADE_WITH},
        "code": code.hexdigest()[:16],
    }


@dataclass
class Manifest:
    """The recipe and the files of a data set.

    Attributes
    ----------
    folder : Path
    recipe : dict
    pieces : dict of str to dict of str to str
        The SHA-256 of every file, by piece.
    """

    folder: Path
    recipe: dict
    pieces: dict

    @classmethod
    def read(cls, folder):
        """Read the manifest of a folder.

        Raises
        ------
        DataError
            If the manifest is missing or cannot be read.
        """
        folder = Path(folder)
        try:
            content = json.loads((folder / NAME).read_text())
            return cls(folder, dict(content["recipe"]), _pieces(content["pieces"]))
        except FileNotFoundError:
            raise DataError(f"{folder}: holds no {NAME}; render it with 'make data'") from None
        except (ValueError, KeyError, TypeError, AttributeError):
            raise DataError(
                f"{folder / NAME}: is not a manifest of rendered data; remove the folder and "
                "render again"
            ) from None

    @classmethod
    def open(cls, folder):
        """The manifest of a folder that data is to be made in: the existing one, or an empty one.

        Raises
        ------
        DataError
            If the folder holds files but no manifest. The partial file of a killed :meth:`save` is
            allowed.
        """
        folder = Path(folder)
        if (folder / NAME).exists():
            return cls.read(folder)
        if folder.exists() and any(file.name != _PARTIAL for file in folder.iterdir()):
            raise DataError(f"{folder}: holds files but no {NAME}; choose an empty folder")
        return cls(folder, {}, {})

    @property
    def targets(self):
        """Names of the finished views, without those that styles are painted over."""
        return [
            piece
            for piece, files in self.pieces.items()
            if f"{piece}/{GUIDE_OF_EVERY_VIEW}" in files and not _styles(files)
        ]

    @property
    def styles(self):
        """Names of the finished styles."""
        return [style for files in self.pieces.values() for style in _styles(files)]

    def path(self, file):
        """Path of one of its files; the file must be unchanged.

        Raises
        ------
        DataError
        """
        expected = {f: d for files in self.pieces.values() for f, d in files.items()}.get(file)
        path = self.folder / file
        if expected is None:
            raise DataError(f"{self.folder}: its {NAME} does not list {file}")
        if not path.is_file():
            raise DataError(f"{path}: is missing; render it again with 'make data'")
        if _digest(path) != expected:
            raise DataError(f"{path}: differs from {NAME}; render it again with 'make data'")
        return path

    def complete(self, piece):
        """Whether all files of a piece exist and are unchanged."""
        try:
            return bool([self.path(file) for file in self.pieces[piece]])
        except (KeyError, DataError):
            return False

    def restart(self, new_recipe):
        """Take a new recipe; if it differs from the old one, all files are removed."""
        if self.recipe != new_recipe:
            for file in [file for files in self.pieces.values() for file in files]:
                (self.folder / file).unlink(missing_ok=True)
            self.recipe, self.pieces = new_recipe, {}
        self.save()

    def add(self, piece):
        """Add the files of a finished piece and save."""
        files = sorted(file for file in (self.folder / piece).rglob("*") if file.is_file())
        self.pieces[piece] = {
            file.relative_to(self.folder).as_posix(): _digest(file) for file in files
        }
        self.save()

    def save(self):
        """Write the manifest; makes the folder. A failure leaves the old manifest."""
        self.folder.mkdir(parents=True, exist_ok=True)
        content = {"recipe": self.recipe, "pieces": dict(sorted(self.pieces.items()))}
        partial = self.folder / _PARTIAL
        try:
            partial.write_text(json.dumps(content, indent=1) + "\n")
            os.replace(partial, self.folder / NAME)
        finally:
            partial.unlink(missing_ok=True)


def _styles(files):
    """Names of the styles among the files of a piece."""
    return [Path(file).stem for file in files if Path(file).parent.name == "styles"]


def _pieces(content):
    """Check that all listed files lie inside the folder, since they may be removed."""
    for files in content.values():
        for file, digest in files.items():
            if Path(file).is_absolute() or ".." in Path(file).parts or not isinstance(digest, str):
                raise ValueError(file)
    return content


def _version(name):
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def _digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()
