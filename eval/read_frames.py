"""Read frames and their motion from a data set."""

import re
from pathlib import Path

import numpy as np

from data_gen.guides import CHAPEL_LIMITS, HOUSE_LIMITS, STAGE_LIMITS
from data_gen.manifest import DataError, Manifest
from data_gen.multilayer_exr import read_layers
from eval.frame_sets import FrameSet
from stylit_ref import InputError, read_uint8
from stylit_ref.views.frames import Motion

GUIDES = ("FULL", "LDE", "LDDE", "LSE", "LIGHTMASK", "WIREFRAME")
"""The thesis' six (2.4.1): beauty, direct, indirect and reflected light, shadows, wireframe."""

_NO_VIEWS = "motion", "mesh", "source"
"""What else a scene of several views has."""

_LIMITS = {"house": HOUSE_LIMITS, "chapel": CHAPEL_LIMITS}


def read_frames(scene, style, data, guides=GUIDES, frames=None):
    """Read a scene of several views.

    Parameters
    ----------
    scene : str
        Name of the scene: its views are ``SCENE/NAME``, motion is ``SCENE/motion/A_to_B.exr``. What
        was painted over is ``sketched_SCENE``; without it, ``source``.
    style : str
        Name of a style painted over that view.
    data : str or Path
        Folder of the data set.
    guides : sequence of str
        Passes that guide.
    frames : int, optional
        How many to read, the first ones; all by default.

    Returns
    -------
    FrameSet

    Raises
    ------
    InputError
        If the data set lacks something, or a file differs from its manifest.
    """
    try:
        return _read(scene, style, Manifest.read(data), guides, frames)
    except DataError as error:
        raise InputError(str(error)) from None


def _read(scene, style, manifest, guides, count):
    building = f"sketched_{scene.partition('_')[0]}"
    source = building if building in manifest.pieces else "source"
    views = [
        view
        for view in manifest.pieces
        if view.startswith(f"{scene}/") and view.rpartition("/")[2] not in _NO_VIEWS
    ][:count]
    if not views:
        raise InputError(f"{manifest.folder}: holds no views of {scene}; render it with make data")
    painted = {Path(file).stem: file for file in manifest.pieces[source] if _is_painted(file)}
    if style not in painted:
        raise InputError(
            f"{manifest.folder}: holds no style {style} over {source}; there are "
            f"{', '.join(painted) or 'none'}"
        )

    def images(view, names):
        return tuple(read_uint8(manifest.path(f"{view}/{name}.png")) for name in names)

    return FrameSet(
        name=f"{scene}_{style}",
        style=read_uint8(manifest.path(painted[style])),
        source_guides=images(source, guides),
        guides=tuple(images(view, guides) for view in views),
        edges=_edges(manifest, scene, [view.rpartition("/")[2] for view in views]),
        renderings=np.stack([images(view, ["FULL"])[0] for view in views]),
        depths=np.stack([_depth(images(view, ["DEPTH"])[0], scene) for view in views]),
        ids=np.stack([images(view, ["IDMASK"])[0] for view in views]),
    )


def _depth(image, scene):
    """Depth in the units of the stage, 0 where nothing is, or something beyond its limits."""
    limits = _LIMITS.get(scene.partition("_")[0], STAGE_LIMITS)
    nearness = image[..., 0].astype(np.float32) / 255
    depth = limits.far - nearness * np.float32(limits.far - limits.near)
    return np.where(nearness > 0, depth, np.float32(0))


def _is_painted(file):
    return Path(file).parent.name in ("styles", "sketches")


def _edges(manifest, scene, names):
    """The motion between frames that were read; that of a frame into another is ``A_to_B``."""
    numbers = {name: number for number, name in enumerate(names)}
    edges = {}
    for file in manifest.pieces.get(f"{scene}/motion", ()):
        to, other = re.fullmatch(r"(.+)_to_(.+)", Path(file).stem).groups()
        if to in numbers and other in numbers:
            layers = read_layers(manifest.path(file))
            edges[numbers[to], numbers[other]] = Motion(
                layers["MOTION"].astype(np.float32), layers["VISIBLE"][..., 0] > 0.5
            )
    return edges
