"""The thesis' stage: a red object on white ground, and a painted sphere under the same light."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from data_gen.manifest import DataError, Manifest
from data_gen.produce import produce
from data_gen.renderer import MissingRendererError
from eval.methods.normal_table import BUFFERS as OF_RIVALS
from eval.scenes import BUNDLED, load_scene
from stylit_ref import InputError
from stylit_ref.realtime.packing.stage import STAGE_BUFFERS

STYLES = "crayon", "oil", "watercolour", "pen"

GUIDES = "FULL", "LDE", "LSE", "LDDE"
"""What the dense methods are guided by, and what energy compares: the light of the thesis' LPE+."""

RENDERED = Path("build/data")
TARGET = "golem"


def bundled(style):
    """The bundled scene in a style."""
    return of_stage(TARGET, style, BUNDLED)


def rendered(style, side, name=TARGET):
    """A scene at ``side`` x ``side`` pixels; it is rendered if it is not there.

    Raises
    ------
    InputError
        If it is not there and cannot be rendered.
    """
    folder = RENDERED / f"{side}x{side}"
    if not is_rendered(side, name):
        try:
            produce(folder, (side, side), (name,), exr=False)
        except (DataError, MissingRendererError) as error:
            raise InputError(str(error)) from None
    return of_stage(name, style, folder)


def is_rendered(side, name=TARGET):
    """Whether the data set of a size has a target."""
    try:
        return name in Manifest.read(RENDERED / f"{side}x{side}").targets
    except DataError:
        return False


def for_times(side):
    """A scene of ``side`` x ``side`` pixels to take the time on.

    The rendered one if it is there, else the bundled one enlarged: its pictures show nothing new,
    but a frame of it has as many pixels, entries and candidates.
    """
    if is_rendered(side):
        return of_stage(TARGET, "oil", RENDERED / f"{side}x{side}")
    return enlarged(bundled("oil"), side)


def enlarged(scene, side):
    """A scene whose pixels are repeated until it has ``side`` x ``side`` of them."""

    def wide(image):
        y, x = (np.arange(side) * length // side for length in image.shape[:2])
        return np.ascontiguousarray(image[y[:, None], x])

    return replace(
        scene,
        name=f"{scene.name}_enlarged",
        style=wide(scene.style),
        source_guides=tuple(map(wide, scene.source_guides)),
        target_guides=tuple(map(wide, scene.target_guides)),
        ids=tuple(map(wide, scene.ids)),
        buffers={name: tuple(map(wide, pair)) for name, pair in scene.buffers.items()},
    )


def of_stage(target, style, data):
    """A target of a data set in a style, with all buffers."""
    names = tuple(dict.fromkeys((*STAGE_BUFFERS, *OF_RIVALS)))
    scene = load_scene(f"{target}/{style}", data, buffers=names)
    pairs = [scene.buffers[name] for name in GUIDES]
    sources, targets = zip(*pairs, strict=True)
    return replace(scene, guide_names=GUIDES, source_guides=sources, target_guides=targets)
