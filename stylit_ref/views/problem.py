"""From images, a shot and parameters to a coherent run that is checked and can begin."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.randomness.seed import check_seed
from stylit_ref.stylization.checks import as_image, check_source_guides, fit_levels, most_levels
from stylit_ref.stylization.params import ALL, Params, as_params
from stylit_ref.views.formulae.fold import fixed_weight
from stylit_ref.views.params import SEQUENTIAL, Coherence
from stylit_ref.views.plan import Plan
from stylit_ref.views.shot import Shot


@dataclass(frozen=True, eq=False)
class Problem:
    """All that decides the bytes of a coherent run. It can be pickled if its shot can.

    Make it with :func:`make_problem`.

    Attributes
    ----------
    style : (H_A, W_A, n) uint8
    source_guides : tuple of (H_A, W_A, c) uint8
    shot : Shot
    params : Params
        Its ``levels`` is a number.
    coherence : Coherence
    seed : int
    """

    style: NDArray[np.uint8]
    source_guides: tuple[NDArray[np.uint8], ...]
    shot: Shot
    params: Params
    coherence: Coherence
    seed: int

    @property
    def weight(self) -> int:
        """λ_c in units of 1/256."""
        return fixed_weight(self.coherence.weight)

    def plan(self) -> Plan:
        """The order of work."""
        neighbours: list[list[int]] = [[] for _ in self.shot.names]
        is_sequential = self.coherence.order == SEQUENTIAL
        for to, other in sorted(self.shot.pairs):
            if self.weight and not (is_sequential and other > to):
                neighbours[to].append(other)
        following = self.coherence.following_votes
        of_following = self.params if following is None else replace(self.params, votes=following)
        votes, following_votes = map(_votes_of_levels, (self.params, of_following))
        return Plan(neighbours, votes, self.coherence.order, following_votes)


def make_problem(
    style: NDArray[np.uint8],
    source_guides: Sequence[NDArray[np.uint8]],
    shot: Shot,
    params: Params | None = None,
    coherence: Coherence | None = None,
    *,
    seed: int = 0,
) -> Problem:
    """Check what can be checked before a frame is read.

    Parameters
    ----------
    style, source_guides, params, seed
        As for :func:`stylit_ref.stylize`.
    shot : Shot
    coherence : Coherence, optional

    Returns
    -------
    Problem

    Raises
    ------
    InputError
        If arrays and parameters do not fit together, or pairs name no frames.
    """
    params, coherence = as_params(params), coherence or Coherence()
    check_seed(seed)
    style = as_image(style, "style")
    sources = [as_image(guide, f"source_guides[{k}]") for k, guide in enumerate(source_guides)]
    check_source_guides(style, sources)
    frames = len(shot.names)
    for to, other in shot.pairs:
        if not (0 <= to < frames and 0 <= other < frames) or to == other:
            raise InputError(
                f"joins frames {to} and {other}; the frames are 0 to {frames - 1}, and an edge "
                "joins two of them",
                parameter=f"edges[{to}, {other}]",
            )
    sizes = style.shape[:2], tuple(shot.size)
    params = fit_levels(params, *sizes)
    if params.levels == ALL:
        params = replace(params, levels=most_levels(params.patch_width, *sizes))
    return Problem(style, tuple(sources), shot, params, coherence, seed)


def _votes_of_levels(params):
    """Search-vote iterations of every level, the coarsest first."""
    return [params.votes_above(depth) for depth in reversed(range(int(params.levels)))]
