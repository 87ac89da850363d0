"""Scenes whose stylized target is known: the program that paints a style paints the target too."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from data_gen.guides import LIGHT_PASSES, guide, to_uint8
from data_gen.manifest import DataError, Manifest
from data_gen.multilayer_exr import read_layers
from data_gen.styles import STYLES, subject
from eval.scenes import Scene
from stylit_ref import InputError

GROUND, WALL = 1, 2
"""Channels of IDMASK on the stage."""


class Truth(NamedTuple):
    """A scene, and the picture that a painter of its style makes of the target.

    Attributes
    ----------
    scene : Scene
    picture : (H, W, 3) uint8
    """

    scene: Scene
    picture: np.ndarray


def load_truth(name, data, alike=False, guided=False):
    """Read a scene of a data set and paint its target.

    Parameters
    ----------
    name : str
        ``TARGET/STYLE``; the target stands on the stage of the sphere.
    data : str or Path
        Folder of a data set that holds layers (``passes.exr``).
    alike : bool
        The wall reflects more, so that it is as bright as the ground where both are lit. Painters
        look at the light of each thing alone, so that this changes guides, but no picture.
    guided : bool
        IDMASK is a guide too.

    Returns
    -------
    Truth

    Raises
    ------
    InputError
        If the data set holds no such scene, or no layers.
    """
    target, _, style = name.rpartition("/")
    try:
        manifest = Manifest.read(data)
        if target not in manifest.targets or style not in manifest.styles:
            raise InputError(
                f"{name}: is no TARGET/STYLE of {manifest.folder}; targets there: "
                f"{', '.join(manifest.targets)}; styles: {', '.join(manifest.styles)}"
            )
        files = [manifest.path(f"{place}/passes.exr") for place in ("source", target)]
    except DataError as error:
        raise InputError(str(error)) from None
    source, seen = map(_layers, files)
    gain = _median(source, GROUND) / _median(source, WALL) if alike else 1.0
    names = (*LIGHT_PASSES, "IDMASK") if guided else LIGHT_PASSES
    scene = Scene(
        "_".join([target, style, *["alike"] * alike, *["ids"] * guided]),
        manifest.folder,
        names,
        _painted(files[0], style),
        *(
            tuple(guide(name, _lit(layers, name, gain)) for name in names)
            for layers in (source, seen)
        ),
        step=1,
        ids=(guide("IDMASK", source["IDMASK"]), guide("IDMASK", seen["IDMASK"])),
    )
    return Truth(scene, _painted(files[1], style))


def _median(layers, region):
    """Median of the light on a region."""
    return np.median(layers["FULL"][layers["IDMASK"][..., region] > 0])


def _lit(layers, name, gain):
    """A layer under a wall that reflects more."""
    layer = layers[name]
    if name not in LIGHT_PASSES:
        return layer
    return np.where(layers["IDMASK"][..., WALL, None] > 0, gain * layer, layer)


@lru_cache(maxsize=2)
def _layers(file):
    return read_layers(file)


@lru_cache(maxsize=8)
def _painted(file, style):
    return to_uint8(STYLES[style](subject(_layers(file))))
