"""``synthesize_texture``: from exemplars to a texture in one call."""

import logging
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.texture_field import TextureField
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.notes import note
from stylit_ref.texture.exemplars import Exemplars, make_field
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
    iterations, idle : int
        How many were done, also before ``start`` was saved, and how many of them, up to the last,
        changed nothing.
    """

    image: NDArray[np.uint8]
    exemplars: Exemplars
    addresses: NDArray[np.int32]
    history: tuple[Iteration, ...]
    iterations: int
    idle: int

    @cached_property
    def coordinates(self) -> NDArray[np.int32]:
        """S: for every pixel the number of its exemplar, and y and x in quarters of a pixel.

        (H, W, 3) int32. It takes four times the memory of the image, and is made when asked for.
        """
        return self.exemplars.coordinates(self.addresses)

    @property
    def field(self) -> TextureField:
        """S with the sizes of its exemplars, to be saved, replayed or resumed."""
        return make_field(self.exemplars, self.addresses, self.iterations, self.idle)


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
    start: TextureField | NDArray[np.int32] | None = None,
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
    start : TextureField or (height, width, 3) int32, optional
        What to begin with; white noise by default. A field goes on where it was saved: the same
        arguments then give what one run to the end would have given. ``params.iterations`` counts
        those that the field has. Coordinates begin anew.
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
    with using_threads(threads):
        session = texture_session(
            images, size, params, seed=seed, labels=labels, shares=shares,
            source_guides=source_guides, target_guide=target_guide, start=start,
        )  # fmt: skip
        result = finish(session, images[0].ndim == 2, progress)
    if len(images) > 1 and labels is None and shares is None and target_guide is None:
        _tell_missing(result)
    return result


def texture_session(
    exemplars: Sequence[NDArray[np.uint8]],
    size: tuple[int, int],
    params: TextureParams | None = None,
    *,
    seed: int = 0,
    labels: NDArray[np.uint8] | None = None,
    shares: Sequence[float] | None = None,
    source_guides: Sequence[NDArray[np.uint8]] | None = None,
    target_guide: NDArray[np.uint8] | None = None,
    start: TextureField | NDArray[np.int32] | None = None,
) -> TextureSession:
    """The session that :func:`synthesize_texture` begins with, which explains the arguments.

    Raises
    ------
    InputError
    """
    free_band = FREE_BAND
    if shares is not None:
        labels = labels_by_shares(shares, len(exemplars), size, seed, labels)
        free_band = band_for_shares(labels)
    return TextureSession(
        exemplars, size, params, seed=seed, labels=labels, free_band=free_band,
        source_guides=source_guides, target_guide=target_guide, start=start,
    )  # fmt: skip


def finish(session: TextureSession, flat: bool, progress: Progress | None) -> TextureResult:
    """Do all iterations of a session; the image is (H, W) if it is to be ``flat``."""
    history = tuple(run(session, progress))
    image = session.image
    return TextureResult(
        image=image[:, :, 0] if flat else image,
        exemplars=session.exemplars,
        addresses=session.addresses,
        history=history,
        iterations=session.iteration,
        idle=session.idle,
    )


def run(session: TextureSession, progress: Progress | None = None) -> list[Iteration]:
    """Do all iterations of a session's parameters, or until their patience ends."""
    params, history = session.params, []
    patience = params.iterations if params.patience is None else params.patience
    while session.iteration < params.iterations and session.idle < patience:
        iteration = session.step()
        history.append(iteration)
        if progress and progress(iteration):
            break
    return history


def _tell_missing(result):
    """Note which exemplars have gone, where nothing said how much each gets."""
    exemplars = result.exemplars
    counts, _ = np.histogram(result.addresses % exemplars.plane, exemplars.bounds)
    for number, count in enumerate(counts, 1):
        if count < result.addresses.size // 100:
            note(
                f"exemplar {number} has less than 1 % of the texture; shares, labels or a guide "
                "say how much each one gets",
                level=logging.WARNING,
            )
