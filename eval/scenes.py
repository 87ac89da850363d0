"""Scenes: a style, its guides, and a target's guides, in one folder."""

import hashlib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from stylit_ref import InputError, read_uint8
from stylit_ref.image_io import read_guides

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
    def shown_guide(self):
        """The target guide to show: the full render where there is one."""
        names = self.guide_names
        return self.target_guides[names.index("fullgi") if "fullgi" in names else 0]

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
    if step < 1:
        raise InputError(f"step is {step}; it must be 1 or more")
    folder = Path(folder)
    if not folder.is_dir():
        raise InputError(f"{folder}: no such folder")
    files = {file.stem: file for file in sorted(folder.iterdir()) if file.is_file()}
    sources, targets = (
        {stem.removeprefix(side) for stem in files if stem.startswith(side)} - {"style"}
        for side in ("source_", "target_")
    )
    if "source_style" not in files or not sources | targets:
        raise InputError(
            f"{folder}: is no scene; it needs source_style and, for each guide, "
            "source_<guide> and target_<guide> images"
        )
    for alone in sorted(sources ^ targets):
        missing = f"target_{alone}" if alone in sources else f"source_{alone}"
        raise InputError(f"{folder}: the guide '{alone}' lacks its {missing} image")
    guides = tuple(sorted(sources))

    def reduced(image):
        return np.ascontiguousarray(image[::step, ::step])

    pairs = [read_guides(files[f"source_{name}"], files[f"target_{name}"]) for name in guides]
    return Scene(
        folder.resolve().name,
        folder,
        guides,
        reduced(read_uint8(files["source_style"])),
        tuple(reduced(source) for source, _ in pairs),
        tuple(reduced(target) for _, target in pairs),
        step,
    )
