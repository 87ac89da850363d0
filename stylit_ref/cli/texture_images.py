"""Images that ``texture`` reads, brought to the same channels."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.colour.bit_depth import to_depth
from stylit_ref.files.picture import Picture, read_picture
from stylit_ref.files.read_image import displayed
from stylit_ref.notes import note
from stylit_ref.texture.params import TextureParams


class Source(NamedTuple):
    """An image as the synthesis sees it, and as its file has it.

    Attributes
    ----------
    colours : (H, W, c) uint8
        1 or 3 channels, without alpha.
    pixels : (H, W, n) uint8, uint16 or float32
    has_alpha : bool
        Whether the last channel of ``pixels`` is alpha.
    """

    colours: NDArray[np.uint8]
    pixels: NDArray[np.uint8 | np.uint16 | np.float32]
    has_alpha: bool

    @property
    def is_deep(self) -> bool:
        """Whether the file has more than the synthesis sees."""
        return self.has_alpha or self.pixels.dtype != np.uint8


def read_sources(paths: Sequence[str]) -> list[Source]:
    """Read images; grey ones get three channels beside others in colour.

    They get the same depth, the deepest of theirs, and an opaque alpha where others have one.

    Raises
    ------
    InputError
        If one cannot be read, or has neither 1 nor 3 channels beside alpha.
    """
    sources = []
    for path in paths:
        picture = read_picture(path)
        colours = _colours(path, picture)
        _tell_transparent(path, picture)
        sources.append(Source(colours, picture.pixels, picture.alpha_channel is not None))
    deepest = max((source.pixels.dtype for source in sources), key=lambda dtype: dtype.itemsize)
    channels = max(source.colours.shape[2] for source in sources)
    has_alpha = any(source.has_alpha for source in sources)
    return [_alike(source, deepest, channels, has_alpha) for source in sources]


def fitted_to(params: TextureParams, sources: Sequence[Source]) -> TextureParams:
    """Parameters with the radius of a preset, or the largest that fits the smallest source."""
    height, width = min((source.colours.shape[:2] for source in sources), key=min)
    fits = 2 * ((min(height, width) + 1) // 2) - 1
    if params.radius <= fits:
        return params
    note(
        f"is {params.radius}, but {fits} is used: an exemplar has {width} x {height} pixels",
        parameter="radius",
    )
    return replace(params, radius=fits, radius_end=min(params.radius_end, fits))


def read_colours(path: str) -> NDArray[np.uint8]:
    """Read an image as (H, W, 1) or (H, W, 3) uint8, without alpha.

    Raises
    ------
    InputError
    """
    return _colours(path, read_picture(path))


def read_labels(
    path: str, exemplars: Sequence[str], size: tuple[int, int] | None
) -> NDArray[np.uint8]:
    """Read a map of labels: one colour for each exemplar, in the order of their values.

    Parameters
    ----------
    path : str
    exemplars : sequence of str
        The exemplars' files.
    size : tuple of int or None
        Height and width that the map must have.

    Returns
    -------
    (H, W) uint8
        From 1.

    Raises
    ------
    InputError
        If it has another size, or not as many colours as there are exemplars.
    """
    shown = read_colours(path)
    if size not in (None, shown.shape[:2]):
        raise InputError(
            f"{path}: has {shown.shape[1]} x {shown.shape[0]} pixels, and --size is {size[1]} x "
            f"{size[0]}; leave --size out, or make them the same"
        )
    packed = np.zeros(shown.shape[:2], np.int32)
    for channel in np.moveaxis(shown, -1, 0):
        packed = packed << 8 | channel
    found, labels = np.unique(packed, return_inverse=True)
    if len(found) != len(exemplars):
        raise InputError(
            f"{path}: has {len(found)} colours, and --exemplar was given {len(exemplars)} times; "
            "give one for each colour, in the order of their values, and a map whose colours do "
            "not blend (no JPEG)"
        )
    colours = [
        ",".join(str(int(colour) >> (8 * k) & 255) for k in reversed(range(shown.shape[2])))
        for colour in found
    ]
    told = "; ".join(f"{colour} is {name}" for colour, name in zip(colours, exemplars, strict=True))
    note(f"{path}: colour {told}")
    return (labels.reshape(packed.shape) + 1).astype(np.uint8)


def _colours(path, picture: Picture):
    shown = displayed(path, picture)[:, :, : picture.alpha_channel]
    if shown.shape[2] not in (1, 3):
        raise InputError(
            f"{path}: has {shown.shape[2]} channels; it must be grey or have red, green and blue"
        )
    return np.ascontiguousarray(shown)


def _tell_transparent(path, picture):
    if picture.alpha_channel is None:
        return
    alpha = picture.pixels[:, :, picture.alpha_channel]
    share = np.mean(alpha < (1 if alpha.dtype == np.float32 else np.iinfo(alpha.dtype).max))
    told = f"{share:.0%}" if share >= 0.01 else "less than 1%"
    note(f"{path}: {told} of its pixels are transparent; they are matched as if on black")


def _alike(source, dtype: "np.dtype[Any]", channels, has_alpha):
    colours, pixels = source.colours, to_depth(source.pixels, dtype)
    if colours.shape[2] < channels:
        colours = np.repeat(colours, 3, axis=2)
        pixels = np.concatenate([pixels[:, :, :1].repeat(3, axis=2), pixels[:, :, 1:]], axis=2)
    if has_alpha and not source.has_alpha:
        opaque = 1 if dtype == np.float32 else np.iinfo(dtype).max
        pixels = np.concatenate([pixels, np.full_like(pixels[:, :, :1], opaque)], axis=2)
    return Source(colours, pixels, has_alpha)
