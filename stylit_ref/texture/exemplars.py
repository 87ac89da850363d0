"""Exemplars laid out for the kernels: an address is a pixel of one of them, or a point between."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.files.texture_field import TextureField
from stylit_ref.texture.formulae.deformation import PHASES
from stylit_ref.texture.formulae.polar import MARGIN

LARGEST_ADDRESS = (1 << 31) - 1


@dataclass(frozen=True)
class Exemplars:
    """Images one below the other in one plane, with a border around each; and planes between.

    An address is an index into :attr:`colours`. Its neighbours to the right and below are 1 and
    :attr:`stride` further. The first plane holds the images; with fractions there are 15 more,
    which hold the colours at quarters of a pixel, bilinearly interpolated and rounded half up.

    Attributes
    ----------
    images : tuple of (H, W, c) uint8
        1 or 3 channels, all alike.
    border : int
        Pixels around each image, which repeat its edge. No patch is taken from there.
    fractions : bool
    colours : (planes * plane,) int32
        Packed colours: the first channel in the low byte.
    clearance : (rows, stride) uint16
        How far each pixel of the plane is from the nearest that is of no image or not known, in
        whole pixels; 0 for such a pixel itself.
    """

    images: tuple[NDArray[np.uint8], ...]
    border: int
    fractions: bool
    colours: NDArray[np.int32]
    clearance: NDArray[np.uint16]

    @property
    def largest_radius(self) -> int:
        """The largest radius of a patch whose window stays within the plane."""
        return 2 * (self.border - MARGIN - 2)

    @property
    def stride(self) -> int:
        """Pixels in a row of the plane."""
        return self.clearance.shape[1]

    @property
    def plane(self) -> int:
        """Pixels in a plane."""
        return self.clearance.size

    @cached_property
    def first_rows(self) -> tuple[int, ...]:
        """The row of the plane in which each image begins."""
        heights = [0] + [image.shape[0] + 2 * self.border for image in self.images]
        return tuple(int(row) + self.border for row in np.cumsum(heights)[:-1])

    @cached_property
    def bounds(self) -> NDArray[np.int64]:
        """The first address of each image with its border, and the end of the plane."""
        rows = np.asarray(self.first_rows) - self.border
        return np.append(rows * self.stride, self.plane).astype(np.int64)

    def centres(self, radius: int) -> NDArray[np.int32]:
        """Addresses where the centre of a patch may lie: more than R / 2 inside.

        Raises
        ------
        InputError
            If an exemplar has known pixels and none of them is one.
        """
        for image, (first, beyond) in zip(self.images, pairwise(self.bounds), strict=True):
            clearance = int(self.clearance.ravel()[first:beyond].max())
            if clearance and 2 * clearance <= radius:
                height, width = image.shape[:2]
                raise InputError(
                    f"is {radius}, too large for the exemplar of {width} x {height} pixels; "
                    f"{2 * clearance - 1} is the largest that fits, since patches keep half of it "
                    "away from borders and unknown pixels",
                    parameter="radius",
                )
        centres = np.flatnonzero(2 * self.clearance.astype(np.int32) > radius).astype(np.int32)
        if not centres.size:
            raise InputError("no pixel of the exemplars is known")
        return centres

    def addresses(self, coordinates: NDArray[np.int32]) -> NDArray[np.int32]:
        """Turn coordinates into addresses.

        Parameters
        ----------
        coordinates : (..., 3) int32
            Number of the exemplar, and y and x in quarters of a pixel.
        """
        index, y, x = np.moveaxis(coordinates.astype(np.int64), -1, 0)
        rows = np.asarray(self.first_rows)[index]
        if not self.fractions:
            y, x = (y + 2) & ~3, (x + 2) & ~3
        phase = (y & 3) * PHASES + (x & 3)
        within = (rows + (y >> 2)) * self.stride + self.border + (x >> 2)
        return (phase * self.plane + within).astype(np.int32)

    def coordinates(self, addresses: NDArray[np.int32]) -> NDArray[np.int32]:
        """Turn addresses into (..., 3) int32 coordinates, as :meth:`addresses` takes them."""
        phase, within = np.divmod(addresses, np.int32(self.plane))
        row, column = np.divmod(within, np.int32(self.stride))
        index = np.searchsorted(np.asarray(self.first_rows) - self.border, row, side="right") - 1
        rows = np.asarray(self.first_rows, np.int32)[index]
        y = (row - rows) * PHASES + phase // PHASES
        x = (column - self.border) * PHASES + phase % PHASES
        return np.stack([index, y, x], axis=-1).astype(np.int32)

    def show(self, addresses: NDArray[np.int32]) -> NDArray[np.uint8]:
        """E[S]: the colours at addresses, with the channels of the exemplars."""
        packed = self.colours[addresses]
        channels = self.images[0].shape[2]
        return np.stack([(packed >> (8 * c)).astype(np.uint8) for c in range(channels)], axis=-1)


def make_exemplars(
    images: Sequence[NDArray[np.uint8]],
    radius: int,
    *,
    known: Sequence[NDArray[np.bool_] | None] | None = None,
    fractions: bool = True,
) -> Exemplars:
    """Lay exemplars out for patches of at most ``radius``.

    Parameters
    ----------
    images : sequence of (H, W) or (H, W, c) uint8
        1 or 3 channels, all alike; of any sizes.
    radius : int
    known : sequence of (H, W) bool or None, optional
        Which pixels of each may be copied; all by default.
    fractions : bool
        Whether addresses are needed for quarters of a pixel, as deformed patches have them.

    Raises
    ------
    InputError
        If images differ in their channels, or there are too many pixels for an address.
    """
    from scipy.ndimage import distance_transform_edt  # imported late: SciPy takes long to load

    if not images:
        raise InputError("no exemplar was given")
    pictures = [with_channels(image, f"exemplar {k}") for k, image in enumerate(images, 1)]
    channels = pictures[0].shape[2]
    for k, picture in enumerate(pictures[1:], 2):
        if picture.shape[2] != channels:
            raise InputError(
                f"exemplar {k} has {_channels(picture)}, exemplar 1 {_channels(pictures[0])}; give "
                "exemplars with the same channels"
            )
    border = radius - radius // 2 + MARGIN + 2
    stride = max(picture.shape[1] for picture in pictures) + 2 * border
    rows = sum(picture.shape[0] + 2 * border for picture in pictures)
    planes = PHASES**2 if fractions else 1
    if planes * rows * stride > LARGEST_ADDRESS:
        raise InputError(
            f"the exemplars have {rows * stride} pixels with their borders; at most "
            f"{LARGEST_ADDRESS // planes} can be addressed"
            + (", or 16 times as many with whole_pixels" if fractions else "")
        )
    valid = []
    for k, picture in enumerate(pictures):
        height, width = picture.shape[:2]
        around = ((border, border), (border, stride - border - width))
        mask = None if known is None else known[k]
        if mask is None:
            mask = np.ones((height, width), np.bool_)
        elif np.shape(mask) != (height, width):
            raise InputError(
                f"the mask of exemplar {k + 1} has the shape {np.shape(mask)}, the exemplar "
                f"{height} x {width} pixels; make it as large"
            )
        valid.append(np.pad(np.asarray(mask, np.uint8), around))
    colours = packed_planes(pictures, border, fractions)
    clearance = distance_transform_edt(np.concatenate(valid)).astype(np.uint16)
    return Exemplars(tuple(pictures), border, fractions, colours, clearance)


def make_field(
    exemplars: Exemplars, addresses: NDArray[np.int32], iterations: int, idle: int
) -> TextureField:
    """S with the sizes of its exemplars, and how many iterations were done and changed nothing."""
    sizes = [image.shape[:2] for image in exemplars.images]
    return TextureField(
        exemplars.coordinates(addresses), tuple((int(h), int(w)) for h, w in sizes), iterations,
        idle,
    )  # fmt: skip


def packed_planes(
    pictures: Sequence[NDArray[np.uint8]], border: int, fractions: bool
) -> NDArray[np.int32]:
    """The packed colours of pictures, laid out as :class:`Exemplars` says.

    Parameters
    ----------
    pictures : sequence of (H, W, c) uint8
    border : int
    fractions : bool
    """
    stride = max(picture.shape[1] for picture in pictures) + 2 * border
    bands = []
    for picture in pictures:
        right = stride - border - picture.shape[1]
        around = (border, border), (border, right), (0, 0)
        bands.append(np.pad(picture, around, mode="edge"))
    plane = np.concatenate(bands)
    if not fractions:
        return _packed(plane)
    return np.concatenate([_packed(shifted) for shifted in _shifted(plane)])


def with_channels(image: NDArray[np.uint8], what: str) -> NDArray[np.uint8]:
    """An image as (H, W, c) uint8, with 1 or 3 channels; ``what`` it is, for messages.

    Raises
    ------
    InputError
        If it is no such image.
    """
    picture = as_array(image, what)
    if picture.dtype != np.uint8 or picture.ndim not in (2, 3) or not picture.size:
        raise InputError(
            f"{what} is {picture.dtype} of the shape {picture.shape}; it must be uint8 of the "
            "shape (H, W), (H, W, 1) or (H, W, 3)"
        )
    picture = picture if picture.ndim == 3 else picture[..., None]
    if picture.shape[2] not in (1, 3):
        raise InputError(f"{what} has {_channels(picture)}; it must have 1 or 3")
    return np.ascontiguousarray(picture)


def _channels(picture):
    return "1 channel" if picture.shape[2] == 1 else f"{picture.shape[2]} channels"


def _packed(picture):
    """One channel is packed three times, so that grey costs what the same grey in colour costs."""
    first, second, third = np.moveaxis(np.broadcast_to(picture, (*picture.shape[:2], 3)), -1, 0)
    return (first | second.astype(np.int32) << 8 | third.astype(np.int32) << 16).ravel()


def _shifted(plane):
    """The plane at every quarter of a pixel, row by row: sums of sixteenths, rounded half up."""
    wide = plane.astype(np.uint16)
    right = np.concatenate([wide[:, 1:], wide[:, -1:]], axis=1)
    for y in range(PHASES):
        for x in range(PHASES):
            row = wide * (PHASES - x) + right * x
            below = np.concatenate([row[1:], row[-1:]])
            yield ((row * (PHASES - y) + below * y + 8) >> 4).astype(np.uint8)
