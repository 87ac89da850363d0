"""``synthesize_texture``: from exemplars to a texture in one call."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.texture_field import TextureField
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.texture.exemplars import Exemplars
from stylit_ref.texture.iteration import Iteration
from stylit_ref.texture.label_maps import FREE_BAND, band_for_shares, labels_by_shares
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession

Progress = Callable[[Iteration], bool | None]
"""Called after each iteration; synthesis ends early where it returns True."""


@dataclass(frozen=True, eq=False)
class TextureResult:
    """A texture and how it came about.

    Attributes
    ----------
    image : (H, W) or (H, W, c) uint8
        E[S], with the channels of the exemplars. It tiles: the last column continues in the first.
    exemplars : Exemplars
    addresses : (H, W) int32
        S as the passes hold it.
    history : tuple of Iteration
    """

    image: NDArray[np.uint8]
    exemplars: Exemplars
    addresses: NDArray[np.int32]
    history: tuple[Iteration, ...]

    @cached_property
    def coordinates(self) -> NDArray[np.int32]:
        """S: for every pixel the number of its exemplar, and y and x in quarters of a pixel.

        (H, W, 3) int32. It takes four times the memory of the image, and is made when asked for.
        """
        return self.exemplars.coordinates(self.addresses)

    @property
    def field(self) -> TextureField:
        """S with the sizes of its exemplars, to be written or replayed."""
        sizes = [image.shape[:2] for image in self.exemplars.images]
        return TextureField(self.coordinates, tuple((int(h), int(w)) for h, w in sizes))


def synthesize_texture(
    exemplars: NDArray[np.uint8] | Sequence[NDArray[np.uint8]],
    size: tuple[int, int],
    params: TextureParams | None = None,
    *,
    seed: int = 0,
    labels: NDArray[np.uint8] | None = None,
    shares: Sequence[float] | None = None,
    source_guides: Sequence[NDArray[np.uint8]] | None = None,
    target_guide: NDArray[np.uint8] | None = None,
    start: NDArray[np.int32] | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> TextureResult:
    """Synthesize a texture that looks like an exemplar and tiles (Lasram & Lefebvre 2012).

    The same arguments give the same bytes, whatever the number of threads.

    Parameters
    ----------
    exemplars : (H, W) or (H, W, c) uint8, or a sequence of them
        E, 1 or 3 channels. If there are several, one of them may take all of the texture, unless
        ``labels``, ``shares`` or guides say otherwise.
    size : tuple of int
        Height and width of the texture.
    params : TextureParams, optional
    seed : int
        From 0 to 2**64 - 1.
    labels : (height, width) uint8, optional
        The number of the exemplar, from 1, that each pixel comes from; 0 for any. Within 4 pixels
        of a border between two labels, a pixel may come from any.
    shares : sequence of float, optional
        How much of the texture each exemplar gets, to 2 %, in place of ``labels``: a map is drawn
        with these shares, which are divided by their sum.
    source_guides : sequence of (H, W) or (H, W, c) uint8, optional
        A guide for every exemplar, as large as it, 1 or 3 channels.
    target_guide : (height, width) or (height, width, c) uint8, optional
        The guide that the texture shall follow; ``params.guide_weight`` says how closely.
    start : (height, width, 3) int32, optional
        Coordinates to begin with, as ``TextureResult.coordinates``; white noise by default.
    threads : int, optional
        Threads to use; by default all.
    progress : callable, optional
        Called with an :class:`Iteration` after each; synthesis ends early where it returns True.

    Returns
    -------
    TextureResult

    Raises
    ------
    InputError
        If arrays or parameters do not fit together; the message names the sizes.
    """
    images = [exemplars] if isinstance(exemplars, np.ndarray) else list(exemplars)
    free_band = FREE_BAND
    with using_threads(threads):
        if shares is not None:
            labels = labels_by_shares(shares, len(images), size, seed, labels)
            free_band = band_for_shares(labels)
        session = TextureSession(
            images, size, params, seed=seed, labels=labels, free_band=free_band,
            source_guides=source_guides, target_guide=target_guide, start=start,
        )  # fmt: skip
        return finish(session, images[0].ndim == 2, progress)


def finish(session: TextureSession, flat: bool, progress: Progress | None) -> TextureResult:
    """Do all iterations of a session; the image is (H, W) if it is to be ``flat``."""
    history = tuple(run(session, progress))
    image = session.image
    return TextureResult(
        image=image[:, :, 0] if flat else image,
        exemplars=session.exemplars,
        addresses=session.addresses,
        history=history,
    )


def run(session: TextureSession, progress: Progress | None = None) -> list[Iteration]:
    """Do all iterations of a session's parameters, or until their patience ends."""
    params, history, idle = session.params, [], 0
    while session.iteration < params.iterations and idle != params.patience:
        iteration = session.step()
        history.append(iteration)
        idle = 0 if iteration.accepted else idle + 1
        if progress and progress(iteration):
            break
    return history
