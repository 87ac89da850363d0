"""Find the convention of vectors: the one along which the pictures differ least."""

from collections.abc import Sequence
from dataclasses import dataclass

from stylit_ref.errors import InputError
from stylit_ref.files.motion_file import BLENDER, FLO, OTHER
from stylit_ref.views.motion.conventions import CONVENTIONS, PROGRAMS, Convention
from stylit_ref.views.motion.samples import (
    Difference,
    Sample,
    Ways,
    change_of,
    halves_of,
    ways_of,
)

LEAST_CHANGE = 0.5
"""Pictures that differ by less, in steps of 8 bits, show a still shot."""

LEAST_GAIN = 0.8
"""The right convention leaves less than this share of the differences without motion."""

ALIKE = 0.02
"""Conventions explain the pictures alike if their errors differ by no more than this share of the
differences without motion. With even motion, the opposite of the way on is the way back."""


_FASTER = (
    "name frames of the same program in which things move by several pixels, or frames further "
    "apart and the vectors from one to the other"
)


@dataclass(frozen=True)
class Trial:
    """A convention that was tried.

    Attributes
    ----------
    convention : Convention
    error : float
        Mean absolute difference of brightness along the vectors, in steps of 8 bits.
    """

    convention: Convention
    error: float


@dataclass(frozen=True)
class Verdict:
    """What a check has found.

    Attributes
    ----------
    convention : Convention or None
        None if it is undecided.
    why : str
        A sentence: why it is undecided, or which other conventions explain the pictures alike; or
        empty.
    still : float
        The warping error without motion.
    trials : tuple of Trial
        Those that could be tried, the best first.
    """

    convention: Convention | None
    why: str
    still: float
    trials: tuple[Trial, ...] = ()

    @property
    def alike(self) -> tuple[Convention, ...]:
        """Those that explain the pictures as well as the best, which is the first."""
        most = self.trials[0].error + ALIKE * self.still
        return tuple(each.convention for each in self.trials if each.error <= most)


def check_motion(samples: Sequence[Sample]) -> Verdict:
    """Try all conventions on vectors and pictures.

    Parameters
    ----------
    samples : sequence of Sample
        At least one, all of one kind of file.

    Returns
    -------
    Verdict

    Raises
    ------
    InputError
        If the files are of several kinds, or the vectors are wrong by any convention: 0 everywhere
        though the pictures move, or those of Blender for a moving orthographic camera.
    """
    for sample in samples:
        sample.check_sizes()
        _refuse_other_kind(samples[0], sample)
    change = _sum(map(change_of, samples)).mean
    pairs = range(len(samples[0].vectors.pairs))
    ways = {number: [ways_of(sample, number) for sample in samples] for number in pairs}
    still = _sum(each.still for of_pair in ways.values() for each in of_pair)
    # A small thing that moves is all that counts, whatever stands still around it.
    if (still.mean if still.pixels else change) < LEAST_CHANGE:
        return Verdict(None, f"the pictures do not move; {_FASTER}", change)
    if _are_zero(samples):
        raise InputError(
            f"{samples[0].name}: all vectors are 0 although the pictures move; Blender writes such "
            "vectors when motion blur is on: turn it off and render them again"
        )
    trials = tuple(sorted(_trials(samples, ways), key=lambda trial: trial.error))
    if trials and trials[0].error <= LEAST_GAIN * still.mean:
        return _judged(trials, still.mean, samples[0].vectors.dialect)
    _refuse_orthographic(samples)
    if trials:
        why = (
            "no convention explains the pictures much better than no motion does; are the vectors "
            f"of these frames? If the shot is slow, {_FASTER}"
        )
        return Verdict(None, why, still.mean, trials)
    why = f"all vectors are shorter than half a pixel, or lead outside; {_FASTER}"
    return Verdict(None, why, change)


def _judged(trials: tuple[Trial, ...], still: float, dialect: str) -> Verdict:
    """The best, or as good a one that the file's names tell."""
    alike = Verdict(None, "", still, trials).alike
    told = CONVENTIONS.get(dialect)
    chosen = told if told in alike else alike[0]
    others = ", ".join(each.name for each in alike if each is not chosen)
    why = f"in this shot {others} would lead to the same places" if others else ""
    return Verdict(chosen, why, still, trials)


def _trials(samples: Sequence[Sample], ways: dict[int, list[Ways]]):
    """All conventions for this number of channels, as far as there are pictures for them."""
    dialect, count = samples[0].vectors.dialect, len(ways)
    programs = [name for name in PROGRAMS if len(CONVENTIONS[name].leads) == count]
    if count == 1:  # own and flo mean the same
        programs = [FLO if dialect == OTHER else dialect]
    for convention in CONVENTIONS.values():
        if convention.name.startswith(tuple(programs)):
            found = _sum(
                each.along.get((lead, convention.is_swapped), Difference())
                for number, lead in enumerate(convention.leads)
                for each in ways[number]
            )
            if found.pixels:
                yield Trial(convention, found.mean)


def _refuse_other_kind(first: Sample, sample: Sample) -> None:
    """Refuse vectors with another number of pairs than the first have."""
    channels, others = (2 * len(each.vectors.pairs) for each in (first, sample))
    if channels != others:
        raise InputError(
            f"{sample.name}: has vectors of {others} channels, and {first.name} of {channels}; "
            "name files of one kind"
        )


def _are_zero(samples):
    pairs = (pair for sample in samples for pair in sample.vectors.pairs if pair is not None)
    return not any(pair.any() for pair in pairs)


def _refuse_orthographic(samples: Sequence[Sample]) -> None:
    """Refuse vectors that lead into the frames before and after in the same direction.

    Blender projects the neighbouring frames of an orthographic camera with a perspective one. That
    adds the same vector to both directions. Without it, the pictures agree.
    """
    blender = CONVENTIONS[BLENDER]
    if len(samples[0].vectors.pairs) != len(blender.leads):
        return
    found = [halves_of(sample, blender.fields(sample.vectors)) for sample in samples]
    halves = [each for each in found if each is not None]
    common, opposite = (sum(each[k] for each in halves) for k in (0, 1))
    along = _sum(each.along_opposite for each in halves).mean
    still = _sum(each.still for each in halves).mean
    if common > opposite and along < LEAST_GAIN * still:
        raise InputError(
            f"{samples[0].name}: its vectors lead into the frames before and after in the same "
            f"direction, by {common / len(halves):.1f} pixels; without that they explain the "
            "pictures; Blender writes such vectors when an orthographic camera moves: use a "
            "perspective camera"
        )


def _sum(differences):
    total = Difference()
    for difference in differences:
        total = total.with_more(difference)
    return total
