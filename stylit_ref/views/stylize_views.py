"""``stylize_frames`` and ``stylize_views``: from images and motion to coherent pictures."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, nullcontext
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.stylization.mask import fill_masked
from stylit_ref.stylization.params import Params
from stylit_ref.views.frame_result import FrameResult
from stylit_ref.views.frame_step import FrameStep
from stylit_ref.views.frames import Edges
from stylit_ref.views.params import SEQUENCE, Coherence
from stylit_ref.views.problem import make_problem
from stylit_ref.views.shot import ArrayShot, Shot
from stylit_ref.views.work.distributed import Job, do_on_cluster
from stylit_ref.views.work.keys import code_key, keys_of
from stylit_ref.views.work.walk import Walk
from stylit_ref.views.work.work_folder import WorkFolder
from stylit_ref.views.work.workbench import Workbench

Frames = Shot | Sequence[Sequence[NDArray[np.uint8]]]
"""A shot, or the guides of every frame."""


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
    scheduler: str | None = None,
    progress: Callable[[FrameStep], None] | None = None,
) -> Iterator[FrameResult]:
    """Stylize a sequence: :func:`stylize_views` with the coherence that suits one.

    Without ``coherence`` a frame is finished before the next begins, and the finished one counts as
    much as the frame's own style (``Coherence(weight=1, order="sequential")``). The command line
    adds ``following_votes=(1, 2, 4)`` where its preset is ``fast``.

    Returns
    -------
    iterator of FrameResult
    """
    return stylize_views(
        style, source_guides, frames, params, coherence or SEQUENCE,
        edges=edges, seed=seed, threads=threads, work=work,
        scheduler=scheduler, progress=progress,
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
    scheduler: str | None = None,
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
    scheduler : str, optional
        Address of a Dask scheduler, as ``tcp://10.0.0.1:8786``, whose machines do the work. All of
        them must know the work folder, and the files of the shot, by the same path.
    progress : callable, optional
        Called with a :class:`FrameStep` as a frame advances.

    Returns
    -------
    iterator of FrameResult
        In the order in which frames are finished.

    Raises
    ------
    InputError
        If arrays, motion or parameters do not fit together; the message names the sizes. If no
        scheduler answers.
    """
    if scheduler is not None and work is None:
        raise InputError(
            "is missing; with a scheduler name a folder that all machines know", parameter="work"
        )
    if isinstance(frames, Shot):
        if edges is not None:
            raise InputError("are those of the shot; leave them out", parameter="edges")
        shot = frames
    else:
        shot = ArrayShot(frames, edges)
    problem = make_problem(style, source_guides, shot, params, coherence, seed=seed)
    bench = Workbench(problem)
    return _results(problem, bench, work, scheduler, threads, progress, is_grey=np.ndim(style) == 2)


def _results(problem, bench, work, scheduler, threads, progress, *, is_grey):
    with TemporaryDirectory() if work is None else nullcontext(work) as path:
        folder, keys = WorkFolder(path), keys_of(problem, problem.plan())
        walk = Walk(problem, folder, bench, keys, threads)
        do_all = walk.do_here
        if scheduler is not None:
            job = Job(problem, str(folder.folder.resolve()), keys, threads, code_key(problem.shot))
            do_all = partial(do_on_cluster, job, scheduler)
        with closing(walk.run(do_all, progress)) as finished:
            for frame, state in finished:
                image, mask = state.picture, problem.shot.mask(frame)
                if mask is not None:
                    image = fill_masked(image, mask, None)
                elif is_grey:
                    image = image[:, :, 0]
                # Copies: the walk still reads the state, whatever a caller does to its result.
                yield FrameResult(frame, problem.shot.names[frame], image.copy(), state.nnf.copy())
