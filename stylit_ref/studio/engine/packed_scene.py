"""A scene as a session takes it."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.realtime import passes
from stylit_ref.realtime.layout import Layout
from stylit_ref.realtime.packing import Packing, PrincipalPacking, choose_packing, pack
from stylit_ref.realtime.packing.named_buffers import (
    find_unknown_thing,
    named_buffers,
    read_by,
    weights_of_channels,
)
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.refinement import Refinement
from stylit_ref.studio.engine.parameters import Settings
from stylit_ref.studio.engine.scene import Scene


class PackedScene(NamedTuple):
    """A source and a step of its target, packed.

    Attributes
    ----------
    packing : Packing
    source, target : (H, W, channels) uint8
    labels, target_labels : (H, W) uint8
    guide_of : dict of str to int
        The number of the scene's buffer that each of those is of which the packing knows.
    """

    packing: Packing
    source: NDArray[np.uint8]
    target: NDArray[np.uint8]
    labels: NDArray[np.uint8]
    target_labels: NDArray[np.uint8]
    guide_of: dict[str, int]

    def check(self, settings: Settings, scene: Scene) -> None:
        """Refuse settings whose energy does not fit the arithmetic.

        Raises
        ------
        InputError
        """
        layout = Layout(settings.live, len(self.packing.channels), passes)
        weights = self.weights(settings, scene)
        Refinement(layout, (1,) * layout.channels if weights is None else weights)

    def weights(self, settings: Settings, scene: Scene) -> tuple[int, ...] | None:
        """The weight of each channel; None where principal components mix the buffers."""
        if isinstance(self.packing, PrincipalPacking):
            return None
        return weights_of_channels(settings.weights_of(scene.buffers), self.packing, self.guide_of)


def pack_scene(
    scene: Scene, step: int, params: RealtimeParams, packing: Packing | None = None
) -> PackedScene:
    """Pack a scene as ``run --method realtime`` does.

    Parameters
    ----------
    scene : Scene
    step : int
        Of the target.
    params : RealtimeParams
    packing : Packing, optional
        That of another step of the same scene, which saves the time to find it.

    Returns
    -------
    PackedScene

    Raises
    ------
    InputError
        If the packing cannot read such buffers, or the target shows what the source does not.
    """
    source, target = scene.source, scene.target(step)
    buffers = named_buffers(scene.buffers, list(source.values()), list(target.values()))
    if packing is None:
        packing = choose_packing(buffers.source, params.packing)
    packed, labels = pack(packing, read_by(packing, buffers.source))
    target_packed, target_labels = pack(packing, read_by(packing, buffers.target))
    if params.labels:
        thing = find_unknown_thing(labels, target_labels, packing, buffers.target)
        if thing:
            raise InputError(
                f"{scene.title}: its {thing.buffer} has the colour "
                f"{', '.join(map(str, thing.colour))} at x {thing.x}, y {thing.y}, and so a thing "
                "that is not in what you paint on; turn labels off, or paint on a scene that shows "
                "it"
            )
    return PackedScene(packing, packed, target_packed, labels, target_labels, buffers.guide_of)
