"""The stylization in real time of the library itself, on the stage of Heidrich (2017)."""

import time
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from eval.on_processor import OnProcessor
from eval.outcome import Outcome
from stylit_ref.machine.compilation import compiling_together
from stylit_ref.realtime import passes
from stylit_ref.realtime.packing import choose_packing, pack
from stylit_ref.realtime.packing.stage import STAGE_BUFFERS
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.session import Session
from stylit_ref.realtime.warm_up import kernels_of_frame


@dataclass(frozen=True)
class Realtime(OnProcessor):
    """Frames of :class:`stylit_ref.realtime.session.Session`.

    Attributes
    ----------
    name : str
        What reports call it.
    params : RealtimeParams
    weights : tuple of (str, int)
        Of buffers, where it is not 1; 0 leaves one out.
    """

    name: str
    params: RealtimeParams = field(default_factory=RealtimeParams)
    weights: tuple[tuple[str, int], ...] = ()

    cost = 0.1

    def frames(self, scene, seed, threads=None):
        """A session that makes frames of the scene, :class:`Frames`."""
        return Frames(scene, self.params, self.weights, seed, threads)

    def run(self, scene, seed, progress=None):
        """Make a cold frame; the kernels are compiled first.

        Parameters
        ----------
        scene : Scene
            With the buffers of the stage.
        seed : int
        progress : callable, optional
            Not called: a frame takes a twentieth of a second.

        Returns
        -------
        Outcome
            The NNF has the place of every pixel in the patch of its nearest entry, or its own
            match after a dense finish.
        """
        return outcome_of(self.frames(scene, seed), self.params.step)


class Frames:
    """A session, and the target's buffers that it makes frames of.

    Parameters
    ----------
    scene : Scene
    params : RealtimeParams
    weights : tuple of (str, int)
    seed : int
    threads : int, optional
    passes : module, optional
        As a session takes them.
    """

    def __init__(self, scene, params, weights=(), seed=0, threads=None, passes=passes):
        source = {name: scene.buffers[name][0] for name in STAGE_BUFFERS}
        self.show(scene)
        self.source_size = scene.style.shape[:2]
        self.packing = choose_packing(source, params.packing)
        self.session = Session(params, seed=seed, threads=threads, passes=passes)
        self.source_guides, labels = pack(self.packing, source)
        self.session.set_exemplar(self.source_guides, scene.style, labels)
        weights = dict(weights)
        self.session.set_weights([weights.get(name, 1) for name in self.packing.channels])

    def show(self, scene):
        """Another target, in the caller's memory."""
        self.target = {name: scene.buffers[name][1] for name in STAGE_BUFFERS}
        self.size = scene.target_guides[0].shape[:2]
        self._labels = np.zeros(self.size, np.uint8)

    def take(self):
        """Pack the target's buffers."""
        view = self.session.target_view(*self.size)
        self.packing.pack_into(self.target, view, self._labels)
        self.session.view_changed(self._labels)

    def frame(self):
        """A cold frame from the caller's buffers, packing included; (H, W, 3) uint8."""
        with compiling_together(partial(kernels_of_frame, self.session.params, self.packing)):
            self.take()
            return self.session.frame()


def outcome_of(frames, step):
    """A frame, the time of another one, and where its pixels were taken from.

    Parameters
    ----------
    frames : Frames
    step : int
        Pixels from entry to entry of its grid.

    Returns
    -------
    Outcome
    """
    frames.frame()  # compiles
    start = time.perf_counter()
    image = frames.frame()
    seconds = time.perf_counter() - start
    session = frames.session
    if session.params.dense_finish:
        nnf = session.dense_nnf()
    else:
        nnf = of_every_pixel(session.nnf, step, frames.size, frames.source_size)
    return Outcome(image, seconds, nnf)


def of_every_pixel(entries, step, size, source_size):
    """The place of every pixel in the patch of the entry nearest to it.

    Parameters
    ----------
    entries : (rows, columns, 2) int32
        Centres ``(y, x)`` in the source, of an entry at every ``step``-th pixel.
    step : int
    size, source_size : (int, int)
        Height and width.

    Returns
    -------
    (H, W, 2) int32
    """
    nearest = [
        np.minimum((np.arange(pixels) + step // 2) // step, count - 1)
        for pixels, count in zip(size, entries.shape[:2], strict=True)
    ]
    rows, columns = np.ix_(*nearest)
    offsets = np.stack(
        np.broadcast_arrays(
            (np.arange(size[0]) - step * nearest[0])[:, None],
            np.arange(size[1]) - step * nearest[1],
        ),
        axis=2,
    )
    return (entries[rows, columns] + offsets).clip(0, np.array(source_size) - 1).astype(np.int32)
