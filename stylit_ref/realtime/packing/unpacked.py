"""The stage's buffers as the thesis has them before its packing: 21 bytes of a pixel."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.kernel import kernel
from stylit_ref.realtime.packing.buffers import check_buffers, check_out
from stylit_ref.realtime.packing.stage import COLOURED, STAGE_BUFFERS, stage_label


@dataclass(frozen=True)
class UnpackedStage:
    """Three bytes of each buffer; IDMASK is red, green, blue: foreground, background, cast shadow.

    What the packing saves is measured against this.

    Attributes
    ----------
    names : tuple of str
    channels : tuple of str
    """

    names: ClassVar[tuple[str, ...]] = STAGE_BUFFERS
    channels: ClassVar[tuple[str, ...]] = tuple(name for name in STAGE_BUFFERS for _ in "RGB")

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
        out : (H, W, 21) uint8
            Any strides, as long as the bytes of a pixel are side by side.
        labels : (H, W) uint8, optional

        Raises
        ------
        InputError
            If an array is missing, is not read or does not fit.
        """
        planes = dict(zip(self.names, check_buffers(buffers, self.names, COLOURED), strict=True))
        size = planes["FULL"].shape[:2]
        labels = check_out(out, labels, size, len(self.channels))
        for number, (name, plane) in enumerate(planes.items()):
            pixel = out[:, :, 3 * number : 3 * number + 3]
            if name == "IDMASK":
                _identities(plane, planes["LIGHTMASK"], pixel, labels)
            else:
                _copy(plane, pixel)


@kernel()
def _copy(plane, out):
    channels = plane.shape[2]
    for y in prange(out.shape[0]):
        for x in range(out.shape[1]):
            for c in range(3):
                out[y, x, c] = plane[y, x, min(c, channels - 1)]


@kernel()
def _identities(idmask, lightmask, out, labels):
    for y in prange(out.shape[0]):
        for x in range(out.shape[1]):
            foreground = np.uint64(idmask[y, x, 0] >> 7)
            label = stage_label(foreground, np.uint64(lightmask[y, x, 2] >> 7))
            for c, wanted in enumerate((2, 0, 1)):
                out[y, x, c] = 255 if label == wanted else 0
            if labels.size:
                labels[y, x] = label
