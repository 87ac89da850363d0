"""14. Error budget of StyLit."""

import numpy as np


def budget(errors, share):
    """Count the correspondences that a share of the error keeps."""
    total, sums = 0.0, []
    for error in errors:
        total += float(error)
        sums.append(total)
    limit = float(share) * total
    return max([1] + [k for k, running in enumerate(sums, start=1) if running <= limit])


def knee(a, b):
    """Find where the slope of 1 / (a - bx) over its value at 1 is 1."""
    with np.errstate(divide="ignore", invalid="ignore"):
        x = (a - np.sqrt(b * (a - b))) / b
    return np.where(a < 2.0 * (a - b), 1.0, x)


def stage_budget(p, a):
    """Do stage budget."""
    return {"count": budget(a["errors"], p["share"])}


def stage_knee(p, a):
    """Do stage knee."""
    return {"x": knee(a["a"], a["b"])}


STAGES = {"budget": stage_budget, "knee": stage_knee}
