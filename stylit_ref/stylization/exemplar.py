"""The source of a stylization: made once, shared by targets and runs."""

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from stylit_ref.formulae.guide_map import sums_dtype
from stylit_ref.machine.replaced import Passes
from stylit_ref.metric.packing import Packing


class ExemplarLevel:
    """One level of an exemplar: Ā, and what is computed from it when it is first needed.

    Parameters
    ----------
    passes : module
    packing : Packing
    patch_width : int
    texture : (H_A, W_A, C) uint8
        Ā, in the memory of the passes.
    """

    passes: Passes
    packing: Packing
    patch_width: int
    texture: NDArray[np.uint8]

    def __init__(
        self, passes: Passes, packing: Packing, patch_width: int, texture: NDArray[np.uint8]
    ) -> None:
        self.passes, self.packing, self.patch_width = passes, packing, patch_width
        self.texture = texture

    @property
    def size(self) -> tuple[int, int]:
        """Rows and columns."""
        return self.texture.shape[:2]

    @cached_property
    def moments(self) -> NDArray[np.int16]:
        """Moments of every patch, (H_A, W_A, moments) int16, at the patch's centre."""
        moments = self.passes.moments_storage(*self.size, len(self.packing.moments))
        self.passes.patch_moments(
            self.texture, moments, self.patch_width, self.patch_width // 2,
            self.packing.style_channel, self.packing.style_channels,
        )  # fmt: skip
        return moments

    @cached_property
    def guide_sums(self) -> NDArray[np.uint16 | np.uint32]:
        """M_A times w² (5.2.2): the sums of the guides over each patch, (H_A, W_A, n) integers."""
        shape = *self.size, self.packing.style_channel
        sums = self.passes.zeros(shape, sums_dtype(self.patch_width))
        self.passes.means(self.texture, sums, self.patch_width, self.patch_width // 2)
        return sums


class Exemplar:
    """A style with its guides and its pyramid.

    Levels count from the finest, which has depth 0, so that runs with different numbers of levels
    can share them. What was computed for a level is kept until :meth:`forget`.

    Parameters
    ----------
    passes : module
        :mod:`stylit_ref.passes`, or those of a GPU.
    packing : Packing
    patch_width : int
    texture : (H_A, W_A, C) uint8
        Packed texture Ā of the finest level, a NumPy array.
    """

    passes: Passes
    packing: Packing
    patch_width: int

    def __init__(
        self, passes: Passes, packing: Packing, patch_width: int, texture: NDArray[np.uint8]
    ) -> None:
        self.passes, self.packing, self.patch_width = passes, packing, patch_width
        self._texture = texture
        self._textures = [passes.upload(texture)]
        self._levels = {}

    @property
    def size(self) -> tuple[int, int]:
        """Rows and columns of the finest level."""
        return self._texture.shape[:2]

    def level(self, depth: int) -> ExemplarLevel:
        """The level that is ``depth`` halvings below the finest (thesis 3.4)."""
        while len(self._textures) <= depth:
            self._textures.append(self.passes.downsample(self._textures[-1]))
        if depth not in self._levels:
            level = ExemplarLevel(
                self.passes, self.packing, self.patch_width, self._textures[depth]
            )
            self._levels[depth] = level
        return self._levels[depth]

    def forget(self, depth: int) -> None:
        """Free what was computed for a level: about four times the memory of its texture."""
        self._levels.pop(depth, None)

    def repainted(self, style: NDArray[np.uint8]) -> "Exemplar":
        """An exemplar with another style over the same guides; both share the sums of the guides.

        Parameters
        ----------
        style : (H_A, W_A, n) uint8

        Returns
        -------
        Exemplar
            Runs with the old exemplar are not affected.

        Raises
        ------
        InputError
            If the style has another size, type or number of channels.
        """
        texture = self._texture.copy()
        self.packing.set_style(texture, style)
        repainted = Exemplar(self.passes, self.packing, self.patch_width, texture)
        for depth, level in self._levels.items():
            if "guide_sums" in vars(level):
                repainted.level(depth).guide_sums = level.guide_sums
        return repainted
