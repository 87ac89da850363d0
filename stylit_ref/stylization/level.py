"""One pyramid level: its textures, its assignments, and what follows from them."""

import numpy as np

from stylit_ref.formulae.guide_map import sums_dtype
from stylit_ref.metric.packing import ONE, occurrence_weight
from stylit_ref.metric.textures import Textures


class Level:
    """Textures, assignments and occurrence maps of one pyramid level.

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

    def __init__(self, passes, packing, params, source, target, synthesized):
        self.passes, self.packing = passes, packing
        self.patch_width, self.vote_outliers = params.patch_width, params.vote_outliers
        with_guide_map = params.method == "guide_map"
        radius = self.patch_width // 2
        height, width = target.shape[:2]
        padded = passes.repeat_edge(target, radius)
        lanes = len(packing.moments)
        self.textures = Textures(
            source=source,
            target=padded,
            source_moments=passes.moments_storage(*source.shape[:2], lanes),
            target_moments=passes.moments_storage(height, width, lanes),
            weights=passes.upload(packing.weights),
            pair_weights=packing.pair_weights,
            moment_weights=packing.moment_weights(self.patch_width, with_guide_map),
        )
        if with_guide_map:
            self._add_guide_map(params.epsilon)
        style = packing.style_channel, packing.style_channels
        passes.patch_moments(source, self.textures.source_moments, self.patch_width, radius, *style)
        passes.patch_moments(padded, self.textures.target_moments, self.patch_width, 0, *style)

        unassigned = np.where(synthesized[:, :, None], np.int32(0), np.int32(-1)).repeat(2, axis=2)
        self.nnf, self.proposed_nnf = passes.upload(unassigned), passes.upload(unassigned.copy())
        self.delta, self.proposed_delta = (
            passes.zeros((height, width), np.int64) for _ in range(2)
        )
        self.omega, self.omega_sums = (passes.zeros(source.shape[:2], np.int32) for _ in range(2))
        self.occurrence_weight = occurrence_weight(
            params.uniformity,
            self.patch_width,
            source.shape[0] * source.shape[1],
            np.count_nonzero(synthesized),
        )
        self.moves, self._moves_taken = passes.zeros(1, np.int64), 0

    def _add_guide_map(self, epsilon):
        """Evaluate_Means and Evaluate_Map (5.2.2): guides stay as they are all through a level."""
        source, target, radius = self.textures.source, self.textures.target, self.patch_width // 2
        size = target.shape[0] - 2 * radius, target.shape[1] - 2 * radius
        guides, dtype = self.packing.style_channel, sums_dtype(self.patch_width)
        self.textures = self.textures._replace(
            guide_map=self.passes.zeros(size, np.bool_),
            source_sums=self.passes.zeros((*source.shape[:2], guides), dtype),
            target_sums=self.passes.zeros((*size, guides), dtype),
            style_pair_weights=self.packing.style_pair_weights,
        )
        self.passes.means(source, self.textures.source_sums, self.patch_width, radius)
        self.passes.means(target, self.textures.target_sums, self.patch_width, 0)
        self.passes.guide_map(
            target,
            self.textures.target_sums,
            self.textures.weights,
            self.patch_width,
            epsilon,
            self.textures.guide_map,
        )

    @property
    def style(self):
        """The synthesized style B' as it stands, (H_B, W_B, n) uint8, NumPy's."""
        radius = self.patch_width // 2
        target = self.passes.download(self.textures.target)
        return self.packing.style(target)[radius:-radius, radius:-radius]

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
        self.passes.similarity(self.textures, self.patch_width, self.nnf, self.delta)

    def update_moments(self):
        """Moments of the target's patches with B' as it stands: the search reads them."""
        self.passes.patch_moments(
            self.textures.target,
            self.textures.target_moments,
            self.patch_width,
            0,
            self.packing.style_channel,
            self.packing.style_channels,
            style_only=True,
        )

    def take_moves(self):
        """Assignments that commits have changed since this was last asked."""
        before, self._moves_taken = self._moves_taken, int(self.passes.download(self.moves)[0])
        return self._moves_taken - before

    def energy(self):
        """Mean δ and mean λρ, in the thesis' units."""
        delta, omega_sum = self.passes.energy(self.nnf, self.delta, self.omega_sums)
        return delta / ONE, self.occurrence_weight * omega_sum / ONE
