"""``stylize_views``: from images and motion to coherent pictures in one call."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.thread_count import using_threads
from stylit_ref.stylization.params import Params
from stylit_ref.views.frames import Edges
from stylit_ref.views.params import Coherence
from stylit_ref.views.problem import make_coherent_synthesis
from stylit_ref.views.synthesis import FrameStep


@dataclass(frozen=True)
class FrameResult:
    """A stylized frame.

    Attributes
    ----------
    image : (H_B, W_B) or (H_B, W_B, n) uint8
        The output B', with the style's channels.
    nnf : (H_B, W_B, 2) int32
        For each target pixel the centre ``(y, x)`` of its source patch.
    """

    image: NDArray[np.uint8]
    nnf: NDArray[np.int32]


def stylize_views(
    style: NDArray[np.uint8],
    source_guides: Sequence[NDArray[np.uint8]],
    target_guides: Sequence[Sequence[NDArray[np.uint8]]],
    edges: Edges,
    params: Params | None = None,
    coherence: Coherence | None = None,
    *,
    seed: int = 0,
    threads: int | None = None,
    progress: Callable[[FrameStep], None] | None = None,
) -> list[FrameResult]:
    """Stylize views or frames that pull at each other (Hauptfleisch 3.2).

    The same arguments give the same bytes, whatever the number of threads. Without coherence, each
    frame has the bytes that :func:`stylit_ref.stylize` gives it.

    Parameters
    ----------
    style : (H_A, W_A) or (H_A, W_A, n) uint8
        The style exemplar A', 1 to 4 channels.
    source_guides : sequence of (H_A, W_A) or (H_A, W_A, c) uint8
        Guidance A.
    target_guides : sequence of sequences of (H_B, W_B) or (H_B, W_B, c) uint8
        Guidance B of every frame, all of one size.
    edges : mapping from (int, int) to Motion
        Which frames pull at each other: the motion from frame ``to`` into frame ``other``, by
        ``(to, other)``. :func:`stylit_ref.views.frames.sequence_pairs` and ``grid_pairs`` name the
        pairs of sequences and grids.
    params : Params, optional
    coherence : Coherence, optional
    seed : int
        From 0 to 2**64 - 1; all frames use the same random numbers.
    threads : int, optional
        Threads to use; all by default, and no more than all.
    progress : callable, optional
        Called with a :class:`FrameStep` after every PatchMatch iteration or retrieval of a frame.

    Returns
    -------
    list of FrameResult

    Raises
    ------
    InputError
        If arrays, motion or parameters do not fit together; the message names the sizes.
    """
    with using_threads(threads):
        synthesis = make_coherent_synthesis(
            style, source_guides, target_guides, edges, params, coherence, seed=seed
        )
        for step in synthesis.run():
            if progress:
                progress(step)
    grey = np.ndim(style) == 2
    return [
        FrameResult(
            np.ascontiguousarray(run.level.style[:, :, 0] if grey else run.level.style),
            run.level.nnf,
        )
        for run in synthesis.runs
    ]
