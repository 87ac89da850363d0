"""S, and which of its pixels may change."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stylit_ref.randomness.philox import FourWords
from stylit_ref.texture.cells import cells_on, grid_cells
from stylit_ref.texture.exemplars import Exemplars
from stylit_ref.texture.label_maps import with_free_borders
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.passes.guide_costs import guide_costs
from stylit_ref.texture.passes.layout import FREE_BELOW, FREE_RIGHT, LOCKED, Texture
from stylit_ref.texture.passes.seam_maps import seam_maps


@dataclass(frozen=True, eq=False)
class Canvas:
    """S, and which of its pixels may change.

    Attributes
    ----------
    texture : Texture
    free : (m,) int64, optional
        Numbers of the pixels that may change, ``y * width + x``; None where all may.
    has_lock : bool
        Whether a patch has to look which pixels it may not write, or not be written to.
    """

    texture: Texture
    free: NDArray[np.int64] | None
    has_lock: bool

    @property
    def size(self) -> tuple[int, int]:
        """Height and width."""
        height, width = self.texture.addresses.shape
        return height, width

    @property
    def has_labels(self) -> bool:
        """Whether pixels are for one exemplar alone."""
        return self.texture.labels.size > 1

    def cells(self, radius: int, stream: FourWords) -> NDArray[np.int64]:
        """Centres (y, x), (n, 2) int64, of the cells of an iteration (section 3)."""
        if self.free is None:
            return grid_cells(self.size, radius, stream)
        return cells_on(self.free, (self.texture.seams_x, self.texture.seams_y), radius, stream)

    def only(self, mask: NDArray[np.uint8]) -> "Canvas":
        """The same S, of which only pixels that are 1 in a mask may change.

        Parameters
        ----------
        mask : (height, width) uint8
            0 or 1; 0 where a pixel is locked.
        """
        texture = self.texture
        # A cell is offered what its pixels show, though they may come from anywhere.
        labels = texture.labels if self.has_labels else np.zeros(self.size, np.uint8)
        lock = texture.lock | (mask ^ LOCKED)
        return Canvas(texture._replace(lock=lock, labels=labels), np.flatnonzero(mask), True)

    def count(
        self,
        exemplars: Exemplars,
        params: TextureParams,
        guide_colours: NDArray[np.int32],
        guide_weight: int,
    ) -> int:
        """Count what S costs, in 1/256 of M, and write down the costs of its seams.

        Parameters
        ----------
        exemplars : Exemplars
        params : TextureParams
        guide_colours : (n,) int32
            Guides of the exemplars, laid out as they are.
        guide_weight : int
            Fixed-point; 0 without a guide.
        """
        texture = self.texture
        seam_maps(
            texture.addresses, exemplars.colours, exemplars.stride, params.eta, params.exponent,
            texture.seams_x, texture.seams_y,
        )  # fmt: skip
        texture.seams_x[texture.lock & FREE_RIGHT > 0] = 0
        texture.seams_y[texture.lock & FREE_BELOW > 0] = 0
        cost = int(texture.seams_x.sum(dtype=np.int64) + texture.seams_y.sum(dtype=np.int64))
        if guide_weight:
            costs = np.empty(self.size, np.int64)
            guide_costs(texture.addresses, guide_colours, texture.guide, guide_weight, costs)
            cost += int(costs.sum())
        return cost


def make_canvas(
    addresses: NDArray[np.int32],
    lock: NDArray[np.uint8],
    labels: NDArray[np.uint8],
    guide: NDArray[np.int32],
    *,
    free_band: int,
    wraps: bool,
) -> Canvas:
    """A canvas, the costs of whose seams are still to be counted.

    Parameters
    ----------
    addresses : (H, W) int32
    lock : (H, W) uint8
        1 where a pixel stays as it is. Changed where S does not wrap.
    labels, guide
        As :class:`stylit_ref.texture.passes.layout.Texture` holds them.
    free_band : int
        Within so many pixels of a border between two labels, a pixel may come from any exemplar.
    wraps : bool
        Whether the last row and column continue in the first.
    """
    free = np.flatnonzero(lock == 0) if lock.any() else None
    if not wraps:
        lock[:, -1] |= FREE_RIGHT
        lock[-1] |= FREE_BELOW
    has_lock = bool(lock.any() or labels.any())
    seams = np.empty((2, *addresses.shape), np.int32)
    texture = Texture(addresses, *seams, lock, with_free_borders(labels, free_band), guide)
    return Canvas(texture, free, has_lock)
