"""Small scenes of the stage, and of other buffers, and a painting."""

import numpy as np

from stylit_ref.realtime.packing.stage import STAGE_BUFFERS
from stylit_ref.studio.engine.scene import Scene

SIZE, TARGET_SIZE = (40, 36), (37, 41)


def make_buffers(size, phase):
    """The stage's buffers: a red thing in front of a white ground."""
    y, x = np.mgrid[: size[0], : size[1]]
    is_thing = np.hypot(y - size[0] / 2, x - size[1] / 2) < size[0] / 3
    shade = 0.5 + 0.5 * np.sin((x + 2 * y) / 9 + phase)
    buffers = {}
    for number, name in enumerate(STAGE_BUFFERS):
        light = 40 + 200 * shade ** (1 + number / 3)
        image = np.repeat(light[..., None], 3, axis=2)
        if name != "LSE":
            image[..., 1:][is_thing] *= 0.3
        buffers[name] = image.astype(np.uint8)
    buffers["IDMASK"][:] = np.where(is_thing[..., None], (255, 0, 0), (0, 255, 0))
    is_dark = (shade < 0.2)[..., None]
    buffers["LIGHTMASK"][:] = np.where(is_dark, (0, 0, 255), (0, 255, 0))
    buffers["FRESNEL"] = buffers["FRESNEL"][..., :1]
    return buffers


def make_scene(steps=1, title="A small stage"):
    source = make_buffers(SIZE, 0)
    targets = [lambda step=step: make_buffers(TARGET_SIZE, 0.5 + step) for step in range(steps)]
    return Scene("small", title, source, targets)


def make_painting(seed=0):
    return np.random.default_rng(seed).integers(0, 256, (*SIZE, 3), np.uint8)
