"""Small scenes for the studio, a painting, and ears for what its engine tells."""

from queue import Queue

import numpy as np

from stylit_ref.realtime.packing.stage import STAGE_BUFFERS
from stylit_ref.studio.engine.events import Picture
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


def make_scene(steps=1, **changes):
    """A stage in memory; ``changes`` replace buffers of the target."""
    source = make_buffers(SIZE, 0)
    targets = [
        lambda step=step: make_buffers(TARGET_SIZE, 0.5 + step) | changes for step in range(steps)
    ]
    return Scene("small", "A small stage", source, targets)


def make_painting(seed=0):
    return np.random.default_rng(seed).integers(0, 256, (*SIZE, 3), np.uint8)


class Ears:
    """What an engine tells, to be waited for; call it with events."""

    def __init__(self):
        self._events = Queue()

    def __call__(self, event):
        self._events.put(event)

    def next(self, kind=object, **facts):
        """The next event of a kind with such attributes; those before it are forgotten."""
        while True:
            event = self._events.get(timeout=60)
            if isinstance(event, kind) and facts.items() <= vars(event).items():
                return event

    def picture(self, which):
        """The next picture of a kind."""
        return self.next(Picture, which=which)

    def all(self):
        """What was told since, without waiting."""
        return [self._events.get() for _ in range(self._events.qsize())]
