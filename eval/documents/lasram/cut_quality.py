"""How near approximate cuts come to the best closed ones (section 4, "Approximate cut quality")."""

import itertools
import time
from dataclasses import dataclass

import numpy as np
import pandas as pd

from eval.device import processor
from eval.documents.lasram.cut_trials import try_cuts
from eval.documents.lasram.printed import CUTS
from eval.outcome import Outcome
from eval.runs.store import stored
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.texture.formulae.polar import WEIGHTINGS
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession

PLACES = {"E zero": False, "in the midst of a synthesis": True}
"""What patches are laid over: the exemplar itself, or a texture with seams that cuts hide."""

RADIUS, JUMP, BEGUN = 128, 4, 6
"""R and J_max of all trials, and the iterations that a texture in the midst has had."""

_CODE = code_digest(__file__, without=("gpu_cuda",))


@dataclass(frozen=True)
class CutQuality:
    """Trials of cuts on one exemplar: random patches at random places.

    Attributes
    ----------
    name : str
        What it is called in messages.
    weighting : {"arc_length", "printed"}
    hides : bool
        Whether patches are laid over a texture in the midst of its synthesis, whose seams count.
        Else they are laid over the exemplar, wrapped, and no seam counts.
    trials : int
    """

    name: str
    weighting: str
    hides: bool
    trials: int

    cost = 20.0

    @property
    def code(self):
        """Digest of the algorithm."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, texture, seed, progress=None):
        """Do the trials.

        Parameters
        ----------
        texture : Texture
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            What the patches were laid over; the history has a row for every trial.
        """
        begun = time.perf_counter()
        images = [texture.exemplar]
        if self.hides:
            before = TextureSession(images, texture.shape, TextureParams(), seed=seed)
            for _ in range(BEGUN):
                before.step()
            start = before.coordinates
        else:
            y, x = np.indices(texture.exemplar.shape[:2])
            start = np.stack([0 * y, 4 * y, 4 * x], axis=-1).astype(np.int32)
        params = TextureParams(radius=RADIUS, max_jump=JUMP, weighting=self.weighting)
        session = TextureSession(images, start.shape[:2], params, start=start)
        rng = np.random.default_rng(seed)
        found = try_cuts(
            session,
            rng.integers(0, session.size, (self.trials, 2)),
            rng.choice(session.exemplars.centres(RADIUS), self.trials),
            hides=self.hides,
        )
        possible = np.isfinite(found.every)
        history = pd.DataFrame(
            {
                "first": found.first,
                "second": found.second,
                "optimum": found.optimum,
                "rank of first": found.rank(found.first),
                "rank of second": found.rank(found.second),
                "all": np.where(possible, found.every, 0).sum(axis=1) / possible.sum(axis=1),
            }
        )
        return Outcome(session.image, time.perf_counter() - begun, history=history)


def trials(plan, place, weighting):
    """All trials of the nine exemplars, a row for each."""
    jobs = [plan.cuts(name, weighting, PLACES[place]) for name in plan.exemplars]
    return pd.concat([stored(job).history for job in jobs], ignore_index=True)


def cut_quality(plan):
    """The published table beside ours.

    Parameters
    ----------
    plan : Plan

    Returns
    -------
    pandas.DataFrame
        The paper's row, and one for each weighting, place and number of passes.
    """
    rows = [CUTS]
    for weighting, place in itertools.product(WEIGHTINGS, PLACES):
        found = trials(plan, place, weighting)
        for passes, name in (("one", "first"), ("two", "second")):
            setup = {"weighting": weighting, "laid over": place, "passes": passes}
            rows.append(setup | summary(found, name))
    return pd.DataFrame(rows)


def ratios(cut, optimum):
    """How near each cut comes to its optimum.

    Where the optimum costs something, what the cut costs over it: at least 1. Where it gains, what
    the cut gains over it: at most 1. 0 over 0 counts as 1; of nothing, anything is infinitely much.

    Parameters
    ----------
    cut, optimum : (n,) float64

    Returns
    -------
    (n,) float64
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(cut == optimum, 1.0, cut / optimum)


def summary(found, name):
    """A row of the table.

    Where cuts gain on the mean, ratios are gains over optimal gains. A patch whose optimum gains
    nothing is counted the other way round there, so that 1 is always the best.

    Parameters
    ----------
    found : pandas.DataFrame
        From :func:`trials`.
    name : {"first", "second"}

    Returns
    -------
    dict of str to float
    """
    cut, optimum = found[name].to_numpy(), found["optimum"].to_numpy()
    gains = optimum.mean() < 0
    each = ratios(cut, optimum)
    if gains:
        each = np.where(optimum < 0, each, ratios(optimum, cut))
    ordered = np.sort(each)[:: -1 if gains else 1]  # the worst last
    return {
        "trials": len(found),
        "optimal cut, mean": optimum.mean(),
        "approximate cut, mean": cut.mean(),
        "ratio of means": cut.mean() / optimum.mean(),
        "mean of ratios": each.mean(),
        "median of ratios": np.median(each),
        "best 95 %, mean": ordered[: int(0.95 * len(ordered))].mean(),
        "rank of 256": found[f"rank of {name}"].mean(),
        "ranked first": (cut == optimum).mean(),
        "all cuts, mean": found["all"].mean(),
    }
