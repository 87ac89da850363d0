"""The thesis' packing for a red object on a white stage (Heidrich 2017, 4.2.2, Figure 16).

=========  ================================  ===========================================
FULL       red and green                     green and blue are alike on a red object and
LDE        red and green                     on a white stage
LDDE       red and green
LSE        red                               a highlight is white
IDMASK     0, 128, 255                       background, cast shadow, foreground
FRESNEL    as it is
LIGHTMASK  0, 128, 255                       shadow, lit, highlight
=========  ================================  ===========================================

The cast shadow is what LIGHTMASK calls shadow (blue) outside the foreground (the red of IDMASK).
Masks are cut at 128. The intensities of the masks are not printed; these are chosen, evenly spaced.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.unaligned import make_load, make_store
from stylit_ref.realtime.packing.buffers import check_buffers, check_out

BACKGROUND, CAST_SHADOW, FOREGROUND = 0, 1, 2
"""The labels of the stage."""

STAGE_BUFFERS = "FULL", "LDE", "LDDE", "LSE", "IDMASK", "FRESNEL", "LIGHTMASK"
"""LPE+ of the thesis (4.1.3)."""

COLOURED = "IDMASK", "LIGHTMASK"

_load_8, _load_16 = make_load(8), make_load(16)
_store_8, _store_16, _store_64 = make_store(8), make_store(16), make_store(64)
_U = np.uint64


@dataclass(frozen=True)
class StagePacking:
    """Ten bytes of the stage's 21.

    Attributes
    ----------
    names : tuple of str
    channels : tuple of str
    """

    names: ClassVar[tuple[str, ...]] = STAGE_BUFFERS
    channels: ClassVar[tuple[str, ...]] = (
        "FULL", "FULL", "LDE", "LDE", "LDDE", "LDDE", "LSE", "IDMASK", "FRESNEL", "LIGHTMASK",
    )  # fmt: skip

    def pack_into(
        self,
        buffers: Mapping[str, NDArray[np.uint8]],
        out: NDArray[np.uint8],
        labels: NDArray[np.uint8] | None = None,
    ) -> None:
        """Write a frame's bytes, and its labels if they are asked for.

        Parameters
        ----------
        buffers : mapping of str to (H, W) or (H, W, 3) uint8
            ``names``; a buffer of one channel is grey.
        out : (H, W, 10) uint8
            Any strides, as long as the bytes of a pixel are side by side.
        labels : (H, W) uint8, optional

        Raises
        ------
        InputError
            If an array is missing, is not read or does not fit.
        """
        planes = check_buffers(buffers, self.names, COLOURED)
        labels = check_out(out, labels, planes[0].shape[:2], len(self.channels))
        _pack_stage(*planes, out, labels)


@njit(inline="always")
def stage_label(foreground: int, shadow: int) -> int:
    """The label of a pixel, from one bit of each mask (uint64)."""
    return (foreground << _U(1)) | (shadow & (foreground ^ _U(1)))


@njit(inline="always")
def _two(plane, at, channels):
    """Red and green in two bytes; grey twice."""
    if channels == 3:
        return _load_16(plane, at)
    return _load_8(plane, at) * _U(257)


@inlined
def _pack_row(y, f, d, i, s, n, full, lde, ldde, lse, idmask, fresnel, lightmask, out, labels):
    """Pack a row of buffers of ``f``, ``d``, ``i``, ``s`` and ``n`` channels."""
    width = out.shape[1]
    row_bytes, pixel_bytes = out.strides[:2]
    to = y * row_bytes
    for at in range(y * width, (y + 1) * width):
        highlight = _load_8(lightmask, 3 * at) >> _U(7)
        shadow = _load_8(lightmask, 3 * at + 2) >> _U(7)
        label = stage_label(_load_8(idmask, 3 * at) >> _U(7), shadow)
        # Few wide stores: ten of a byte each take twice as long.
        light = _two(full, f * at, f) | (_two(lde, d * at, d) << _U(16))
        light |= (_two(ldde, i * at, i) << _U(32)) | (_load_8(lse, s * at) << _U(48))
        identity = (label << _U(7)) - (label >> _U(1))
        _store_64(out, to, light | (identity << _U(56)))
        lit = highlight * _U(127) + (highlight | (shadow ^ _U(1))) * _U(128)
        _store_16(out, to + 8, _load_8(fresnel, n * at) | (lit << _U(8)))
        if labels.size:
            _store_8(labels, at, label)
        to += pixel_bytes


@kernel()
def _pack_stage(full, lde, ldde, lse, idmask, fresnel, lightmask, out, labels):
    f, d, i, s, n = full.shape[2], lde.shape[2], ldde.shape[2], lse.shape[2], fresnel.shape[2]
    planes = full, lde, ldde, lse, idmask, fresnel, lightmask
    coloured = f == 3 and d == 3 and i == 3 and s == 3
    for y in prange(out.shape[0]):
        if coloured:  # the usual case, faster with constants
            _pack_row(np.int64(y), 3, 3, 3, 3, n, *planes, out, labels)
        else:
            _pack_row(np.int64(y), f, d, i, s, n, *planes, out, labels)
