"""What a frame is made of, and how its picture comes of its NNF."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.realtime.exemplar import Exemplar
from stylit_ref.realtime.passes.image import Image
from stylit_ref.realtime.passes.moving import ALL
from stylit_ref.realtime.refinement import Refinement
from stylit_ref.realtime.target import Target

_NEVER = np.zeros(1, np.uint8)


class FrameInputs(NamedTuple):
    """Source, target and energy.

    Attributes
    ----------
    exemplar : Exemplar
    target : Target
        Its B' is the frame's to write.
    refinement : Refinement
    labels : (H_B, W_B) uint8 or None
    """

    exemplar: Exemplar
    target: Target
    refinement: Refinement
    labels: NDArray[np.uint8] | None

    def blended(self, nnf: NDArray[np.int32], level: int = 0) -> NDArray[np.uint8]:
        """B' of a level, (height, width, 3), from the entries of its sparse grid."""
        layout = self.exemplar.layout
        params = layout.params
        height, width = self.target.guides[level].height, self.target.guides[level].width
        picture = np.empty((height, width, 3), np.uint8)
        out = Image(picture.reshape(-1), width, 0, height, width)
        blend = layout.passes.make_blend(params.patch_width, params.step, 3)
        blend(nnf, self.exemplar.style[level], out, ALL)
        return picture

    def dense_nnf(
        self, nnf: NDArray[np.int32], stop: NDArray[np.uint8] = _NEVER
    ) -> NDArray[np.int32]:
        """An entry for every pixel, (H_B, W_B): the best of those around it.

        It is not finished if ``stop``, (1,), is no longer 0.
        """
        exemplar, target = self.exemplar, self.target
        passes, params = exemplar.layout.passes, exemplar.layout.params
        passes.make_blend(params.patch_width, params.step, STYLE_LANES)(
            nnf, exemplar.style[0], target.picture[0], ALL
        )
        guides, picture, _ = target.read_at(0, exemplar.layout)
        labels = np.zeros((0, 0), np.uint8) if self.labels is None else self.labels
        dense = np.empty(target.size, np.int32)
        lanes = exemplar.layout.lanes_read(0)
        passes.make_dense_nnf(params.patch_width, params.step, lanes)(
            nnf, exemplar.read_at(0, exemplar.layout), guides, picture,
            self.refinement.by_level[0], labels, exemplar.labels[0], dense, stop,
        )  # fmt: skip
        return dense

    def voted(
        self, dense: NDArray[np.int32], stop: NDArray[np.uint8] = _NEVER
    ) -> NDArray[np.uint8]:
        """B', (H_B, W_B, 3), from an entry for every pixel; ``stop`` as above."""
        layout = self.exemplar.layout
        picture = np.empty((*dense.shape, 3), np.uint8)
        vote = layout.passes.make_vote(layout.params.patch_width)
        vote(dense, self.exemplar.style[0], picture, stop)
        return picture
