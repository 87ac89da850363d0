"""The arguments that many passes share, in their order."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.metric.textures import Textures
from stylit_ref.randomness.philox import FourWords


class Proposal(NamedTuple):
    """The first arguments of every pass that proposes assignments: ``propose(*proposal, ...)``.

    Attributes
    ----------
    textures : Textures
    omega_sums : (H_A, W_A) int32
        W, Ω summed over each patch.
    occurrence_weight : int
        Weight of W in φ, fixed point.
    patch_width : int
    nnf : (H_B, W_B, 2) int32
        Assignments to start from; negative where a mask leaves the pixel alone.
    delta : (H_B, W_B) int64
        Their δ, fixed point.
    new_nnf, new_delta : arrays like ``nnf`` and ``delta``
        NNF' of the thesis: receives the better assignment and its δ.
    """

    textures: Textures
    omega_sums: NDArray[np.int32]
    occurrence_weight: int
    patch_width: int
    nnf: NDArray[np.int32]
    delta: NDArray[np.int64]
    new_nnf: NDArray[np.int32]
    new_delta: NDArray[np.int64]

    def accepted(self) -> "Proposal":
        """The arguments after all proposals have become assignments: both fields are swapped."""
        return self._replace(
            nnf=self.new_nnf, delta=self.new_delta, new_nnf=self.nnf, new_delta=self.delta
        )


class Commitment(NamedTuple):
    """The arguments of a commit: ``commit(*commitment)``.

    Attributes
    ----------
    nnf, delta : (H_B, W_B, 2) int32 and (H_B, W_B) int64
        Assignments and their δ.
    proposed_nnf, proposed_delta : arrays like ``nnf`` and ``delta``
    omega_sums : (H_A, W_A) int32
        W, Ω summed over each patch.
    occurrence_weight, patch_width : int
    stream : tuple of 4 uint32
        Random numbers for the order of the classes.
    moves : (1,) int64
        The number of pixels that moved is added to it.
    """

    nnf: NDArray[np.int32]
    delta: NDArray[np.int64]
    proposed_nnf: NDArray[np.int32]
    proposed_delta: NDArray[np.int64]
    omega_sums: NDArray[np.int32]
    occurrence_weight: int
    patch_width: int
    stream: FourWords
    moves: NDArray[np.int64]
