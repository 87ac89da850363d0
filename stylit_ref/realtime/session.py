"""A picture that follows its inputs in real time."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager, nullcontext
from threading import RLock

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.machine.free_threads import FreeThreads
from stylit_ref.machine.replaced import Passes
from stylit_ref.machine.thread_count import check_threads, using_threads
from stylit_ref.parameters import Integer
from stylit_ref.randomness.seed import check_seed
from stylit_ref.realtime import passes as cpu_passes
from stylit_ref.realtime.checks import (
    check_guides,
    check_labels,
    check_nnf,
    check_sides,
    check_style,
    check_weights,
)
from stylit_ref.realtime.exemplar import Exemplar, labels_in
from stylit_ref.realtime.formulae.grid import first_centre, last_centre
from stylit_ref.realtime.formulae.packed_nnf import entries_of, places_of
from stylit_ref.realtime.frame_inputs import FrameInputs
from stylit_ref.realtime.layout import Layout
from stylit_ref.realtime.params import RealtimeParams, as_realtime_params
from stylit_ref.realtime.refinement import (
    Refinements,
    refine,
    renew,
    start_level,
    threads_of_level,
)
from stylit_ref.realtime.target import Target

_TURN = RLock()
"""Held by the session that computes: its kernels let other threads of Python run."""


class FrameCancelledError(Exception):
    """The frame was given up by :meth:`Session.cancel`; the session is as it was before it."""


class Session:
    """A source and a target, of which any part may change between two frames.

    Several threads may call sessions: they wait for each other, whichever session they call.

    Parameters
    ----------
    params : RealtimeParams or str, optional
        Parameters, or the name of a preset.
    seed : int
    threads : int, optional
        By default all, or one while other programs need the processors. Frames do not depend on it.
    passes : module, optional
        :mod:`stylit_ref.realtime.passes`, or such passes with some replaced.

    Attributes
    ----------
    seed : int
        A frame is given by it, the inputs and, if it starts warm, the NNF before it.
    """

    seed: int

    def __init__(
        self,
        params: RealtimeParams | str | None = None,
        *,
        seed: int = 0,
        threads: int | None = None,
        passes: Passes = cpu_passes,
    ) -> None:
        check_seed(seed)
        check_threads(threads)
        self._params, self.seed = as_realtime_params(params), seed
        self._threads, self._free_threads = threads, FreeThreads()
        self._passes = passes
        self._stop, self._cancelled = np.zeros(1, np.uint8), 0
        self._exemplar: Exemplar | None = None
        self._refinements: Refinements | None = None
        self._target: Target | None = None
        self._viewed: Target | None = None  # what a caller writes to while the target is whole
        self._nnf: list[NDArray[np.int32]] = []
        self._labels: NDArray[np.uint8] | None = None
        self._kept: int | None = None  # the first level whose NNF a stroke leaves as it is
        self._seed_of_kept = seed
        self._has_frame = False
        self._dense: NDArray[np.int32] | None = None

    @property
    def params(self) -> RealtimeParams:
        """Parameters; other ones need another session."""
        return self._params

    def set_exemplar(
        self,
        guides: NDArray[np.uint8],
        style: NDArray[np.uint8],
        labels: NDArray[np.uint8] | None = None,
    ) -> None:
        """Take another source; if there is a target, its guides must have as many channels.

        Parameters
        ----------
        guides : (height, width, channels) uint8
            A, packed; at most 28 channels, and fast up to 12.
        style : (height, width, 3) uint8
            A'.
        labels : (height, width) uint8, optional
            What each pixel belongs to.

        Raises
        ------
        InputError
            If they do not fit together.
        """
        guides = np.ascontiguousarray(check_guides(guides, "source_guides"))
        size = guides.shape[:2]
        style = np.ascontiguousarray(check_style(style, size))
        labels = check_labels(labels if self.params.labels else None, size, "source_labels")
        with self.turn():
            if self._target is not None:
                self._check_pair(
                    guides.shape[2], self._target.layout.channels, "source_guides",
                    remedy="pack both alike, or begin a new Session for other channels",
                )  # fmt: skip
                known = None if labels is None else labels_in(labels, self._passes)
                self._check_known(known, self._labels, "source_labels")
            layout = Layout(self.params, guides.shape[2], self._passes)
            refinements = Refinements.of(layout, self._weights_for(layout.channels))
            # There is none if an interruption comes before the last line: never half of one.
            exemplar, self._exemplar = self._exemplar, None
            if exemplar is None or (exemplar.size, exemplar.layout) != (size, layout):
                exemplar, self._has_frame, self._nnf = Exemplar(*size, layout), False, []
            exemplar.set_guides(guides)
            exemplar.set_style(style)
            exemplar.join()
            exemplar.set_labels(labels)
            if self._target is not None:
                self._target.set_labels(self._labels, exemplar.has_label)
            self._refinements, self._kept = refinements, None
            self._exemplar = exemplar

    def set_style(self, style: NDArray[np.uint8]) -> None:
        """Take another A' of the same size, (height, width, 3) uint8.

        What depends on the guides alone is kept, coarse levels of the next frame included.

        Raises
        ------
        InputError
            If it does not fit the source guides.
        """
        with self.turn():
            exemplar = self._needs_exemplar()
            exemplar.set_style(np.ascontiguousarray(check_style(style, exemplar.size)))
            exemplar.join()

    def set_target(
        self, guides: NDArray[np.uint8], labels: NDArray[np.uint8] | None = None
    ) -> None:
        """Take another target.

        Parameters
        ----------
        guides : (height, width, channels) uint8
            B, packed as A is.
        labels : (height, width) uint8, optional
            Each of them must be one of the source. Without them, those of the source do not count.

        Raises
        ------
        InputError
            If they do not fit the source.
        """
        guides = np.ascontiguousarray(check_guides(guides, "target_guides"))
        with self.turn():
            target = self._target_of(guides.shape[:2], guides.shape[2])
            labels = self._checked_labels(labels, target)
            target.set_guides(guides)
            self._take(target, labels)

    def target_view(self, height: int, width: int) -> NDArray[np.uint8]:
        """Where a target's guides can be written without a copy; then call :meth:`view_changed`.

        Parameters
        ----------
        height, width : int

        Returns
        -------
        (height, width, channels) uint8
            A strided view, for the next call of :meth:`view_changed`. What it held is undefined.

        Raises
        ------
        InputError
            If there is no source, or a side is too long.
        """
        size = height, width
        check_sides(size, "target_guides")
        with self.turn():
            layout = self._needs_exemplar().layout
            known = self._viewed
            if known is None or (known.size, known.layout) != (size, layout):
                self._viewed = Target(*size, layout)
            return self._viewed.view

    def view_changed(self, labels: NDArray[np.uint8] | None = None) -> None:
        """Take what was written to :meth:`target_view`, and the labels that belong to it.

        Raises
        ------
        InputError
            If the labels do not fit, or there is no view.
        """
        with self.turn():
            target, layout = self._viewed, self._needs_exemplar().layout
            if target is None or target.layout != layout:
                raise InputError(
                    "is not there; call target_view and write to it first", parameter="view"
                )
            labels = self._checked_labels(labels, target)
            self._viewed = self._target
            target.view_changed()
            self._take(target, labels)

    def set_weights(self, weights: Sequence[int] | None) -> None:
        """Weigh channels of the guides by integers; 0 leaves one out, None weighs all by 1.

        Raises
        ------
        InputError
            If there are not as many as channels, or they are too large.
        """
        with self.turn():
            layout = self._needs_exemplar().layout
            self._refinements = Refinements.of(layout, check_weights(weights, layout.channels))
            self._kept = None

    def frame(self, *, warm: bool = False, seed: int | None = None) -> NDArray[np.uint8]:
        """B' of the inputs as they are.

        Parameters
        ----------
        warm : bool
            Start from the last frame's NNF, renew what has grown old in it, and search level 0:
            for a target that moves a little, or to go on with the same one. After a stroke in the
            style a cold frame is better, whose coarse levels are kept.
        seed : int, optional
            From now on.

        Returns
        -------
        (height, width, 3) uint8

        Raises
        ------
        FrameCancelledError
            If :meth:`cancel` was called meanwhile.
        InputError
            If there is no source or target, or no frame that a warm one can start from.
        """
        cancelled = self._cancelled
        with self.turn():
            exemplar, target = self._needs_exemplar(), self._needs_target()
            if seed is None:
                seed = self.seed
            check_seed(seed)
            kept = self._kept if seed == self._seed_of_kept else None
            if warm and not self._has_frame:
                raise InputError(
                    "is true, but there is no frame to start from; begin with a cold one",
                    parameter="warm",
                )
            self._stop[0] = 0
            if self._cancelled != cancelled:  # while the frame waited for its turn
                self._stop[0] = 1
                self._heed_cancel()
            refinement = self._refinements.warm if warm else self._refinements.cold
            levels, last = self.params.levels, 0
            top = levels - 1 if kept is None else kept - 1
            if warm:
                last = self.params.renewed_from
                top = levels - 1 if last else -1
            nnf = [np.empty(grid, np.int32) for grid in target.grids[: top + 1]]
            nnf += self._nnf[top + 1 :]
            with self._threads_for((warm, top)):
                for level in range(top, last - 1, -1):
                    with using_threads(threads_of_level(target, level)):
                        start_level(exemplar, nnf, level, seed)
                        refine(exemplar, target, refinement, nnf, level, seed, self._stop)
                    self._heed_cancel()
                if warm:
                    # Levels between are not searched: what an earlier frame found stays to be seen.
                    nnf[: max(last, 1)] = [self._nnf[0].copy(), *self._nnf[1:last]]
                    with using_threads(threads_of_level(target, 0)):
                        if last:
                            renew(exemplar, target, refinement, nnf, last)
                        # Coarser levels may be those of another target.
                        refine(
                            exemplar, target, refinement, nnf[:1], 0, seed, self._stop, settles=True
                        )
                    self._heed_cancel()
                inputs, stop = self.inputs, self._stop
                dense = inputs.dense_nnf(nnf[0], stop) if self.params.dense_finish else None
                self._heed_cancel()
                picture = inputs.blended(nnf[0]) if dense is None else inputs.voted(dense, stop)
                self._heed_cancel()
            self._nnf, self._has_frame, self._dense = nnf, True, dense
            self.seed = seed
            if not warm:
                self._kept, self._seed_of_kept = refinement.first_level_of_guides_alone, seed
            elif last:  # a cold frame does more iterations on those levels
                self._kept = None
            return picture

    @property
    def has_frame(self) -> bool:
        """Whether there is a frame that a warm one, or a replay, can start from."""
        return self._has_frame

    def replay(self) -> NDArray[np.uint8]:
        """B' from the last frame's NNF and the style as it is: at once, while someone paints.

        Returns
        -------
        (height, width, 3) uint8
        """
        with self.turn():
            self._needs_frame()
            if self.params.dense_finish:
                return self.inputs.voted(self._finished())
            return self.inputs.blended(self._nnf[0])

    def picture_at(self, level: int) -> NDArray[np.uint8]:
        """B' of a level of the pyramid, blended from its matches as they are; 0 is the finest.

        Levels that the last frame left out show what an earlier one found.

        Returns
        -------
        (height, width, 3) uint8

        Raises
        ------
        InputError
            If there is no frame, or no such level.
        """
        Integer(0, self.params.levels - 1).check("level", level)
        with self.turn():
            self._needs_frame()
            return self.inputs.blended(self._nnf[level], level)

    def dense_nnf(self) -> NDArray[np.int32]:
        """The last frame's NNF with a match for every pixel: y and x of the source.

        It is that of the picture with ``dense_finish``; without, it is made for this call, of the
        inputs as they are.

        Returns
        -------
        (height, width, 2) int32

        Raises
        ------
        InputError
            If there is no frame, or the parameters have ``scale_space``.
        """
        with self.turn():
            self._needs_frame()
            if self.params.scale_space:
                raise InputError(
                    "compares no patches, so there is no dense NNF; leave it out",
                    parameter="scale_space",
                )
            return places_of(self._finished())

    def cancel(self) -> None:
        """End frames that other threads compute or wait for, by :class:`FrameCancelledError`."""
        self._cancelled += 1
        self._stop[0] = 1

    @property
    def nnf(self) -> NDArray[np.int32]:
        """The last frame's NNF: y and x of the source for every entry, (rows, columns, 2) int32.

        Set it to start the next warm frame from it.
        """
        with self.turn():
            self._needs_frame()
            return places_of(self._nnf[0])

    @nnf.setter
    def nnf(self, nnf: NDArray[np.int32]) -> None:
        with self.turn():
            exemplar, target = self._needs_exemplar(), self._needs_target()
            margin = exemplar.layout.margin
            first, last = (
                (end(exemplar.size[0], margin), end(exemplar.size[1], margin))
                for end in (first_centre, last_centre)
            )
            nnf = check_nnf(nnf, target.grids[0], first, last)
            levels = self._nnf or [np.zeros(grid, np.int32) for grid in target.grids]
            self._nnf = [entries_of(nnf), *levels[1:]]
            self._has_frame, self._dense = True, None

    @contextmanager
    def turn(self) -> Iterator[None]:
        """Let this session alone compute while the block runs, with its number of threads."""
        with _TURN:
            threads = self._free_threads.number if self._threads is None else self._threads
            with using_threads(threads):
                yield

    @property
    def inputs(self) -> FrameInputs:
        """What the next cold frame is made of.

        Raises
        ------
        InputError
            If there is no source or target.
        """
        return FrameInputs(
            self._needs_exemplar(), self._needs_target(), self._refinements.cold, self._labels
        )

    def _threads_for(self, kind):
        return self._free_threads.frame(kind) if self._threads is None else nullcontext()

    def _heed_cancel(self):
        if self._stop[0]:
            raise FrameCancelledError("the frame was cancelled")

    def _finished(self):
        if not self.params.dense_finish:
            return self.inputs.dense_nnf(self._nnf[0])
        if self._dense is None:
            self._dense = self.inputs.dense_nnf(self._nnf[0])
        return self._dense

    def _target_of(self, size, channels):
        layout = self._needs_exemplar().layout
        self._check_pair(channels, layout.channels, "target_guides")
        if self._target is not None and self._target.size == tuple(size):
            return self._target
        return Target(*size, layout)

    def _take(self, target, labels):
        if self._target is None or target.size != self._target.size:
            self._has_frame, self._nnf = False, []
            self._free_threads.forget()
        target.set_labels(labels, self._needs_exemplar().has_label)
        self._target, self._labels, self._kept = target, labels, None

    def _checked_labels(self, labels, target):
        labels = check_labels(labels if self.params.labels else None, target.size, "target_labels")
        self._check_known(self._needs_exemplar().own_labels, labels, "target_labels")
        return labels

    def _check_known(self, known, target, parameter):
        if target is None:
            return
        if known is None:
            raise InputError(
                "are given for the target alone; give them for both sides, or for neither",
                parameter=parameter,
            )
        unknown = np.flatnonzero(labels_in(target, self._passes) & ~known)
        if unknown.size:
            raise InputError(
                f"have {unknown[0]} in the target, but not in the source; add a pixel of it to the "
                "source, leave labels out, or set a target without labels before both sides change",
                parameter=parameter,
            )

    def _check_pair(self, channels, others, parameter, remedy="pack both alike"):
        if channels != others:
            raise InputError(
                f"has {channels} channels, but the other side has {others}; {remedy}",
                parameter=parameter,
            )

    def _weights_for(self, channels):
        refinements = self._refinements
        is_for_these = refinements is not None and len(refinements.cold.weights) == channels
        return refinements.cold.weights if is_for_these else (1,) * channels

    def _needs_exemplar(self):
        if self._exemplar is None:
            raise InputError("is not set; call set_exemplar first", parameter="exemplar")
        return self._exemplar

    def _needs_target(self):
        if self._target is None:
            raise InputError("is not set; call set_target first", parameter="target")
        return self._target

    def _needs_frame(self):
        if not self._has_frame:
            raise InputError("is not there yet; compute a frame first", parameter="nnf")


RealtimeSession = Session
"""What :class:`Session` is called where there are sessions of other kinds."""
