"""A studio of a few pixels, whose engine only takes down what it is asked."""

import numpy as np

from stylit_ref import write_image
from stylit_ref.studio.engine.events import Picture
from stylit_ref.studio.painting.folder import PaintingFolder
from stylit_ref.studio.scene_files.offer import offer_of_files
from stylit_ref.studio.scene_files.shelf import Shelf
from stylit_ref.studio.server.beginning import begin

SIZE = HEIGHT, WIDTH = 24, 32
TARGET_SIZE = 20, 28
LAYERS = "FULL", "LDE", "IDMASK"


def write_passes(folder, size, layers=LAYERS, seed=0):
    """Render passes of noise."""
    rng = np.random.default_rng(seed)
    for layer in layers:
        write_image(folder / f"{layer}.png", rng.integers(0, 256, (*size, 3), np.uint8))
    return folder


def small_shelf(folder):
    """Two scenes, ``one`` and ``two``, whose files are written if they are not there."""
    for seed, (name, size) in enumerate(
        (("source", SIZE), ("one", TARGET_SIZE), ("two", TARGET_SIZE))
    ):
        if not (folder / name).exists():
            write_passes(folder / name, size, seed=seed)
    return Shelf(
        [offer_of_files(name, folder / "source", folder / name) for name in ("one", "two")]
    )


def small_beginning(folder, **more):
    """What a studio begins with, in ``folder / "painting"``; ``more`` goes to ``begin``."""
    return begin(small_shelf(folder), PaintingFolder(folder / "painting"), **more)


class NotedEngine:
    """Stands in for :class:`stylit_ref.studio.engine.live.Live`.

    Attributes
    ----------
    calls : list of tuple
        The name of each method that was called, and what it was given.
    """

    def __init__(self, scene, painting, tell, seed):
        self.calls, self.painting, self.tell = [("begin", scene.name, seed)], painting, tell

    def paint(self, x, y, pixels, serial):
        self.calls.append(("paint", x, y, pixels.shape[:2], serial))
        height, width = pixels.shape[:2]
        self.painting[y : y + height, x : x + width] = pixels
        self.show("replay", serial)

    def show(self, which, serial):
        """Tell a picture, which is the painting itself."""
        self.tell(Picture(which, self.painting.copy(), serial, 1.5))

    def replace_painting(self, painting, serial):
        self.calls.append(("replace_painting", serial))
        self.painting = painting.copy()

    def choose_scene(self, scene, painting=None, serial=0):
        self.calls.append(("choose_scene", scene))
        self.painting = self.painting if painting is None else painting

    def turn(self, step, *, warm, restylize=True):
        self.calls.append(("turn", step, warm, restylize))

    def __getattr__(self, name):
        return lambda *arguments: self.calls.append((name, *arguments))
