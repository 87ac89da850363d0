"""Pictures from NNFs: vote, look among the candidates for better patches, vote again (3.3.2).

NNFs are packed here: y << 16 | x of the patch's centre, as
:func:`~stylit_ref.realtime.formulae.packed_nnf.entries_of` packs them.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.replaced import Passes
from stylit_ref.machine.vector_patch import STYLE_LANES, row_lanes
from stylit_ref.realtime.passes.border import make_extend
from stylit_ref.realtime.passes.image import Image, interior, make_image, whole
from stylit_ref.views.interpolation import passes


class Style(NamedTuple):
    """A style, as the passes read it.

    Attributes
    ----------
    image : Image
        4 bytes a pixel, without a border.
    channels : int
    patch_width : int
    """

    image: Image
    channels: int
    patch_width: int


def make_style(style: NDArray[np.uint8], patch_width: int) -> Style:
    """A style for the passes.

    Parameters
    ----------
    style : (H_A, W_A, n) uint8
        Of at most 4 channels.
    patch_width : int
        Odd, at most 15.
    """
    height, width, channels = style.shape
    image = make_image(height, width, 0, STYLE_LANES)
    interior(image, STYLE_LANES)[:, :, :channels] = style
    return Style(image, channels, patch_width)


def vote(style: Style, nnf: NDArray[np.int32], using: Passes = passes) -> Image:
    """The mean of the patches over each pixel.

    Parameters
    ----------
    style : Style
    nnf : (H, W) int32
    using : module, optional
        The passes, or others that do the same.

    Returns
    -------
    Image
        4 bytes a pixel, with the border that :func:`search_among` needs.
    """
    border = style.patch_width // 2
    picture = make_image(*nnf.shape, border, STYLE_LANES)
    words = whole(picture, STYLE_LANES).view(np.uint32)[:, :, 0]
    values, stride = style.image.values.view(np.uint32), style.image.stride
    corners = np.empty_like(nnf)
    using.find_corners(nnf, stride, border, corners)
    using.make_vote(style.patch_width)(corners, values, stride, words, border)
    return picture


def search_among(
    style: Style,
    nnf: NDArray[np.int32],
    candidates: NDArray[np.int32],
    picture: Image,
    using: Passes = passes,
) -> NDArray[np.int32]:
    """The limited search: of the chosen patch and the candidates the one most like the picture.

    Parameters
    ----------
    style : Style
    nnf : (H, W) int32
        The chosen patches.
    candidates : (K, H, W) int32
        Shifted NNFs, -1 where they are masked.
    picture : Image
        Of :func:`vote`; its border is filled.
    using : module, optional
        The passes, or others that do the same.

    Returns
    -------
    (H, W) int32
    """
    make_extend(STYLE_LANES)(picture)
    weights = np.zeros(row_lanes(style.patch_width, STYLE_LANES), np.int16)
    weights[: style.patch_width * STYLE_LANES] = 1
    found = np.empty_like(nnf)
    using.make_limited_search(style.patch_width)(
        nnf, candidates, style.image, picture, weights, found
    )
    return found


def pixels_of(picture: Image, channels: int) -> NDArray[np.uint8]:
    """The pixels of a voted picture, (H, W, n) uint8."""
    return np.ascontiguousarray(interior(picture, STYLE_LANES)[:, :, :channels])
