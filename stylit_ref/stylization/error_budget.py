r"""How many correspondences a source-to-target retrieval may keep: the error budget of StyLit.

Fišer et al. 2016, as told in Hauptfleisch 2020, 2.3.1: the errors of all correspondences, sorted,
resemble a hyperbola :math:`f(x) = (a - bx)^{-1}`. One is fitted; beyond its knee
:math:`f'(x_k) = 1` correspondences are probably wrong. The budget T is the sum of the errors
up to the knee, and as many correspondences are kept as fit into it (2.5): those of the smallest
errors.

What the text leaves open, and what is done here:

- The slope of 1 is meant where x runs from 0 at the smallest error to 1 at the largest and
  the hyperbola ends at f(1) = 1, so that it means the same at every size and in every unit. The
  knee then lies between 0.75 and 1: three quarters of the correspondences are always kept.
- The fit is robust (a loss that grows with a residual, not its square): the few largest errors,
  which may be anything, do not decide.
- A hyperbola too flat to have that slope, f(1) < 2 f(0), has no knee, nor have errors that are
  all alike: all of them are within the budget.
- A fit that does not converge gives way to the share of Hauptfleisch 4.1.2:
  T is 0.9 times the sum of all errors.
- A sum of exactly T is within the budget, where (2.5) has "<": errors of 0 must be, and those
  before the knee are meant to be. At least one correspondence is.
- Correspondences that lose their target patch to a closer one, or that α refuses, have spent
  their error all the same: the budget is over correspondences, as T is.
- Equal errors rank in the order of rows (:func:`stylit_ref.passes.claims.settle_claims`).
"""

import numpy as np

SHARE = 0.9
"""Budget over the sum of all errors where no hyperbola can be fitted."""

SAMPLES = 1001
"""Of the sorted errors, evenly spaced, that a hyperbola is fitted to."""


def fit_hyperbola(x, y):
    """Fit :math:`(a - bx)^{-1}`, outliers counting little.

    Parameters
    ----------
    x, y : (n,) float64
        x from 0 to 1; y rises and is 1 in the middle.

    Returns
    -------
    a, b : float
        a is positive and b below it: no pole up to x = 1.

    Raises
    ------
    RuntimeError
        If the fit does not converge.
    """
    from scipy.optimize import least_squares  # here: it takes as long as a third of a start

    def residuals(ends):  # 1/f(0) and 1/f(1)
        return 1 / (ends[0] * (1 - x) + ends[1] * x) - y

    start = 2.0, 0.5
    fit = least_squares(residuals, start, bounds=(1e-9, 1e9), loss="soft_l1", f_scale=0.1)
    if not fit.success:
        raise RuntimeError(fit.message)
    first, last = fit.x
    return first, first - last


def knee(a, b):
    r"""Find x where the slope of :math:`f(x) = (a - bx)^{-1}` over f(1) is 1, at most 1.

    :math:`f' = b f^2`, so :math:`a - b x_k = \sqrt{b (a - b)}`.
    """
    if a < 2 * (a - b):
        return 1.0
    return (a - np.sqrt(b * (a - b))) / b


def correspondences_within_budget(errors, budget):
    """Number of the smallest errors that the budget covers.

    Parameters
    ----------
    errors : (n,) int64
        Sorted, n at least 1.
    budget : "hyperbola" or float
        T is the sum of the errors up to the knee, or this share of the sum of all errors.

    Returns
    -------
    int
        From 1 to n.
    """
    if budget == "hyperbola":
        if errors[0] == errors[-1]:
            return len(errors)
        places = np.linspace(0, len(errors) - 1, min(SAMPLES, len(errors))).astype(np.int64)
        middle = np.median(errors) or np.mean(errors)
        try:
            x_k = knee(*fit_hyperbola(places / (len(errors) - 1), errors[places] / middle))
            return int(x_k * (len(errors) - 1)) + 1
        except RuntimeError:
            budget = SHARE
    spent = np.cumsum(errors.astype(np.float64))
    return max(int(np.searchsorted(spent, budget * spent[-1], side="right")), 1)
