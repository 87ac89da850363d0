"""Look at the guides of a whole sequence before it is stylized, one picture at a time."""

from collections.abc import Sequence
from pathlib import Path
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.guides.choose_encoding import GuideValues, encoding_of, values_of
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.guides.read_guides import with_channels
from stylit_ref.files.guides.remarks import GuideRemarks
from stylit_ref.files.picture import plain_layer, read_picture

_DISPLAYED = {"uint8"}, {"uint16"}
"""Types of display values, which every encoding leaves as they are."""


class GuideLook(NamedTuple):
    """What counts of a guide's picture before it is used.

    Attributes
    ----------
    size : tuple of 2 int
        Rows and columns.
    colours : int
        Channels but for alpha.
    has_alpha : bool
    values : GuideValues
    """

    size: tuple[int, int]
    colours: int
    has_alpha: bool
    values: GuideValues


def look_at(path: str | Path, *, needs_values: bool) -> GuideLook:
    """Look at a picture, of which nothing stays in memory.

    Parameters
    ----------
    path : str or Path
        As of :func:`stylit_ref.read_guides`.
    needs_values : bool
        Whether floating-point values count. Of what is without them and without alpha, the header
        alone is read.

    Returns
    -------
    GuideLook

    Raises
    ------
    InputError
        If it cannot be read.
    """
    layer = plain_layer(path)
    if layer is None or (needs_values and set(layer.types) not in _DISPLAYED):
        picture = read_picture(path, is_guide=True)
        return GuideLook(
            picture.pixels.shape[:2],
            picture.colours.shape[2],
            picture.alpha_channel is not None,
            values_of(picture),
        )
    values = GuideValues(False, layer.is_light, False, 0.0, 1.0, None)
    return GuideLook(layer.size, len(layer.roles), False, values)


def read_source_guide(
    source: str | Path,
    first: str | Path,
    looks: Sequence[GuideLook],
    guide_encoding: Literal["auto", "none"] | GuideEncoding,
    remarks: GuideRemarks,
) -> tuple[NDArray[np.uint8], GuideEncoding]:
    """Read a guide of the source as :func:`stylit_ref.read_guides` would beside all frames.

    Parameters
    ----------
    source, first : str or Path
        The guide, and that of the first frame.
    looks : sequence of GuideLook
        At the source's and at those of all frames.
    guide_encoding : {"auto", "none"} or GuideEncoding
    remarks : GuideRemarks
        Is told of the two files.

    Returns
    -------
    guide : (H_A, W_A, c) uint8
        With as many channels as any of the looks found.
    encoding : GuideEncoding
        For the guide in all frames.

    Raises
    ------
    InputError
        If the source cannot be read, or the encoding does not suit it.
    """
    if guide_encoding == "auto":
        encoding = encoding_of([look.values for look in looks])
    elif guide_encoding == "none":
        encoding = GuideEncoding("light" if all(look.values.is_light for look in looks) else "data")
    else:
        encoding = guide_encoding
    pictures = [read_picture(path, is_guide=True) for path in (source, first)]
    encoded = [encoding.encode(picture) for picture in pictures]
    remarks.add([source, first], pictures, encoded, encoding)
    colours = 3 if encoding.kind == "labels" else max(look.colours for look in looks)
    has_alpha = pictures[0].alpha_channel is not None
    wants_alpha = any(look.has_alpha for look in looks)
    guide = with_channels(encoded[0], has_alpha=has_alpha, colours=colours, wants_alpha=wants_alpha)
    return guide, encoding
