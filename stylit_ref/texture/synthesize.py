"""``synthesize_texture``: from an exemplar to a texture in one call."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import Iteration, TextureSession


@dataclass(frozen=True)
class TextureResult:
    """A texture and how it came about.

    Attributes
    ----------
    image : (H, W) or (H, W, c) uint8
        E[S], with the channels of the exemplars. It tiles: the last column continues in the first.
    coordinates : (H, W, 3) int32
        S: for every pixel the number of its exemplar, and y and x in quarters of a pixel.
    history : tuple of Iteration
    """

    image: NDArray[np.uint8]
    coordinates: NDArray[np.int32]
    history: tuple[Iteration, ...]


def synthesize_texture(
    exemplars: NDArray[np.uint8] | Sequence[NDArray[np.uint8]],
    size: tuple[int, int],
    params: TextureParams | None = None,
    *,
    seed: int = 0,
    progress: Callable[[Iteration], None] | None = None,
) -> TextureResult:
    """Synthesize a texture that looks like an exemplar and tiles (Lasram & Lefebvre 2012).

    The same arguments give the same bytes, whatever the number of threads.

    Parameters
    ----------
    exemplars : (H, W) or (H, W, c) uint8, or a sequence of them
        E, 1 or 3 channels.
    size : tuple of int
        Height and width of the texture.
    params : TextureParams, optional
    seed : int
        From 0 to 2**64 - 1.
    progress : callable, optional
        Called with an :class:`Iteration` after each.

    Returns
    -------
    TextureResult

    Raises
    ------
    InputError
        If arrays or parameters do not fit together; the message names the sizes.
    """
    images = [exemplars] if isinstance(exemplars, np.ndarray) else list(exemplars)
    session = TextureSession(images, size, params, seed=seed)
    history = tuple(run(session, progress))
    image = session.image
    return TextureResult(
        image=image[:, :, 0] if images[0].ndim == 2 else image,
        coordinates=session.coordinates,
        history=history,
    )


def run(
    session: TextureSession, progress: Callable[[Iteration], None] | None = None
) -> list[Iteration]:
    """Do all iterations of a session's parameters, or until their patience ends."""
    params, history, idle = session.params, [], 0
    while session.iteration < params.iterations and idle != params.patience:
        iteration = session.step()
        history.append(iteration)
        idle = 0 if iteration.accepted else idle + 1
        if progress:
            progress(iteration)
    return history
