"""``stylize_frames`` and ``stylize_views``: from images and motion to coherent pictures."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.stylization.params import Params
from stylit_ref.views.frame_step import FrameStep
from stylit_ref.views.frames import Edges
from stylit_ref.views.params import SEQUENCE, Coherence
from stylit_ref.views.problem import make_problem
from stylit_ref.views.shot import ArrayShot, Shot
from stylit_ref.views.walk import Walk
from stylit_ref.views.work_folder import WorkFolder
from stylit_ref.views.workbench import Workbench

Frames = Shot | Sequence[Sequence[NDArray[np.uint8]]]
"""A shot, or the guides of every frame."""


@dataclass(frozen=True)
class FrameResult:
    """A stylized frame.

    Attributes
    ----------
    frame : int
        Its number, from 0.
    name : str
    image : (H_B, W_B) or (H_B, W_B, n) uint8
        The output B', with the style's channels.
    nnf : (H_B, W_B, 2) int32
        For each target pixel the centre ``(y, x)`` of its source patch.
    """

    frame: int
    name: str
    image: NDArray[np.uint8]
    nnf: NDArray[np.int32]


def stylize_frames(
    style: NDArray[np.uint8],
    source_guides: Sequence[NDArray[np.uint8]],
    frames: Frames,
    params: Params | None = None,
    coherence: Coherence | None = None,
    *,
    edges: Edges | None = None,
    seed: int = 0,
    threads: int | None = None,
    work: str | Path | None = None,
    progress: Callable[[FrameStep], None] | None = None,
) -> Iterator[FrameResult]:
    """Stylize a sequence: :func:`stylize_views` with the coherence that suits one.

    Without ``coherence`` a frame is finished before the next begins, and the finished one counts as
    much as the frame's own style (``Coherence(weight=1, order="sequential")``).

    Returns
    -------
    iterator of FrameResult
    """
    return stylize_views(
        style, source_guides, frames, params, coherence or SEQUENCE,
        edges=edges, seed=seed, threads=threads, work=work, progress=progress,
    )  # fmt: skip


def stylize_views(
    style: NDArray[np.uint8],
    source_guides: Sequence[NDArray[np.uint8]],
    frames: Frames,
    params: Params | None = None,
    coherence: Coherence | None = None,
    *,
    edges: Edges | None = None,
    seed: int = 0,
    threads: int | None = None,
    work: str | Path | None = None,
    progress: Callable[[FrameStep], None] | None = None,
) -> Iterator[FrameResult]:
    """Stylize views or frames that pull at each other (Hauptfleisch 3.2).

    The same arguments give the same bytes, whatever the number of threads. Without coherence, each
    frame has the bytes that :func:`stylit_ref.stylize` gives it. Close the iterator to cancel.

    Parameters
    ----------
    style : (H_A, W_A) or (H_A, W_A, n) uint8
        The style exemplar A', 1 to 4 channels.
    source_guides : sequence of (H_A, W_A) or (H_A, W_A, c) uint8
        Guidance A.
    frames : Shot, or sequence of sequences of (H_B, W_B) or (H_B, W_B, c) uint8
        What gives guidance B and motion on demand; or guidance B of every frame, all of one size.
    params : Params, optional
    coherence : Coherence, optional
        By default the one that suits a grid: all views at once, each neighbour with a weight of
        0.5.
    edges : mapping from (int, int) to Motion, optional
        With guides alone: which frames pull at each other, and the motion from frame ``to`` into
        frame ``other``, by ``(to, other)``. :func:`stylit_ref.views.frames.sequence_pairs` and
        ``grid_pairs`` name the pairs of sequences and grids.
    seed : int
        From 0 to 2**64 - 1; all frames use the same random numbers.
    threads : int, optional
        Threads to use; all by default, and no more than all.
    work : str or Path, optional
        A folder for the states of frames. A run that was interrupted goes on from there, and one
        with other arguments does again only what depends on them. By default a temporary one.
    progress : callable, optional
        Called with a :class:`FrameStep` as a frame advances.

    Returns
    -------
    iterator of FrameResult
        In the order in which frames are finished.

    Raises
    ------
    InputError
        If arrays, motion or parameters do not fit together; the message names the sizes.
    """
    if isinstance(frames, Shot):
        if edges is not None:
            raise InputError("are those of the shot; leave them out", parameter="edges")
        shot = frames
    else:
        shot = ArrayShot(frames, edges)
    problem = make_problem(style, source_guides, shot, params, coherence, seed=seed)
    bench = Workbench(problem)
    return _results(problem, bench, work, np.ndim(style) == 2, threads, progress)


def _results(problem, bench, work, is_grey, threads, progress):
    with TemporaryDirectory() if work is None else nullcontext(work) as folder:
        walk = Walk(problem, WorkFolder(folder), bench, threads)
        for frame, state in walk.run(progress):
            image = state.picture[:, :, 0] if is_grey else state.picture
            yield FrameResult(frame, problem.shot.names[frame], image, state.nnf)
