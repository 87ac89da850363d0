"""A scene that can be opened, of which only the headers of its files have been read."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.realtime.packing.principal import ID
from stylit_ref.realtime.packing.stage import STAGE_BUFFERS
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.engine.scene_reading import read_scene
from stylit_ref.studio.painting.paint_file import read_paint
from stylit_ref.studio.scene_files.layers_in import FoundLayer, layers_in

_HARDLY_GUIDES = (
    "DEPTH", "Z", "MIST", "NORMAL", "NORMALS", "POSITION", "WIREFRAME", "UV", "VECTOR", "ALPHA",
)  # fmt: skip
"""Names, or ends of names, of what is not picked unless somebody picks it."""


@dataclass(frozen=True)
class Offer:
    """What a scene is made of.

    Attributes
    ----------
    name : str
        For programs; unique.
    title : str
        For people.
    source : mapping of str to FoundLayer
    targets : sequence of mapping of str to FoundLayer
        Of every step of a turntable, or of the one step.

    Raises
    ------
    InputError
        If they have no layer in common.
    """

    name: str
    title: str
    source: Mapping[str, FoundLayer]
    targets: Sequence[Mapping[str, FoundLayer]]

    def __post_init__(self) -> None:
        if not self.layers:
            theirs = ", ".join(self.targets[0])
            raise InputError(
                f"{self.title}: has no layer that its source has, too; there they are called "
                f"{', '.join(self.source)}, here {theirs}; name files alike, such as "
                "sphere/FULL.png and robot/FULL.png"
            )

    @property
    def layers(self) -> tuple[str, ...]:
        """Those of the source that every step has."""
        return tuple(name for name in self.source if all(name in step for step in self.targets))

    @property
    def usual(self) -> tuple[str, ...]:
        """Those that are picked if nobody picks: the thesis' seven, or pictures and labels."""
        if set(STAGE_BUFFERS) <= set(self.layers):
            return STAGE_BUFFERS
        picked = [name for name in self.layers if self._guides(name)]
        return tuple(picked) or self.layers

    @property
    def size(self) -> tuple[int, int]:
        """Height and width of the painting."""
        return self.source[self.layers[0]].size

    @property
    def target_size(self) -> tuple[int, int]:
        """Height and width of the target."""
        return self.targets[0][self.layers[0]].size

    def read(self, picked: Sequence[str] = ()) -> Scene:
        """Read the source; steps of the target are read when they are looked at.

        Parameters
        ----------
        picked : sequence of str
            Some of ``layers``; the usual ones by default.

        Raises
        ------
        InputError
            If one is none of the layers, or a file cannot be read.
        """
        chosen = {self.layer_of(name) for name in picked} or self.usual
        names = [name for name in self.layers if name in chosen]
        sides = self.source, *self.targets
        guides = [[side[name].path for side in sides] for name in names]
        return read_scene(self.name, self.title, guides, self.layers)

    def rendering(self) -> NDArray[np.uint8]:
        """The picture of the source that is painted over, (H, W, 3) uint8.

        Raises
        ------
        InputError
            If it cannot be read.
        """
        pictures = [name for name in self.layers if self.source[name].is_picture]
        name = "FULL" if "FULL" in pictures else (*pictures, *self.layers)[0]
        return read_paint(self.source[name].path, self.size)

    def things(self) -> NDArray[np.uint8]:
        """A colour for each thing of the source, (H, W, 3) uint8; black if nothing tells.

        Raises
        ------
        InputError
            If they cannot be read.
        """
        for name in self.layers:
            if name == ID or self.source[name].tells_things_apart:
                ids = next(iter(self.read([name]).source.values()))[:, :, :3]
                return np.ascontiguousarray(np.broadcast_to(ids, (*self.size, 3)))
        return np.zeros((*self.size, 3), np.uint8)

    def layer_of(self, buffer: str) -> str:
        """The layer that a buffer is of: labels become IDMASK, whatever they were called.

        Raises
        ------
        InputError
            If there is none.
        """
        if buffer in self.layers:
            return buffer
        labels = [name for name in self.layers if self.source[name].tells_things_apart]
        if buffer == ID and labels:
            return labels[0]
        raise InputError(f"{self.title}: has no layer {buffer[:40]!r}")

    def _guides(self, name: str) -> bool:
        layer = self.source[name]
        last = name.replace("_", ".").rpartition(".")[2]
        return layer.tells_things_apart or (layer.is_picture and last not in _HARDLY_GUIDES)


def offer_of_files(name: str, source: str | Path, target: str | Path) -> Offer:
    """A scene of two folders, or of two files.

    Parameters
    ----------
    name : str
    source, target : str or Path

    Raises
    ------
    InputError
        As :func:`layers_in`, or if they have no layer in common.
    """
    return Offer(name, str(target), layers_in(source), [layers_in(target)])
