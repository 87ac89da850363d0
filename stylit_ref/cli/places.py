"""Places between the views of a grid, as words of a command line."""

import argparse
from itertools import pairwise
from math import ceil, hypot, isfinite


def place_of(text: str) -> tuple[float, float]:
    """The two numbers of ``RIGHT,UP``; the ``type`` of an option."""
    try:
        right, up = map(float, text.split(","))
    except ValueError:
        right = up = float("nan")
    if not (isfinite(right) and isfinite(up)):
        raise argparse.ArgumentTypeError(
            f"is {text!r}; it must be RIGHT,UP, two numbers such as 2.5,-1.25, from the middle of "
            "the grid"
        )
    return right, up


def path_of(text: str) -> list[tuple[float, float]]:
    """The places of ``RIGHT,UP RIGHT,UP ...``; the ``type`` of an option."""
    places = [place_of(word) for word in text.split()]
    if len(places) < 2:
        raise argparse.ArgumentTypeError(
            f"is {text!r}; it must be two places or more in quotes, such as '-5,0 5,0'"
        )
    return places


def step_of(text: str) -> float:
    """A number above 0; the ``type`` of an option."""
    try:
        step = float(text)
    except ValueError:
        step = 0.0
    if not (step > 0 and isfinite(step)):
        raise argparse.ArgumentTypeError(f"is {text!r}; it must be a number above 0")
    return step


def places_along(path: list[tuple[float, float]], step: float) -> list[tuple[float, float]]:
    """Places along straight lines, no farther apart than a step; both ends belong to them.

    Parameters
    ----------
    path : list of tuple of 2 float
        At least one place.
    step : float
        As the places count.
    """
    found = [path[0]]
    for (x, y), (other_x, other_y) in pairwise(path):
        count = max(ceil(hypot(other_x - x, other_y - y) / step - 1e-9), 1)
        for k in range(1, count + 1):
            share = k / count
            found.append((x + share * (other_x - x), y + share * (other_y - y)))
    return found
