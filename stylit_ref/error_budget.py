r"""How many correspondences a source-to-target retrieval may keep: the error budget of StyLit.

Fišer et al. 2016, as told in Hauptfleisch 2020, 2.3.1: the errors of all correspondences, sorted,
resemble a hyperbola :math:`f(x) = (a - bx)^{-1}`. One is fitted; beyond its knee
:math:`f'(x_k) = 1` correspondences are probably wrong. The budget T is the sum of the errors
before the knee, and as many correspondences are kept as fit into it (2.5): those of the smallest
errors.

What the text leaves open, and what is done here:

- x runs from 0 at the smallest error to 1 at the largest, and errors are over the largest, so
  that a slope of 1 means the same at every size, in every unit.
- Errors that are all alike have no knee: all of them are within the budget.
- A fit that does not converge, or is a line, gives way to the share of Hauptfleisch 4.1.2:
  T is 0.9 times the sum of all errors.
- A sum of exactly T is within the budget, where (2.5) has "<": errors of 0 must be, and those
  before the knee are meant to be. At least one correspondence is.
- Equal errors rank in the order of rows (:func:`stylit_ref.passes.claims.settle_claims`).
"""

from warnings import catch_warnings, simplefilter

import numpy as np
from scipy.optimize import OptimizeWarning, curve_fit

SHARE = 0.9
"""Budget over the sum of all errors where no hyperbola can be fitted."""

SAMPLES = 1001
"""Of the sorted errors, evenly spaced, that a hyperbola is fitted to."""


def fit_hyperbola(x, y):
    """Fit :math:`(a - bx)^{-1}` by least squares.

    Parameters
    ----------
    x, y : (n,) float64
        From 0 to 1; y rises.

    Returns
    -------
    a, b : float

    Raises
    ------
    RuntimeError
        If the fit does not converge.
    """

    # By its two ends, 1/f(0) and 1/f(1): positive ones have no pole in between.
    def hyperbola(x, low, high):
        return 1 / (low * (1 - x) + high * x)

    start = 1 / max(float(np.median(y)), 1e-3), 1 / max(float(y[-1]), 1e-3)
    with catch_warnings():
        simplefilter("error", OptimizeWarning)
        try:
            (low, high), _ = curve_fit(hyperbola, x, y, start, bounds=(1e-6, 1e6))
        except OptimizeWarning as warning:
            raise RuntimeError(str(warning)) from None
    return low, low - high


def knee(a, b):
    r"""Find x where the slope of :math:`(a - bx)^{-1}` is 1, that is :math:`b f^2 = 1`; b > 0."""
    return (a - np.sqrt(b)) / b


def correspondences_within_budget(errors, budget):
    """Number of the smallest errors that the budget covers.

    Parameters
    ----------
    errors : (n,) int64
        Sorted, n at least 1.
    budget : "hyperbola" or float
        T is the sum of the errors before the knee, or this share of the sum of all errors.

    Returns
    -------
    int
        From 1 to n.
    """
    if errors[0] == errors[-1] and budget == "hyperbola":
        return len(errors)
    if budget == "hyperbola":
        places = np.linspace(0, len(errors) - 1, min(SAMPLES, len(errors))).astype(np.int64)
        try:
            a, b = fit_hyperbola(places / (len(errors) - 1), errors[places] / errors[-1])
        except RuntimeError:
            b = 0.0
        if b > 0:
            before_knee = int(np.ceil(np.clip(knee(a, b), 0, 1) * (len(errors) - 1)))
            return max(before_knee, 1)
        budget = SHARE
    spent = np.cumsum(errors.astype(np.float64))
    return max(int(np.searchsorted(spent, budget * spent[-1], side="right")), 1)
