"""Stylize frames that pull at each other (3.2), step by step."""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from stylit_ref.stylization.progress import Step
from stylit_ref.stylization.synthesis import Synthesis
from stylit_ref.views.coherence import Neighbour, places_of, pull
from stylit_ref.views.formulae.fold import fixed_weight
from stylit_ref.views.frames import Edges, neighbours_of
from stylit_ref.views.params import PARALLEL, SEQUENTIAL, Coherence


class CoherentSynthesis:
    """The runs of all frames, which see each other's pictures between vote and search.

    Make it with :func:`stylit_ref.views.problem.make_coherent_synthesis`. All frames use the same
    random numbers: without coherence, each is the run that it would be by itself.

    Parameters
    ----------
    runs : sequence of Synthesis
        One for each frame, before its first level, with the same parameters.
    edges : mapping
        Checked (:func:`stylit_ref.views.frames.check_edges`).
    coherence : Coherence
    with_spread : bool
        Whether packed pixels have the channel of :mod:`stylit_ref.views.packing`.

    Attributes
    ----------
    runs : list of Synthesis
    """

    runs: list[Synthesis]

    def __init__(
        self,
        runs: Sequence[Synthesis],
        edges: Edges,
        coherence: Coherence,
        *,
        with_spread: bool,
    ) -> None:
        self.runs, self._edges, self._coherence = list(runs), edges, coherence
        self._weight, self._with_spread = fixed_weight(coherence.weight), with_spread
        self._neighbours = [
            neighbours_of(edges, frame) if self._weight else [] for frame in range(len(self.runs))
        ]

    def run(self) -> Iterator[tuple[int, Step]]:
        """Run all frames in the order of the coherence.

        Yields
        ------
        tuple of int and Step
            When it ends, the level of every run is the finest, and finished.
        """
        if self._coherence.order == SEQUENTIAL:
            yield from self._one_after_the_other()
            return
        iterate = self._at_once if self._coherence.order == PARALLEL else self._sweep
        for number in self.runs[0].level_numbers:
            for run in self.runs:
                run.begin_level(number)
            places = self._places(self.runs[0].depth)
            for vote in range(self.runs[0].votes):
                yield from iterate(places, vote)
            for run in self.runs:
                run.end_level()

    def _at_once(self, places, vote):
        """One search-vote iteration of every frame (3.2.2)."""
        for run in self.runs:
            run.vote()
        pictures = [_picture(run) for run in self.runs]
        for frame in range(len(self.runs)):
            yield from self._search(frame, places, pictures)

    def _sweep(self, places, vote):
        """The same, forth and back in turns: each frame sees what those before it have become."""
        if vote == 0:
            for run in self.runs:
                run.level.vote()
        pictures = [_picture(run) for run in self.runs]
        frames = range(len(self.runs))
        for frame in frames if vote % 2 == 0 else reversed(frames):
            run = self.runs[frame]
            run.vote()
            yield from self._search(frame, places, pictures)
            run.level.vote()
            pictures[frame] = _picture(run)

    def _one_after_the_other(self):
        """Whole runs, each of which sees the frames that are finished."""
        finished = {}
        for frame, run in enumerate(self.runs):
            before = [other for other in self._neighbours[frame] if other < frame]
            for number in run.level_numbers:
                run.begin_level(number)
                neighbours = [
                    Neighbour(
                        places_of(self._edges[frame, other], run.depth),
                        halved(finished[other], run),
                    )
                    for other in before
                ]
                for _ in range(run.votes):
                    run.vote()
                    self._pull(run, neighbours)
                    yield from self._steps(frame)
                run.end_level()
            finished[frame] = _picture(run)

    def _places(self, depth):
        return {
            (frame, other): places_of(self._edges[frame, other], depth)
            for frame, others in enumerate(self._neighbours)
            for other in others
        }

    def _search(self, frame, places, pictures):
        neighbours = [
            Neighbour(places[frame, other], pictures[other]) for other in self._neighbours[frame]
        ]
        self._pull(self.runs[frame], neighbours)
        yield from self._steps(frame)

    def _pull(self, run, neighbours):
        pull(run.level, neighbours, self._weight, with_spread=self._with_spread)

    def _steps(self, frame):
        for step in self.runs[frame].search():
            yield frame, step


def halved(picture: NDArray[np.uint8], run: Synthesis) -> NDArray[np.uint8]:
    """A picture of the finest level in the size of the run's current level."""
    for _ in range(run.depth):
        picture = run.level.passes.downsample(picture)
    return picture


def _picture(run):
    return run.level.style.copy()
