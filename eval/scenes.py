"""Read scenes from a folder or a data set: a style, its guides, and the guides of a target."""

import hashlib
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np
import skimage.transform

from data_gen.guides import LIGHT_PASSES
from data_gen.manifest import DataError, Manifest
from stylit_ref import InputError, read_uint8
from stylit_ref.files.guides.read_guides import read_guides

BUNDLED = Path(__file__).parents[1] / "data_gen" / "bundled"
DEFAULT = "golem/crayon"


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
    ids : tuple of 2 arrays, optional
        Object ids of source and target, a colour for each object; they are no guides.
    buffers : dict of str to tuple of 2 arrays
        Passes of source and target that a method may read beside the guides, such as NORMAL.
    """

    name: str
    folder: Path
    guide_names: tuple[str, ...]
    style: np.ndarray
    source_guides: tuple[np.ndarray, ...]
    target_guides: tuple[np.ndarray, ...]
    step: int
    ids: tuple[np.ndarray, np.ndarray] | None = None
    buffers: dict[str, tuple[np.ndarray, np.ndarray]] = field(default_factory=dict)

    @property
    def size(self):
        """Width and height of the target as text."""
        height, width = self.target_guides[0].shape[:2]
        return f"{width}x{height}"

    @property
    def pixels(self):
        """Pixels of the target."""
        height, width = self.target_guides[0].shape[:2]
        return height * width

    @property
    def shown_guide(self):
        """The target guide to show in figures: the full render if there is one."""
        names = self.guide_names
        shown = next((names.index(name) for name in ("FULL", "fullgi") if name in names), 0)
        return self.target_guides[shown]

    def resized(self, size):
        """The same scene, all images enlarged or reduced to (H, W)."""

        def resize(image):
            smooth = image.shape[0] > size[0]
            resized = skimage.transform.resize(
                image, size, anti_aliasing=smooth, preserve_range=True
            )
            return np.round(resized).astype(np.uint8)

        return replace(
            self,
            style=resize(self.style),
            source_guides=tuple(map(resize, self.source_guides)),
            target_guides=tuple(map(resize, self.target_guides)),
        )

    @cached_property
    def digest(self):
        """Identifies the images that methods see."""
        buffers = (image for name in sorted(self.buffers) for image in self.buffers[name])
        return _digest((self.style, *self.source_guides, *self.target_guides, *buffers))

    @cached_property
    def digest_of_ids(self):
        """Identifies the object ids, which only metrics see."""
        return _digest(self.ids or ())


def _digest(images):
    digest = hashlib.sha256()
    for image in images:
        digest.update(repr(image.shape).encode())
        digest.update(np.ascontiguousarray(image))
    return digest.hexdigest()


def load_scene(name, data=BUNDLED, step=1, buffers=()):
    """Read a scene.

    Parameters
    ----------
    name : str or Path
        ``TARGET/STYLE`` of a data set, with its light passes as guides; or a folder with
        ``source_style``, ``source_<guide>`` and ``target_<guide>`` images, whose guides
        come in alphabetical order.
    data : str or Path
        Folder of the data set.
    step : int
        Keep every ``step``-th pixel on each axis.
    buffers : sequence of str
        Passes of the data set to read beside the guides.

    Returns
    -------
    Scene

    Raises
    ------
    InputError
        If there is no such scene, or a file differs from its manifest.
    """
    if step < 1:
        raise InputError(f"--step is {step}; it must be 1 or more")
    folder = Path(name)
    if folder.is_dir():
        if buffers:
            raise InputError(
                f"{folder}: has guides alone; name a TARGET/STYLE of a data set, which has "
                f"{', '.join(buffers)}"
            )
        return _from_folder(folder, step)
    try:
        return _from_data_set(str(name), Manifest.read(data), step, buffers)
    except DataError as error:
        raise InputError(str(error)) from None


def _from_data_set(name, manifest, step, buffers):
    targets, styles = manifest.targets, manifest.styles
    target, _, style = name.rpartition("/")
    if target not in targets or style not in styles:
        raise InputError(
            f"{name}: is neither a folder nor TARGET/STYLE of {manifest.folder}; targets there: "
            f"{', '.join(targets)}; styles: {', '.join(styles)}"
        )
    sources, guides = (
        tuple(_read(manifest.path(f"{place}/{guide}.png"), step) for guide in LIGHT_PASSES)
        for place in ("source", target)
    )
    style_image = _read(manifest.path(f"source/styles/{style}.png"), step)
    name = f"{target.replace('/', '_')}_{style}"
    passes = {
        wanted: tuple(
            _read(manifest.path(f"{place}/{wanted}.png"), step) for place in ("source", target)
        )
        for wanted in dict.fromkeys(("IDMASK", *buffers))
    }
    return Scene(
        name, manifest.folder, LIGHT_PASSES, style_image, sources, guides, step,
        ids=passes["IDMASK"], buffers={wanted: passes[wanted] for wanted in buffers},
    )  # fmt: skip


def _from_folder(folder, step):
    files = {file.stem: file for file in sorted(folder.iterdir()) if file.is_file()}
    sources, targets = (
        {stem.removeprefix(side) for stem in files if stem.startswith(side)} - {"style"}
        for side in ("source_", "target_")
    )
    if "source_style" not in files or not sources | targets:
        raise InputError(
            f"{folder}: is not a scene; it needs source_style and, for each guide, "
            "source_<guide> and target_<guide> images"
        )
    for alone in sorted(sources ^ targets):
        missing = f"target_{alone}" if alone in sources else f"source_{alone}"
        raise InputError(f"{folder}: the guide '{alone}' lacks its {missing} image")
    guides = tuple(sorted(sources))

    read = read_guides([(files[f"source_{name}"], files[f"target_{name}"]) for name in guides])
    return Scene(
        folder.resolve().name,
        folder,
        guides,
        _every(step, read_uint8(files["source_style"])),
        tuple(_every(step, source) for source in read.source),
        tuple(_every(step, target) for target in read.targets[0]),
        step,
    )


def _read(path, step):
    return _every(step, read_uint8(path))


def _every(step, image):
    return np.ascontiguousarray(image[::step, ::step])
