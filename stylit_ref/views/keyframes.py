"""Several painted frames: those between them lean to the nearer one.

A frame f between the keyframes k and k + 1, which are the frames t_k and t_(k+1), has the place
u(f) = k + (f - t_k) / (t_(k+1) - t_k); before the first it is 0, behind the last it is K - 1. A
patch of keyframe k costs

    E + μ S² (u(f) - k)²

a pixel, where E is what it costs otherwise, in squared 8-bit steps, μ the weight of all guides, and
S = 32. So a frame that was painted takes another painting only where the guides of its own are off
by 32 steps; halfway both count alike; and between, (u - k)² - (u - k - 1)² = 2 (u - k) - 1: how
much the nearer one is preferred falls with the number of frames, along a line.

No kernel knows of it: it is one more guide, of one channel, which has a single value in every frame
and in every painting, :func:`values_of_time`.
"""

from collections.abc import Sequence

import numpy as np

STEPS = 32
"""S, in 8-bit steps. With 20 a second painting in other colours never quite takes over from the
first, which coherence carries on; with 45 all of the picture changes within a frame or two."""

_WHITE = 255


def values_of_time(frames: Sequence[int], keyframes: Sequence[int]) -> list[int]:
    """The guide of time in every frame.

    Parameters
    ----------
    frames : sequence of int
        Their numbers.
    keyframes : sequence of int
        Numbers of the frames that were painted, in ascending order, at least two.

    Returns
    -------
    list of int
        255 u / (K - 1), rounded; of a keyframe what its painting has.
    """
    last = len(keyframes) - 1
    places = np.interp(frames, keyframes, range(last + 1))
    return [int(value) for value in np.rint(_WHITE * places / last)]


def weights_with_time(weights: Sequence[float], channels: int, keyframes: int) -> tuple[float, ...]:
    """The weights of guides with that of time behind them; what the others count stays.

    Parameters
    ----------
    weights : sequence of float
        Of the other guides.
    channels : int
        How many channels they have; μ is divided among all.
    keyframes : int
        How many there are.

    Returns
    -------
    tuple of float
    """
    more = (channels + 1) / channels
    of_time = (channels + 1) * (STEPS * (keyframes - 1) / _WHITE) ** 2
    return (*(weight * more for weight in weights), of_time)
