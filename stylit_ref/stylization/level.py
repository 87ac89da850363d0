"""One pyramid level of a run: its textures, its assignments, and what follows from them."""

from types import ModuleType

import numpy as np

from stylit_ref.metric.packing import ONE, occurrence_weight
from stylit_ref.metric.proposal import Commitment, Proposal
from stylit_ref.metric.textures import Textures
from stylit_ref.stylization.exemplar import ExemplarLevel
from stylit_ref.stylization.target import TargetLevel


def join(exemplar: ExemplarLevel, target: TargetLevel, guide_map=None) -> Textures:
    """Both sides of a comparison as the passes take them, the memory shared.

    Parameters
    ----------
    exemplar : ExemplarLevel
        Whose patches are assigned.
    target : TargetLevel
        Whose patches they are assigned to.
    guide_map : (H_B, W_B) bool, optional
        G, where means stand for a patch's guides.

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
        Stays as it is: other levels may share it.
    target : TargetLevel
        This level's own, since B' is in it.
    params : Params

    Attributes
    ----------
    textures : Textures
        Ā and B̄, B' included, with their patches' moments.
    nnf : (H_B, W_B, 2) int32
        Source patch centre of each target pixel; -1 where a mask leaves it alone.
    delta : (H_B, W_B) int64
        δ of each assignment in fixed point.
    proposed_nnf, proposed_delta : like ``nnf`` and ``delta``
        NNF' of the thesis.
    omega, omega_sums : (H_A, W_A) int32
        Ω, and W: Ω summed over each patch. The search keeps the one it reads up to
        date, W only where φ has a weight for it; ``init_occurrence_map`` makes both anew.
    occurrence_weight : int
        Weight of W in φ.
    moves : (1,) int64
        Assignments that the level's commits have changed.
    """

    def __init__(self, exemplar: ExemplarLevel, target: TargetLevel, params):
        self.target = target
        self.passes: ModuleType = target.passes
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
        """What the passes that propose begin with."""
        return Proposal(
            self.textures, self.omega_sums, self.occurrence_weight, self.patch_width,
            self.nnf, self.delta, self.proposed_nnf, self.proposed_delta,
        )  # fmt: skip

    def commitment(self, stream) -> Commitment:
        """What a commit takes, with the stream of its classes' order."""
        return Commitment(
            self.nnf, self.delta, self.proposed_nnf, self.proposed_delta,
            self.omega_sums, self.occurrence_weight, self.patch_width, stream, self.moves,
        )  # fmt: skip

    @property
    def style(self):
        """The synthesized style B' as it stands, (H_B, W_B, n) uint8, NumPy's."""
        return self.target.style

    def set_nnf(self, nnf: np.ndarray) -> None:
        """Take assignments, (H_B, W_B, 2) int32; :meth:`init_occurrence_map` makes Ω fit."""
        self.nnf = self.passes.upload(nnf.copy())

    def set_style(self, image: np.ndarray) -> None:
        """Take an image for B', and δ of the NNF with it.

        Parameters
        ----------
        image : (H_B, W_B, n) uint8

        Raises
        ------
        InputError
            If it has another size, type or number of channels.
        """
        self.target.set_style(image)
        self.textures = self.textures._replace(target=self.target.texture)
        self.update_similarity()

    def init_occurrence_map(self):
        """InitOccurrenceMap (2.3): Ω and W of the NNF as it stands."""
        self.passes.occurrence_map(self.nnf, self.omega, self.omega_sums, self.patch_width)

    def vote(self):
        """E-step of 2.3: B' from the NNF; then δ of the NNF with the new B'.

        A search needs :meth:`update_moments` before it.
        """
        self.passes.vote(
            self.textures.source,
            self.textures.target,
            self.nnf,
            self.patch_width,
            self.packing.style_channel,
            self.packing.style_channels,
            self.vote_outliers,
        )
        self.update_similarity()

    def update_similarity(self):
        """δ of the NNF as it stands."""
        self.passes.similarity(self.textures, self.patch_width, self.nnf, self.delta)

    def update_moments(self):
        """Moments of the target's patches with B' as it stands: the search reads them."""
        self.target.update_moments()

    def take_moves(self):
        """Assignments that commits have changed since this was last asked."""
        before, self._moves_taken = self._moves_taken, int(self.passes.download(self.moves)[0])
        return self._moves_taken - before

    def energy(self):
        """Mean δ and mean λρ, in the thesis' units."""
        delta, omega_sum = self.passes.energy(self.nnf, self.delta, self.omega_sums)
        return delta / ONE, self.occurrence_weight * omega_sum / ONE
