"""The frames that follow a painting: a session, and what of it is out of date."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.field import Field
from stylit_ref.files.realtime_field import RealtimeField
from stylit_ref.machine.compilation import compile_missing
from stylit_ref.realtime.packing import Packing, choose_packing
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.session import Session
from stylit_ref.realtime.warm_up import kernels_of_frame
from stylit_ref.studio.engine.events import Which
from stylit_ref.studio.engine.packed_scene import PackedScene, pack_scene
from stylit_ref.studio.engine.parameters import Settings
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.engine.shown import Shown


class _State(NamedTuple):
    """All that a frame is given by."""

    scene: Scene
    step: int
    settings: Settings
    paintings: int
    """Changes of the painting until then."""


class _Ready(NamedTuple):
    """A session, and what it holds."""

    state: _State
    packed: PackedScene
    session: Session


class _Last(NamedTuple):
    """The last picture."""

    which: Which
    image: NDArray[np.uint8]
    state: _State
    session: Session
    weighs_buffers: bool


class Follower:
    """A painting, and frames of a scene in its style.

    One thread alone may call it, but for :meth:`cancel`. Its attributes may be set between calls.

    Parameters
    ----------
    scene : Scene
    painting : (H_A, W_A, 3) uint8
        Is kept, and changed by :meth:`paint`.
    settings : Settings
    threads : int, optional

    Attributes
    ----------
    scene : Scene
    settings : Settings
    step : int
        Of the target.
    painting : (H_A, W_A, 3) uint8
    serial : int
        Of the last change of the painting.
    """

    scene: Scene
    settings: Settings
    step: int
    painting: NDArray[np.uint8]
    serial: int

    def __init__(
        self,
        scene: Scene,
        painting: NDArray[np.uint8],
        settings: Settings,
        threads: int | None = None,
    ) -> None:
        self.scene, self.settings, self.step = scene, settings, 0
        self.painting, self.serial = painting, 0
        self._threads = threads
        self._changes = 0  # of the painting
        self._ready: _Ready | None = None
        self._searched: _State | None = None  # what its NNF was searched for
        self._last: _Last | None = None

    @property
    def can_replay(self) -> bool:
        """Whether nothing but the painting has changed since a frame."""
        searched = self._searched
        return searched is not None and searched[:3] == self._state[:3]

    @property
    def is_searched(self) -> bool:
        """Whether there is a frame of all as it is."""
        return self._searched == self._state

    def check(self, settings: Settings) -> None:
        """Refuse settings that cannot be, as far as that is known at once; from any thread.

        Raises
        ------
        InputError
        """
        scene, ready, packing = self.scene, self._ready, settings.live.packing
        if packing not in ("auto", "pca"):
            choose_packing(scene.source, packing)  # looks for its buffers
        if ready and (ready.state.scene, ready.state.settings.live.packing) == (scene, packing):
            ready.packed.check(settings, scene)

    def paint(self, x: int, y: int, pixels: NDArray[np.uint8], serial: int) -> None:
        """Change a rectangle of the painting."""
        height, width = pixels.shape[:2]
        self.painting[y : y + height, x : x + width] = pixels
        self._changes, self.serial = self._changes + 1, serial

    def replace_painting(self, painting: NDArray[np.uint8], serial: int) -> None:
        """Take another painting, which is kept and changed."""
        self.painting = painting
        self._changes, self.serial = self._changes + 1, serial

    def prepare(
        self,
        compiling: Callable[[int, int], None],
        ahead: Callable[[RealtimeParams, Packing], None],
    ) -> None:
        """Have a session that holds all as it is.

        Parameters
        ----------
        compiling : callable
            Called before each kernel that is compiled, with its number and how many there are.
        ahead : callable
            Called before the first of them: another process may begin with the last.

        Raises
        ------
        InputError
            If the scene cannot be stylized so; the session is then as it was.
        """
        state, ready = self._state, self._ready
        if ready and ready.state == state:
            return
        live, packed = state.settings.live, self._pack(state)
        if ready is None or (ready.state.scene, ready.state.settings.live) != (state.scene, live):
            kernels = kernels_of_frame(live, packed.packing, warm=True)
            if not all(kernel.is_compiled for kernel in kernels):
                ahead(live, packed.packing)
                compile_missing(kernels, compiling)
            self._ready = _Ready(state, packed, self._session_of(packed))
            return
        before, _, session = ready
        if before.step != state.step:
            session.set_target(packed.target, packed.target_labels)
        if before.settings != state.settings:
            session.set_weights(packed.weights(state.settings, state.scene))
        if before.paintings != state.paintings:
            session.set_style(self.painting)
        self._ready = _Ready(state, packed, session)

    def replay(self) -> NDArray[np.uint8]:
        """The last frame with the painting as it is; only if :attr:`can_replay`."""
        ready = self._needs_ready()
        image = ready.session.replay()
        self._keep("replay", image, ready)
        return image

    def frame(self, *, warm: bool) -> tuple[Which, NDArray[np.uint8]]:
        """A frame of all as it is; warm where that is wished, and only the target has changed.

        A stroke wants a cold frame, whose patches lie together.

        Raises
        ------
        FrameCancelledError
            If it was cancelled.
        """
        ready, searched = self._needs_ready(), self._searched
        state = ready.state
        is_warm = (
            warm
            and searched is not None
            and ready.session.has_frame
            and searched._replace(step=state.step) == state
        )
        image = ready.session.frame(warm=is_warm, seed=state.settings.seed)
        self._searched = state
        which: Which = "warm" if is_warm else "coherent"
        self._keep(which, image, ready)
        return which, image

    def cancel(self) -> None:
        """End a frame that another thread computes."""
        ready = self._ready
        if ready:
            ready.session.cancel()

    def level_picture(self, level: int) -> NDArray[np.uint8]:
        """B' of a level of the last frame.

        Raises
        ------
        InputError
            If there is no frame, or no such level.
        """
        return self._needs_last().session.picture_at(level)

    def shown(self) -> Shown:
        """The last picture, and what it was made of.

        Raises
        ------
        InputError
            If there is none, or the painting has changed since.
        """
        last = self._needs_last()
        scene, step, settings, paintings = last.state
        if paintings != self._changes:
            raise InputError("the picture does not show the last stroke yet; wait for it")
        live, style = settings.live, self.painting.copy()
        field: Field | RealtimeField
        if live.dense_finish:
            field = Field(
                last.session.dense_nnf(),
                live.patch_width,
                style_size=scene.size,
                guide_encodings=scene.encodings,
            )
        else:
            sizes = scene.size, last.image.shape[:2]
            field = RealtimeField(
                last.session.nnf, live.patch_width, live.step, *sizes, scene.encodings
            )
        return Shown(
            last.which, last.image, style, field, scene, step, settings, last.weighs_buffers
        )

    def own_session(self) -> Session:
        """Another session of all as it is.

        Raises
        ------
        InputError
            If the scene cannot be stylized so.
        """
        return self._session_of(self._pack(self._state))

    @property
    def _state(self) -> _State:
        return _State(self.scene, self.step, self.settings.of_live, self._changes)

    def _keep(self, which, image, ready):
        weighs = ready.packed.weights(self.settings, self.scene) is not None
        self._last = _Last(which, image, ready.state, ready.session, weighs)

    def _pack(self, state):
        """The scene as sessions take it; what was packed before is kept where it is the same."""
        ready, live = self._ready, state.settings.live
        if ready is None or ready.state.scene is not state.scene:
            return pack_scene(state.scene, state.step, live)
        before = ready.state.settings.live
        if before.packing != live.packing:
            return pack_scene(state.scene, state.step, live)
        if (ready.state.step, before.labels) != (state.step, live.labels):
            return pack_scene(state.scene, state.step, live, ready.packed.packing)
        return ready.packed

    def _session_of(self, packed):
        settings = self.settings
        session = Session(settings.live, seed=settings.seed, threads=self._threads)
        session.set_exemplar(packed.source, self.painting, packed.labels)
        session.set_target(packed.target, packed.target_labels)
        session.set_weights(packed.weights(settings, self.scene))
        return session

    def _needs_ready(self):
        if self._ready is None:
            raise InputError("there is no session yet; prepare one first")
        return self._ready

    def _needs_last(self):
        if self._last is None:
            raise InputError("there is no picture yet; wait for the first")
        return self._last
