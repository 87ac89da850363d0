"""One pyramid level of a run: its textures, its assignments, and what is computed from them."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.replaced import Passes
from stylit_ref.metric.packing import ONE, Packing, occurrence_weight
from stylit_ref.metric.proposal import Commitment, Proposal
from stylit_ref.metric.textures import Textures
from stylit_ref.randomness.philox import FourWords
from stylit_ref.stylization.exemplar import ExemplarLevel
from stylit_ref.stylization.target import TargetLevel

if TYPE_CHECKING:  # params imports the methods, which import this module
    from stylit_ref.stylization.params import Params


def join(
    exemplar: ExemplarLevel, target: TargetLevel, guide_map: NDArray[np.bool_] | None = None
) -> Textures:
    """Join source and target into the textures that the passes take; memory is shared.

    Parameters
    ----------
    exemplar : ExemplarLevel
        The side whose patches are assigned.
    target : TargetLevel
        The side whose patches receive an assignment.
    guide_map : (H_B, W_B) bool, optional
        G, the patches whose guides are compared by means.

    Returns
    -------
    Textures
    """
    packing = target.packing
    with_map = guide_map is not None
    return Textures(
        source=exemplar.texture,
        target=target.texture,
        source_moments=exemplar.moments,
        target_moments=target.moments,
        weights=target.weights,
        pair_weights=packing.pair_weights,
        moment_weights=packing.moment_weights(target.patch_width, with_map),
        guide_map=guide_map,
        source_sums=exemplar.guide_sums if with_map else None,
        target_sums=target.guide_sums if with_map else None,
        style_pair_weights=packing.style_pair_weights if with_map else None,
    )


class Level:
    """Textures, assignments and occurrence maps of one pyramid level.

    Parameters
    ----------
    exemplar : ExemplarLevel
        It is not changed: other levels may share it.
    target : TargetLevel
        Belongs to this level alone, since it holds B'.
    params : Params

    Attributes
    ----------
    textures : Textures
        Ā and B̄, which includes B', with the moments of their patches.
    nnf : (H_B, W_B, 2) int32
        Source patch centre of each target pixel; -1 where a mask leaves it alone.
    delta : (H_B, W_B) int64
        δ of each assignment in fixed point.
    proposed_nnf, proposed_delta : like ``nnf`` and ``delta``
        NNF' of the thesis.
    omega, omega_sums : (H_A, W_A) int32
        Ω, and W: Ω summed over each patch. The search updates the one that it reads, and W
        only if its weight is not 0; ``init_occurrence_map`` computes both.
    occurrence_weight : int
        Weight of W in φ.
    moves : (1,) int64
        Assignments that the level's commits have changed.
    """

    target: TargetLevel
    passes: Passes
    packing: Packing
    patch_width: int
    vote_outliers: int
    textures: Textures
    nnf: NDArray[np.int32]
    delta: NDArray[np.int64]
    proposed_nnf: NDArray[np.int32]
    proposed_delta: NDArray[np.int64]
    omega: NDArray[np.int32]
    omega_sums: NDArray[np.int32]
    occurrence_weight: int
    moves: NDArray[np.int64]

    def __init__(self, exemplar: ExemplarLevel, target: TargetLevel, params: "Params") -> None:
        self.target = target
        self.passes = target.passes
        self.packing, self.patch_width = target.packing, target.patch_width
        self.vote_outliers = params.vote_outliers
        has_guide_map = params.traits.has_guide_map
        guide_map = target.make_guide_map(params.epsilon) if has_guide_map else None
        self.textures = join(exemplar, target, guide_map)

        passes, synthesized = self.passes, target.synthesized
        unassigned = np.where(synthesized[:, :, None], np.int32(0), np.int32(-1)).repeat(2, axis=2)
        self.nnf, self.proposed_nnf = passes.upload(unassigned), passes.upload(unassigned.copy())
        self.delta, self.proposed_delta = (
            passes.zeros(synthesized.shape, np.int64) for _ in range(2)
        )
        self.omega, self.omega_sums = (passes.zeros(exemplar.size, np.int32) for _ in range(2))
        self.occurrence_weight = occurrence_weight(
            params.penalization,
            self.patch_width,
            exemplar.size[0] * exemplar.size[1],
            np.count_nonzero(synthesized),
        )
        self.moves, self._moves_taken = passes.zeros(1, np.int64), 0

    @property
    def proposal(self) -> Proposal:
        """The first arguments of the passes that propose."""
        return Proposal(
            self.textures, self.omega_sums, self.occurrence_weight, self.patch_width,
            self.nnf, self.delta, self.proposed_nnf, self.proposed_delta,
        )  # fmt: skip

    def commitment(self, stream: FourWords) -> Commitment:
        """The arguments of a commit; ``stream`` decides the order of the classes."""
        return Commitment(
            self.nnf, self.delta, self.proposed_nnf, self.proposed_delta,
            self.omega_sums, self.occurrence_weight, self.patch_width, stream, self.moves,
        )  # fmt: skip

    @property
    def style(self) -> NDArray[np.uint8]:
        """The current synthesized style B', (H_B, W_B, n) uint8, a NumPy array."""
        return self.target.style

    def set_nnf(self, nnf: NDArray[np.int32]) -> None:
        """Set the NNF, (H_B, W_B, 2) int32; call :meth:`init_occurrence_map` to update Ω."""
        self.nnf = self.passes.upload(nnf.copy())

    def set_style(
        self, image: NDArray[np.uint8], last_guide: NDArray[np.uint8] | None = None
    ) -> None:
        """Set B', and compute δ of the NNF with it.

        Call :meth:`update_moments` before the next search.

        Parameters
        ----------
        image : (H_B, W_B, n) uint8
        last_guide : (H_B, W_B, channels) uint8, optional
            Replaces the target's last guide, which lies behind the style.

        Raises
        ------
        InputError
            If it has another size, type or number of channels.
        """
        self.target.set_style(image, last_guide)
        self.textures = self.textures._replace(target=self.target.texture)
        self.update_similarity()

    def init_occurrence_map(self) -> None:
        """InitOccurrenceMap (2.3): compute Ω and W of the current NNF."""
        self.passes.occurrence_map(self.nnf, self.omega, self.omega_sums, self.patch_width)

    def vote(self) -> None:
        """E-step of 2.3: compute B' from the NNF, then δ of the NNF with the new B'.

        Call :meth:`update_moments` before the next search.
        """
        self.update_style()
        self.update_similarity()

    def update_style(self) -> None:
        """Compute B' from the NNF; δ stays what it was."""
        self.passes.vote(
            self.textures.source,
            self.textures.target,
            self.nnf,
            self.patch_width,
            self.packing.style_channel,
            self.packing.style_channels,
            self.vote_outliers,
        )

    def update_similarity(self) -> None:
        """Compute δ of the current NNF."""
        self.passes.similarity(self.textures, self.patch_width, self.nnf, self.delta)

    def update_moments(self) -> None:
        """Compute the moments of the target's patches with the current B', for the search."""
        self.target.update_moments()

    def take_moves(self) -> int:
        """Number of assignments that commits have changed since the last call."""
        before, self._moves_taken = self._moves_taken, int(self.passes.download(self.moves)[0])
        return self._moves_taken - before

    def energy(self) -> tuple[float, float]:
        """Mean δ and mean λρ, in the units of the thesis."""
        delta, omega_sum = self.passes.energy(self.nnf, self.delta, self.omega_sums)
        return delta / ONE, self.occurrence_weight * omega_sum / ONE
