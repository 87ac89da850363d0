"""Which part of an exemplar a cell is offered: at random, or the best of some by a sparse look."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined, subroutine
from stylit_ref.randomness.philox import FourWords, uniform_below
from stylit_ref.randomness.random_stream import random_words
from stylit_ref.texture.formulae.guide_cost import guide_cost
from stylit_ref.texture.formulae.polar import MARGIN
from stylit_ref.texture.formulae.seam_cost import squared_distance
from stylit_ref.texture.passes.context import Context
from stylit_ref.texture.passes.layout import LOCKED, Settings, Sources, Texture

LOOKED_AT = 64
"""Pixels that are compared when candidates are prescreened."""

_DRAWN_FOR_NEED = 8
_FIRST_DRAW_FOR_NEED = 1 << 25
"""Beyond the draws of candidates, of which there are at most 2**24."""

_LARGEST_DISTANCE = 20000
"""Squared distances above count as this: what differs altogether will be cut away."""

_GOLDEN_ANGLE = np.pi * (3 - 5**0.5)


def ring(radius: int) -> NDArray[np.int32]:
    """Offsets (y, x) spread evenly over the outer half of a disc, where cuts run.

    A spiral in steps of the golden angle, from R / 2 to R - 1; (64, 2) int32.
    """
    shares = (np.arange(LOOKED_AT) + 0.5) / LOOKED_AT
    inner, outer = radius / 2, max(radius - 1, 0)
    radii = np.sqrt(inner**2 + (outer**2 - inner**2) * shares)
    angles = np.arange(LOOKED_AT) * _GOLDEN_ANGLE
    offsets = np.stack([radii * np.sin(angles), radii * np.cos(angles)], axis=1)
    return np.floor(np.floor(offsets * (1 << 20) + 0.5) / (1 << 20) + 0.5).astype(np.int32)


@subroutine
def exemplar_in_need(
    texture: Texture,
    sources: Sources,
    settings: Settings,
    stream: FourWords,
    cell: int,
    y: int,
    x: int,
) -> int:
    """The exemplar, from 0, that the cell around the pixel (y, x) of S is offered a patch of.

    It is the one wanted, or shown, where seams cost most among some pixels that are drawn: a part
    that is still noise would otherwise wait for a cell with its centre there.
    """
    seams_x, seams_y, lock = texture.seams_x, texture.seams_y, texture.lock
    height, width = lock.shape
    side = 2 * settings.radius + 1
    most, row, column = np.int64(-1), y, x
    for k in range(_DRAWN_FOR_NEED):
        words = random_words(stream, cell, _FIRST_DRAW_FOR_NEED + k)
        there_y = (y + uniform_below(words[0], side) - settings.radius) % height
        there_x = (x + uniform_below(words[1], side) - settings.radius) % width
        cost = np.int64(seams_x[there_y, there_x]) + seams_y[there_y, there_x]
        if cost > most and not lock[there_y, there_x] & LOCKED:
            most, row, column = cost, there_y, there_x
    label = texture.labels[row, column]
    if label:
        return np.int64(label) - 1
    address = np.int64(texture.addresses[row, column]) % settings.plane
    exemplar = np.int64(0)
    while sources.bounds[exemplar + 1] <= address:
        exemplar += 1
    return exemplar


@subroutine
def find_candidate(
    texture: Texture,
    sources: Sources,
    settings: Settings,
    context: Context,
    stream: FourWords,
    cell: int,
    first_draw: int,
    exemplar: int,
    y: int,
    x: int,
) -> int:
    """The address of the centre of a patch in an exemplar, for the cell around the pixel (y, x).

    Of ``exemplar`` alone, or of any if that is -1. ``cell`` and ``first_draw`` tell the draws of a
    stream apart. Of equally near candidates, the first is taken. With a guide, its differences
    count as those of colours do, times its weight. What S uses much already is priced
    (:mod:`stylit_ref.texture.passes.use`).
    """
    addresses, colours, centres = texture.addresses, sources.colours, sources.centres
    stride, plane, radius = settings.stride, settings.plane, settings.radius
    height, width = addresses.shape
    side = 2 * (radius + MARGIN) + 1
    first, count = np.int64(0), centres.size
    least, beyond = np.int64(0), np.int64(plane)
    if exemplar >= 0:
        first = sources.centre_bounds[exemplar]
        count = sources.centre_bounds[exemplar + 1] - first
        least, beyond = sources.bounds[exemplar], sources.bounds[exemplar + 1]
    best, best_distance = np.int64(-1), np.int64(1) << 62
    for k in range(settings.prescreened):
        words = random_words(stream, cell, first_draw + k)
        candidate = np.int64(centres[first + uniform_below(words[0], count)])
        if (words[1] & 65535) < settings.coherence:
            to_y = uniform_below(words[2], 2 * radius + 1) - radius
            to_x = uniform_below(words[3], 2 * radius + 1) - radius
            there = np.int64(addresses[(y + to_y) % height, (x + to_x) % width]) % plane
            there -= to_y * stride + to_x
            clear = sources.clearance[there] if least <= there < beyond else np.uint16(0)
            if 2 * np.int64(clear) > radius:
                candidate = there
        if settings.prescreened == 1:
            return candidate
        distance = sources.prices[candidate] if settings.spread else np.int64(0)
        for n in range(LOOKED_AT):
            to_y, to_x = np.int64(sources.ring[n, 0]), np.int64(sources.ring[n, 1])
            place = (to_y + radius + MARGIN) * side + to_x + radius + MARGIN
            looked_at = candidate + to_y * stride + to_x
            distance += _limited(squared_distance(colours[looked_at], context.here[place]))
            if settings.guide_weight:
                wanted = texture.guide[(y + to_y) % height, (x + to_x) % width]
                shown = sources.guide_colours[looked_at]
                distance += guide_cost(shown, wanted, settings.guide_weight << 8)
        if distance < best_distance:
            best, best_distance = candidate, distance
    return best


@inlined
def _limited(distance):
    return distance if distance < _LARGEST_DISTANCE else np.int32(_LARGEST_DISTANCE)
