"""Principal components of the buffers of any scene, in integers.

The axes come from the source once, in floating point, and are rounded: another processor could
round them otherwise, so they are an input of everything after. A frame is projected in integers.

IDMASK stays apart. Its colours become labels: the number of a colour among the source's, from 1; 0
is a colour that the source does not have. One scale serves all components, since distances are to
be kept, and the widest component fits 8 bits; with the colours of IDMASK, which are far apart, the
others would have fewer steps.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Self

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.unaligned import make_load, make_store
from stylit_ref.machine.vector_products import ROWS, make_products
from stylit_ref.realtime.packing.buffers import check_buffers, check_out

COMPONENTS = ROWS
SHIFT = 14
"""A weight of 1 is ``1 << SHIFT``."""

ID = "IDMASK"
LARGEST_CHANNELS = 32
_LARGEST_LABEL = 255

_load_8, _load_16 = make_load(8), make_load(16)
_store_8, _store_16, _store_64 = make_store(8), make_store(16), make_store(64)


@dataclass(frozen=True, eq=False)
class PrincipalPacking:
    """Eight principal components of a source's buffers.

    A component is ``clip((axis @ pixel + offset) >> 14, 0, 255)``; the offset holds the half that
    rounds. Pixels of a target beyond the source's range are clipped.

    Attributes
    ----------
    buffers : tuple of (str, int)
        Names and channels of the buffers, without IDMASK, in the order of the axes' columns.
    axes : (8, n) int16
        A weight of 1 is 16384. Components that the source does not have are 0.
    offsets : (8,) int32
    colours : (k,) uint32
        The colours of the source's IDMASK, ``red + 256 green + 65536 blue``, ascending.
    """

    buffers: tuple[tuple[str, int], ...]
    axes: NDArray[np.int16]
    offsets: NDArray[np.int32]
    colours: NDArray[np.uint32]

    @classmethod
    def of_source(cls, buffers: Mapping[str, NDArray[np.uint8]]) -> Self:
        """Find the axes of a source.

        Parameters
        ----------
        buffers : mapping of str to (H, W) or (H, W, 3) uint8
            IDMASK and at least one more.

        Returns
        -------
        PrincipalPacking

        Raises
        ------
        InputError
            If the buffers do not fit, IDMASK is missing or has more than 255 colours, or there are
            more than 32 channels.
        """
        names = [name for name in buffers if name != ID]
        idmask, *planes = check_buffers(buffers, [ID, *names], [ID])
        channels = sum(plane.shape[2] for plane in planes)
        if not 1 <= channels <= LARGEST_CHANNELS:
            raise InputError(
                f"have {channels} channels beside {ID}; give 1 to {LARGEST_CHANNELS}",
                parameter="buffers",
            )
        colours = np.unique(colour_codes(idmask))
        if len(colours) > _LARGEST_LABEL:
            raise InputError(
                f"have {len(colours)} colours in {ID}; give each thing one colour, at most "
                f"{_LARGEST_LABEL} of them",
                parameter="buffers",
            )
        pixels = np.concatenate([plane.reshape(-1, plane.shape[2]) for plane in planes], axis=1)
        axes, offsets = principal_axes(pixels)
        sizes = (plane.shape[2] for plane in planes)
        return cls(tuple(zip(names, sizes, strict=True)), axes, offsets, colours)

    @property
    def names(self) -> tuple[str, ...]:
        """The buffers that it reads."""
        return (ID, *(name for name, _ in self.buffers))

    @property
    def channels(self) -> tuple[str, ...]:
        """All bytes of a pixel belong to ``PRINCIPAL``."""
        return ("PRINCIPAL",) * COMPONENTS

    def pack_into(
        self,
        buffers: Mapping[str, NDArray[np.uint8]],
        out: NDArray[np.uint8],
        labels: NDArray[np.uint8] | None = None,
    ) -> None:
        """Project a frame, and write its labels if they are asked for.

        Parameters
        ----------
        buffers : mapping of str to (H, W) or (H, W, 3) uint8
            ``names``, each with as many channels as the source's.
        out : (H, W, 8) uint8
            Any strides, as long as the bytes of a pixel are side by side.
        labels : (H, W) uint8, optional

        Raises
        ------
        InputError
            If an array is missing, is not read or does not fit.
        """
        idmask, *planes = check_buffers(buffers, self.names, [ID])
        for (name, channels), plane in zip(self.buffers, planes, strict=True):
            if plane.shape[2] != channels:
                raise InputError(
                    f"have {plane.shape[2]} channels in {name}; the source has {channels} there",
                    parameter="buffers",
                )
        labels = check_out(out, labels, idmask.shape[:2], COMPONENTS)
        projection = make_projection(len(self._pairs))
        projection(tuple(planes), self._pairs, self.offsets, out)
        if labels.size:
            number_colours(idmask, self.colours, labels)

    @cached_property
    def _pairs(self) -> NDArray[np.int16]:
        """The axes as the kernel reads them: (pairs, 8, 2), a power of two of them."""
        channels = self.axes.shape[1]
        pairs = 1 << max(-(-channels // 2) - 1, 0).bit_length()
        padded = np.zeros((COMPONENTS, 2 * pairs), np.int16)
        padded[:, :channels] = self.axes
        return np.ascontiguousarray(padded.reshape(COMPONENTS, pairs, 2).transpose(1, 0, 2))


def principal_axes(pixels: NDArray[np.uint8]) -> tuple[NDArray[np.int16], NDArray[np.int32]]:
    """Axes and offsets of :class:`PrincipalPacking`, rounded half up.

    The sign of an axis is fixed: its largest weight is positive, the first of several such.

    Parameters
    ----------
    pixels : (N, n) uint8

    Returns
    -------
    axes : (8, n) int16
    offsets : (8,) int32
        The middle of the source's range becomes 127.5.
    """
    values = pixels.astype(np.float64)
    centred = values - values.mean(axis=0)
    spread, vectors = np.linalg.eigh(centred.T @ centred / len(values))
    axes = vectors.T[::-1][:COMPONENTS]
    axes = axes[spread[::-1][:COMPONENTS] > _LEAST_VARIANCE]
    largest = np.take_along_axis(axes, np.abs(axes).round(6).argmax(axis=1)[:, None], axis=1)
    axes = axes * np.sign(largest)
    projected = values @ axes.T
    low, high = projected.min(axis=0, initial=np.inf), projected.max(axis=0, initial=-np.inf)
    scale = min(1.0, 255 / max((high - low).max(initial=0), 1e-9))
    one = 1 << SHIFT
    rounded = np.zeros((COMPONENTS, pixels.shape[1]), np.int16)
    rounded[: len(axes)] = np.floor(axes * scale * one + 0.5).clip(-one, one)
    offsets = np.full(COMPONENTS, 128 * one, np.int32)
    middle = (127.5 - scale * (low + high) / 2) * one
    offsets[: len(axes)] = np.floor(middle + one / 2 + 0.5)
    return rounded, offsets


_LEAST_VARIANCE = 1 / 12
"""That of rounding to 8 bits: what varies less is not there."""


def colour_codes(idmask: NDArray[np.uint8]) -> NDArray[np.uint32]:
    """A number for each colour, ``red + 256 green + 65536 blue``."""
    return idmask.astype(np.uint32) @ np.array([1, 1 << 8, 1 << 16], np.uint32)


@kernel()
def number_colours(
    idmask: NDArray[np.uint8], colours: NDArray[np.uint32], labels: NDArray[np.uint8]
) -> None:
    """Write the labels of a frame: where its colours are among the source's, from 1, or 0.

    Parameters
    ----------
    idmask : (H, W, 3) uint8
    colours : (k,) uint32
        Ascending.
    labels : (H, W) uint8
        Written.
    """
    height, width = labels.shape
    for y in prange(height):
        last, label = -1, 0
        for x in range(width):
            colour = idmask[y, x, 0] | idmask[y, x, 1] << 8 | idmask[y, x, 2] << 16
            if colour != last:  # things are larger than a pixel
                at = np.searchsorted(colours, np.uint32(colour))
                label = at + 1 if at < len(colours) and colours[at] == colour else 0
                last = colour
            labels[y, x] = label


@lru_cache
def make_projection(pairs: int) -> Callable[..., None]:
    """Build the kernel for pixels of up to ``2 * pairs`` bytes."""
    products = make_products(pairs)
    step = 2 * pairs

    @kernel(pairs)
    def project(planes, matrix, offsets, out):
        """Write the components of each pixel."""
        height, width = out.shape[:2]
        row_bytes, pixel_bytes = out.strides[:2]
        for y in prange(height):
            row = np.zeros(width * step, np.uint8)
            column = 0
            for number in range(len(planes)):
                plane = planes[number]
                channels = plane.shape[2]
                to = column
                for at in range(channels * y * width, channels * (y + 1) * width, channels):
                    if channels == 3:
                        _store_16(row, to, _load_16(plane, at))
                    _store_8(row, to + channels - 1, _load_8(plane, at + channels - 1))
                    to += step
                column += channels
            to = y * row_bytes
            for x in range(width):
                _store_64(out, to, products(row, x * step, matrix, offsets, SHIFT))
                to += pixel_bytes

    return project
