"""Texture optimization, coarse to fine, which a caller can drive step by step (thesis 2.3, 3.4)."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.randomness.random_stream import RANDOM_NNF, random_stream
from stylit_ref.randomness.seed import check_seed
from stylit_ref.stylization.checks import check_halves, check_nnf, most_levels
from stylit_ref.stylization.exemplar import Exemplar
from stylit_ref.stylization.level import Level
from stylit_ref.stylization.params import ALL, Params
from stylit_ref.stylization.progress import Step
from stylit_ref.stylization.schedules import SCHEDULES, Iterate
from stylit_ref.stylization.target import Target


class Synthesis:
    """TextureOptimization of thesis 2.3 and GPU_TextureOptimization of 3.4, step by step.

    Make it with :func:`stylit_ref.stylization.problem.make_synthesis`, or from an exemplar and a
    target of ``make_exemplar`` and ``make_target`` there. :meth:`finish` does a whole run;
    :meth:`run` does the same and yields its steps. In smaller steps a run is::

        for number in synthesis.level_numbers:
            synthesis.begin_level(number)
            for _ in range(synthesis.votes):
                synthesis.vote()
                for step in synthesis.search():
                    ...
            synthesis.end_level()
        picture, nnf = synthesis.level.style, synthesis.level.nnf

    Between two steps a caller may read :attr:`level`, change its B' (as a coherent sequence does),
    or stop. To continue later, a run needs only the NNF of the level (:meth:`begin_level`).

    Parameters
    ----------
    exemplar : Exemplar
        May be shared with other runs.
    target : Target
        Packed as the exemplar is.
    params : Params
    seed : int
    iterate : callable, optional
        A PatchMatch iteration that replaces that of ``params.schedule``.
    forgets : bool
        Whether levels of the target, and what was computed for those of the exemplar, are freed as
        soon as this run needs them no more. Then no level can be begun twice.

    Attributes
    ----------
    params : Params
        Its ``levels`` is a number.
    level : Level or None
        The level that was begun last.
    level_number, vote_number : int
        Its number, 1 the coarsest, and the votes since it began; 0 before the first level.

    Raises
    ------
    InputError
        If exemplar, target and parameters do not fit together.
    """

    exemplar: Exemplar
    target: Target
    params: Params
    seed: int
    iterate: Iterate
    level: Level | None
    level_number: int
    vote_number: int

    def __init__(
        self,
        exemplar: Exemplar,
        target: Target,
        params: Params,
        seed: int = 0,
        iterate: Iterate | None = None,
        forgets: bool = False,
    ) -> None:
        if params.levels == ALL:
            most = most_levels(params.patch_width, exemplar.size, target.size)
            params = replace(params, levels=most)
        check_halves(exemplar, target, params)
        check_seed(seed)
        self.exemplar, self.target, self.params, self.seed = exemplar, target, params, seed
        self.iterate, self._forgets = iterate or SCHEDULES[params.schedule], forgets
        self.level, self.level_number, self.vote_number = None, 0, 0
        self._work = [
            int(np.count_nonzero(target.synthesized(self._depth(number)))) * self._votes(number)
            for number in self.level_numbers
        ]

    @property
    def level_numbers(self) -> range:
        """Numbers of all levels, from 1, the coarsest; random streams use them."""
        return range(1, self.params.levels + 1)

    @property
    def votes(self) -> int:
        """Search-vote iterations of the current level; one more vote ends it."""
        return self._votes(self.level_number)

    @property
    def depth(self) -> int:
        """Number of finer levels; exemplar and target count levels this way, from 0, the finest."""
        return self._depth(self.level_number)

    def begin_level(
        self, number: int, nnf: NDArray[np.int32] | None = None, votes: int = 0
    ) -> Level:
        """Begin a level: the coarsest with a random NNF, others with the NNF of the level before.

        The thesis also upsamples B'. That has no effect, since the first vote of a level overwrites
        it.

        Parameters
        ----------
        number : int
            1 is the coarsest. Unless ``nnf`` is given, the level before must have been begun last.
        nnf : (H_B, W_B, 2) int32, optional
            Assignments to begin with, from an earlier run of this level.
        votes : int
            How many votes they have seen.

        Returns
        -------
        Level

        Raises
        ------
        InputError
            If there is no such level, the level before is missing, or the NNF does not fit.
        """
        if number not in self.level_numbers:
            raise InputError(f"there is no level {number}; levels are 1 to {self.params.levels}")
        if nnf is None and number not in (1, self.level_number + 1):
            raise InputError(
                f"level {number} begins with the NNF of level {number - 1}, but the run is at "
                f"level {self.level_number}; begin level {number - 1} first, or give the NNF"
            )
        coarse_nnf = self.level.nnf if number > 1 and nnf is None else None
        self.level = None  # makes room for the next
        self.level_number, self.vote_number = number, votes
        exemplar, target = self.exemplar.level(self.depth), self.target.level(self.depth)
        if self._forgets:
            self.target.forget(self.depth)
        level = Level(exemplar, target, self.params)
        if nnf is not None:
            check_nnf(nnf, exemplar.size, target.synthesized, level.patch_width)
            level.set_nnf(nnf)
        elif coarse_nnf is None:
            stream = random_stream(self.seed, RANDOM_NNF, number)
            level.passes.random_nnf(level.nnf, level.patch_width, *exemplar.size, stream)
        else:
            level.passes.upsample_nnf(coarse_nnf, level.nnf, level.patch_width, *exemplar.size)
        level.init_occurrence_map()
        self.level = level
        return level

    def vote(self) -> None:
        """E-step: compute B' from the NNF."""
        self._begun().vote()
        self.vote_number += 1

    def search(self) -> Iterator[Step]:
        """M-step: improve the NNF for the current B'.

        Yields
        ------
        Step
            After every PatchMatch iteration or retrieval.
        """
        level = self._begun()
        level.update_moments()
        steps = self.params.traits.search(
            level, self.params, self.iterate, self.seed, self.level_number, self.vote_number
        )
        for step in steps:
            delta, penalization = level.energy()
            height, width = level.target.size
            yield Step(
                level=self.level_number,
                levels=self.params.levels,
                height=height,
                width=width,
                vote=self.vote_number,
                delta=delta,
                penalization=penalization,
                done=self._done(step.done),
                patchmatch_iteration=step.patchmatch_iteration,
                moves=step.moves,
                retrieval=step.retrieval,
                fixed=step.fixed,
            )

    def end_level(self) -> Level:
        """Do the last vote of a level, and compute Ω and W of its NNF."""
        level = self._begun()
        level.vote()
        level.init_occurrence_map()
        if self._forgets:
            self.exemplar.forget(self.depth)
        return level

    def run_level(self, number: int) -> Iterator[Step]:
        """Run a level from beginning to end; :attr:`level` is finished when the generator ends."""
        self.begin_level(number)
        for _ in range(self.votes):
            self.vote()
            yield from self.search()
        self.end_level()

    def run(self) -> Iterator[Step]:
        """Run all levels; when the generator ends, :attr:`level` is the finest, and finished."""
        for number in self.level_numbers:
            yield from self.run_level(number)

    def finish(self) -> Level:
        """Run all levels; returns the finest."""
        for _ in self.run():
            pass
        return self._begun()

    def _begun(self):
        if self.level is None:
            raise InputError("no level has begun; call begin_level first")
        return self.level

    def _depth(self, number):
        return self.params.levels - number

    def _votes(self, number):
        return self.params.votes_above(self._depth(number))

    def _done(self, share):
        """Share of the whole run's work when this share of the current search is done."""
        before, work = self._work[: self.level_number - 1], self._work[self.level_number - 1]
        searches = (self.vote_number - 1 + share) / self.votes
        return (sum(before) + searches * work) / sum(self._work)
