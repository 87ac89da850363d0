"""Scenes: a style, its guides, and a target's guides, in one folder."""

import hashlib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from stylit_ref import InputError, read_uint8

BUNDLED = Path(__file__).parents[1] / "data_gen" / "bundled" / "figure"


@dataclass(frozen=True)
class Scene:
    """Images of a scene, (H, W, n) uint8.

    Attributes
    ----------
    name : str
    folder : Path
    guide_names : tuple of str
    style : array
    source_guides, target_guides : tuple of arrays
        By ``guide_names``.
    step : int
        Every ``step``-th pixel of the files was kept.
    """

    name: str
    folder: Path
    guide_names: tuple[str, ...]
    style: np.ndarray
    source_guides: tuple[np.ndarray, ...]
    target_guides: tuple[np.ndarray, ...]
    step: int

    @property
    def size(self):
        """Width and height of the target as text."""
        height, width = self.target_guides[0].shape[:2]
        return f"{width}x{height}"

    @property
    def digest(self):
        """Identifies the pixels of the scene."""
        digest = hashlib.sha256()
        for image in (self.style, *self.source_guides, *self.target_guides):
            digest.update(repr(image.shape).encode())
            digest.update(np.ascontiguousarray(image))
        return digest.hexdigest()


def load_scene(folder, step=1):
    """Read ``source_style``, ``source_<guide>`` and ``target_<guide>`` images.

    Parameters
    ----------
    folder : str or Path
    step : int
        Keep every ``step``-th pixel on each axis.

    Returns
    -------
    Scene
        Guides in alphabetical order.

    Raises
    ------
    InputError
        If the folder is not such a scene.
    """
    folder = Path(folder)
    if not folder.is_dir():
        raise InputError(f"{folder}: no such folder")
    files = {file.stem: file for file in sorted(folder.iterdir()) if file.is_file()}
    guides = tuple(
        stem.removeprefix("target_")
        for stem in files
        if stem.startswith("target_") and stem.replace("target_", "source_", 1) in files
    )
    if "source_style" not in files or not guides:
        raise InputError(
            f"{folder}: is no scene; it needs source_style and, for each guide, "
            "source_<guide> and target_<guide> images"
        )

    def read(stem):
        return np.ascontiguousarray(read_uint8(files[stem])[::step, ::step])

    return Scene(
        folder.resolve().name,
        folder,
        guides,
        read("source_style"),
        tuple(read(f"source_{guide}") for guide in guides),
        tuple(read(f"target_{guide}") for guide in guides),
        step,
    )
