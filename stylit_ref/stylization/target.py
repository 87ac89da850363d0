"""The target of a stylization, which may serve several exemplars and runs."""

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.formulae.guide_map import sums_dtype
from stylit_ref.machine.replaced import Passes
from stylit_ref.metric.packing import Packing
from stylit_ref.stylization.mask import downsample_mask


class TargetLevel:
    """One level of a target for one run, which writes its B' here.

    Parameters
    ----------
    passes : module
    packing : Packing
    patch_width : int
    texture : (H_B + 2 radius, W_B + 2 radius, C) uint8
        B̄ in the memory of the passes, its edge pixels repeated ``radius`` times.
    synthesized : (H_B, W_B) bool, optional
        Pixels whose patches take part; all by default.
    """

    passes: Passes
    packing: Packing
    patch_width: int
    texture: NDArray[np.uint8]
    synthesized: NDArray[np.bool_]
    weights: NDArray[np.int64]

    def __init__(
        self,
        passes: Passes,
        packing: Packing,
        patch_width: int,
        texture: NDArray[np.uint8],
        synthesized: NDArray[np.bool_] | None = None,
    ) -> None:
        self.passes, self.packing, self.patch_width = passes, packing, patch_width
        self.texture = texture
        self.synthesized = np.ones(self.size, bool) if synthesized is None else synthesized
        self.weights = passes.upload(packing.weights)

    @property
    def size(self) -> tuple[int, int]:
        """Rows and columns of patches."""
        return tuple(length - self.patch_width + 1 for length in self.texture.shape[:2])

    @cached_property
    def moments(self) -> NDArray[np.int16]:
        """Moments of every patch, (H_B, W_B, moments) int16, as of the last update."""
        moments = self.passes.moments_storage(*self.size, len(self.packing.moments))
        self.passes.patch_moments(
            self.texture, moments, self.patch_width, 0,
            self.packing.style_channel, self.packing.style_channels,
        )  # fmt: skip
        return moments

    def update_moments(self) -> None:
        """Compute the moments with the current B'."""
        self.passes.patch_moments(
            self.texture, self.moments, self.patch_width, 0,
            self.packing.style_channel, self.packing.style_channels, style_only=True,
        )  # fmt: skip

    @cached_property
    def guide_sums(self) -> NDArray[np.uint16 | np.uint32]:
        """M_B times w² (5.2.2): the sums of the guides over each patch, (H_B, W_B, n) integers."""
        shape = *self.size, self.packing.style_channel
        sums = self.passes.zeros(shape, sums_dtype(self.patch_width))
        self.passes.means(self.texture, sums, self.patch_width, 0)
        return sums

    def make_guide_map(self, epsilon: float) -> NDArray[np.bool_]:
        """Compute G for an ε (Evaluate_Map, 5.2.2), (H_B, W_B) bool."""
        white = self.passes.zeros(self.size, np.bool_)
        self.passes.guide_map(
            self.texture, self.guide_sums, self.weights, self.patch_width, epsilon, white
        )
        return white

    @property
    def style(self) -> NDArray[np.uint8]:
        """The current B', (H_B, W_B, n) uint8, a NumPy array."""
        radius = self.patch_width // 2
        texture = self.passes.download(self.texture)
        return self.packing.style(texture)[radius:-radius, radius:-radius]

    def set_style(
        self, image: NDArray[np.uint8], last_guide: NDArray[np.uint8] | None = None
    ) -> None:
        """Set B' to an image, (H_B, W_B, n) uint8, and a guide that lies behind it."""
        radius = self.patch_width // 2
        texture = self.passes.download(self.texture)
        edges = (radius, radius), (radius, radius), (0, 0)
        self.packing.set_style(texture, np.pad(image, edges, mode="edge"))
        if last_guide is not None:
            self.packing.guide(texture, -1)[:] = np.pad(last_guide, edges, mode="edge")
        self.texture = self.passes.upload(texture)


class Target:
    """The guides of a target, and their pyramid.

    Levels count from the finest, which has depth 0.

    Parameters
    ----------
    passes : module
        :mod:`stylit_ref.passes`, or those of a GPU.
    packing : Packing
    patch_width : int
    texture : (H_B, W_B, C) uint8
        Packed texture B̄ of the finest level, a NumPy array. Its style is B' until the first vote.
    synthesized : (H_B, W_B) bool, optional
        Pixels whose patches take part (:func:`stylit_ref.stylization.mask.active_patches`); all by
        default.
    """

    passes: Passes
    packing: Packing
    patch_width: int

    def __init__(
        self,
        passes: Passes,
        packing: Packing,
        patch_width: int,
        texture: NDArray[np.uint8],
        synthesized: NDArray[np.bool_] | None = None,
    ) -> None:
        self.passes, self.packing, self.patch_width = passes, packing, patch_width
        self._textures = [passes.upload(texture)]
        all_of_it = np.ones(texture.shape[:2], bool)
        self._synthesized = [all_of_it if synthesized is None else synthesized]

    @property
    def size(self) -> tuple[int, int]:
        """Rows and columns of the finest level."""
        return self._synthesized[0].shape

    def synthesized(self, depth: int) -> NDArray[np.bool_]:
        """Pixels of a level whose patches take part, (H_B, W_B) bool."""
        while len(self._synthesized) <= depth:
            self._synthesized.append(downsample_mask(self._synthesized[-1]))
        return self._synthesized[depth]

    def level(self, depth: int) -> TargetLevel:
        """The level that is ``depth`` halvings below the finest (thesis 3.4), for one run only."""
        while len(self._textures) <= depth:
            self._textures.append(self.passes.downsample(self._textures[-1]))
        if self._textures[depth] is None:
            raise InputError("this level of the target is forgotten; begin with a new target")
        radius = self.patch_width // 2
        return TargetLevel(
            self.passes,
            self.packing,
            self.patch_width,
            self.passes.repeat_edge(self._textures[depth], radius),
            self.synthesized(depth),
        )

    def forget(self, depth: int) -> None:
        """Free the texture that a level is made of; :meth:`level` cannot make it again."""
        self._textures[depth] = None
