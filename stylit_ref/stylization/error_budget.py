r"""The error budget of StyLit: how many correspondences a source-to-target retrieval may keep.

This is the budget of Fišer et al. 2016, as described in Hauptfleisch 2020, 2.3.1. The sorted
errors of all correspondences resemble a hyperbola :math:`f(x) = (a - bx)^{-1}`, which is fitted to
them. Beyond its knee, :math:`f'(x_k) = 1`, correspondences are probably wrong. The budget T is the
sum of the errors up to the knee. The correspondences of the smallest errors are kept, as many as
fit into the budget (2.5).

Points that the text leaves open, and the choice made here:

- x runs from 0 at the smallest error to 1 at the largest, and the hyperbola is scaled to f(1) = 1.
  So the slope of 1 means the same at every size and in every unit. The knee then lies between 0.75
  and 1: three quarters of the correspondences are always kept.
- The fit is robust: its loss grows with a residual, not with its square. So the few largest errors,
  which can have any size, do not decide.
- A hyperbola that is too flat to have that slope, f(1) < 2 f(0), has no knee; neither have errors
  that are all equal. Then all errors are within the budget.
- If the fit does not converge, T is 0.9 times the sum of all errors, the share of Hauptfleisch
  4.1.2.
- A sum of exactly T is within the budget, although (2.5) has "<": errors of 0 must be within it,
  and so must those up to the knee. At least one correspondence is always kept.
- Correspondences that lose their target patch to a closer one, or that α refuses, spend their error
  nevertheless: the budget counts correspondences, as T does.
- Equal errors rank in the order of rows (:func:`stylit_ref.passes.claims.settle_claims`).
"""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

SHARE = 0.9
"""Budget over the sum of all errors if no hyperbola can be fitted."""

SAMPLES = 1001
"""Number of sorted errors, evenly spaced, that a hyperbola is fitted to."""


def fit_hyperbola(x: NDArray[np.float64], y: NDArray[np.float64]) -> tuple[float, float]:
    """Fit :math:`(a - bx)^{-1}`, with little influence of outliers.

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
    from scipy.optimize import least_squares  # imported late: it takes a third of the start-up time

    def residuals(ends):  # 1/f(0) and 1/f(1)
        return 1 / (ends[0] * (1 - x) + ends[1] * x) - y

    start = 2.0, 0.5
    fit = least_squares(residuals, start, bounds=(1e-9, 1e9), loss="soft_l1", f_scale=0.1)
    if not fit.success:
        raise RuntimeError(fit.message)
    first, last = fit.x
    return first, first - last


def knee(a: float, b: float) -> float:
    r"""Find the x where the slope of :math:`f(x) = (a - bx)^{-1}` over f(1) is 1; x is at most 1.

    :math:`f' = b f^2`, so :math:`a - b x_k = \sqrt{b (a - b)}`.
    """
    if a < 2 * (a - b):
        return 1.0
    return (a - np.sqrt(b * (a - b))) / b


def correspondences_within_budget(
    errors: NDArray[np.int64], budget: Literal["hyperbola"] | float
) -> int:
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
