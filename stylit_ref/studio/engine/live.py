"""The picture that follows: one thread that computes, and a process in the background."""

from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.studio.engine.events import Event
from stylit_ref.studio.engine.scene import Scene


class Live:
    """A painting and the picture that follows it.

    All methods may be called from any thread and return at once; what comes of them is told as
    events, from threads of the engine.

    Parameters
    ----------
    scene : Scene
    painting : (H_A, W_A, 3) uint8
        Of the size of the scene's source.
    tell : callable
        Called with every event.
    threads : int, optional
    seed : int
    """

    def __init__(
        self,
        scene: Scene,
        painting: NDArray[np.uint8],
        *,
        tell: Callable[[Event], None],
        threads: int | None = None,
        seed: int = 0,
    ) -> None: ...

    def paint(self, x: int, y: int, pixels: NDArray[np.uint8], serial: int) -> None:
        """Change a rectangle of the painting; a replay follows."""

    def rest(self, serial: int) -> None:
        """The brush pauses: a coherent frame follows, then ``fast`` in the background."""

    def replace_painting(self, painting: NDArray[np.uint8], serial: int) -> None:
        """Take another painting; as after a rest."""

    def finish(self) -> None:
        """Begin the full method in the background."""

    def choose_scene(
        self, scene: Scene, painting: NDArray[np.uint8] | None = None, serial: int = 0
    ) -> None:
        """Take another scene, with another painting where its source has another size."""

    def turn(self, step: int, *, warm: bool, restylize: bool = True) -> None:
        """Take another step of the target; without ``restylize`` a later rest stylizes it."""

    def set_parameters(self, values: Mapping[str, object]) -> None:
        """Change parameters by name."""

    def set_weights(self, values: Mapping[str, int]) -> None:
        """Weigh buffers by name."""

    def set_seed(self, seed: int) -> None:
        """Take another seed."""

    def step(self, operation: str) -> None:
        """Do one operation, an iteration or a level of a frame; or restart it."""

    def look(self, what: str) -> None:
        """Ask for a picture to look at."""

    def export(self, folder: Path) -> None:
        """Write the picture that is shown, and how it can be made again."""

    def close(self) -> None:
        """End the thread and the process."""
