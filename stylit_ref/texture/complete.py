"""Fill holes of an image, and make an image tile (section 8, "Texture completion")."""

from collections.abc import Sequence
from numbers import Integral

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError, shown
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.randomness.random_stream import WHITE_NOISE, random_stream
from stylit_ref.texture.exemplars import make_exemplars, with_channels
from stylit_ref.texture.params import TextureParams, as_texture_params
from stylit_ref.texture.passes.white_noise import white_noise
from stylit_ref.texture.session import TextureSession
from stylit_ref.texture.synthesize import Progress, TextureResult, finish, run

VOID = np.zeros((6, 1, 3), np.uint8)
VOID[:3], VOID[3:] = (255, 0, 255), (0, 255, 0)
"""What holes begin with: of all seams, those between these colours cost most.

The paper wants an infinite cost there, and has random coordinates for it. In a picture of little
contrast some of them cost so little that no patch ever replaces them.
"""

_IN_VOID = 1, 4
"""Rows of its colours whose neighbours have the same."""


def complete_texture(
    image: NDArray[np.uint8],
    hole: NDArray[np.bool_],
    params: TextureParams | None = None,
    *,
    exemplars: Sequence[NDArray[np.uint8]] = (),
    unlocked: bool = False,
    wraps: bool = False,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> TextureResult:
    """Fill the holes of an image with patches of what is known.

    The same arguments give the same bytes, whatever the number of threads.

    Parameters
    ----------
    image : (H, W) or (H, W, c) uint8
        1 or 3 channels. What it has in the holes is of no account.
    hole : (H, W) bool
        True where a pixel is to be filled.
    params : TextureParams, optional
        By default :attr:`TextureParams.preset("complete")`.
    exemplars : sequence of (H, W) or (H, W, c) uint8
        Images to fill the holes from, with the image's channels; by default its own known pixels.
    unlocked : bool
        The paper's way: known pixels may change, too, which hides seams better.
    wraps : bool
        Whether the image shall tile across its borders.
    seed : int
        From 0 to 2**64 - 1.
    threads : int, optional
        Threads to use; by default all.
    progress : callable, optional
        Called with an :class:`Iteration` after each; synthesis ends early where it returns True.

    Returns
    -------
    TextureResult
        The image is number 0 among its exemplars.

    Raises
    ------
    InputError
        If arrays or parameters do not fit together; the message names the sizes.
    """
    from scipy.ndimage import distance_transform_edt  # imported late: SciPy takes long to load

    picture, hole = with_channels(image, "the image"), as_array(hole, "hole")
    others = [with_channels(given, f"exemplar {k}") for k, given in enumerate(exemplars, 1)]
    for k, other in enumerate(others, 1):
        if other.shape[2] != picture.shape[2]:
            raise InputError(
                f"exemplar {k} and the image have {other.shape[2]} and {picture.shape[2]} channels;"
                " make both grey, or both in colour"
            )
    if hole.shape != picture.shape[:2] or hole.dtype != np.bool_:
        raise InputError(
            f"is {hole.dtype} of the shape {hole.shape}; it must be bool of the image's shape "
            f"{picture.shape[:2]}",
            parameter="hole",
        )
    if hole.all():
        raise InputError("covers the whole image; leave some pixels known", parameter="hole")
    # A seam beside the hole looks at the pixel that would follow there: the nearest known one.
    nearest = distance_transform_edt(hole, return_distances=False, return_indices=True)
    images = [picture[tuple(nearest)], *others]
    known = [np.zeros_like(hole) if others else ~hole, *[None] * len(others)]
    # In colour, since no grey is far from all greys.
    coloured = [np.broadcast_to(each, (*each.shape[:2], 3)) for each in images]
    with using_threads(threads):
        session = TextureSession(
            [*coloured, VOID], hole.shape, _params(params), seed=seed,
            known=[*known, np.zeros(VOID.shape[:2], np.bool_)],
            start=_with_void(hole, len(images)),
            lock=None if unlocked else ~hole, wraps=wraps,
        )  # fmt: skip
        history = tuple(run(session, progress))
    coordinates = session.coordinates
    void = coordinates[..., 0] == len(images)
    coordinates[void] = _noise(images, known, hole.shape, seed)[void]
    exemplars = make_exemplars(images, 1, fractions=session.exemplars.fractions)
    addresses = exemplars.addresses(coordinates)
    shown = exemplars.show(addresses)
    return TextureResult(
        image=shown[:, :, 0] if np.ndim(image) == 2 else shown,
        exemplars=exemplars,
        addresses=addresses,
        history=history,
        iterations=session.iteration,
        idle=session.idle,
    )


def make_tileable(
    image: NDArray[np.uint8],
    band: int,
    params: TextureParams | None = None,
    *,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> TextureResult:
    """Change an image near its borders so that it tiles.

    The same arguments give the same bytes, whatever the number of threads.

    Parameters
    ----------
    image : (H, W) or (H, W, c) uint8
        1 or 3 channels.
    band : int
        Pixels this far from the border or farther stay as they are.
    params : TextureParams, optional
        By default :attr:`TextureParams.preset("complete")`.
    seed, threads, progress
        As of :func:`complete_texture`.

    Returns
    -------
    TextureResult

    Raises
    ------
    InputError
        If the band leaves no pixel alone, or arrays or parameters do not fit together.
    """
    picture = with_channels(image, "the image")
    height, width = picture.shape[:2]
    most = (min(height, width) - 1) // 2
    if most < 1:
        raise InputError(
            f"the picture has {width} x {height} pixels; it needs at least 3 x 3, so that some "
            "stay as they are between the borders"
        )
    if not isinstance(band, Integral) or not 1 <= band <= most:
        raise InputError(
            f"is {shown(band)}; for {width} x {height} pixels it must be an integer from 1 to "
            f"{most}",
            parameter="band",
        )
    inside = np.zeros((height, width), np.bool_)
    inside[band : height - band, band : width - band] = True
    with using_threads(threads):
        session = TextureSession(
            [picture], (height, width), _params(params), seed=seed, start=_identity(height, width),
            lock=inside,
        )  # fmt: skip
        return finish(session, np.ndim(image) == 2, progress)


def _params(params):
    return TextureParams.preset("complete") if params is None else as_texture_params(params)


def _identity(height, width):
    """Coordinates with which an image shows itself."""
    y, x = np.indices((height, width), np.int32) * 4
    return np.stack([np.zeros_like(y), y, x], axis=-1)


def _with_void(hole, number):
    """The image itself, and in its holes the two colours of exemplar ``number`` in turn."""
    start = _identity(*hole.shape)
    start[hole, 0] = number
    start[hole, 1] = np.where(np.indices(hole.shape).sum(axis=0)[hole] % 2, *_IN_VOID) * 4
    start[hole, 2] = 0
    return start


def _noise(images, known, size, seed):
    """Coordinates drawn from all pixels that may be copied: what is left where no patch came."""
    sources = []
    for number, (image, mask) in enumerate(zip(images, known, strict=True)):
        own = _identity(*image.shape[:2])
        own[..., 0] = number
        sources.append(own.reshape(-1, 3) if mask is None else own[mask])
    sources = np.concatenate(sources)
    chosen = np.empty(size, np.int32)
    white_noise(chosen, np.arange(len(sources), dtype=np.int32), random_stream(seed, WHITE_NOISE))
    return sources[chosen]
