"""A half iteration of the search (5.2.1): propagation, then random search, at every other entry."""

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np
from numba import prange
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined
from stylit_ref.machine.kernel import kernel
from stylit_ref.machine.prefetch import prefetch
from stylit_ref.machine.vector_patch import (
    STYLE_LANES,
    alike_in_pairs,
    make_patch_ssd,
    make_widen,
    row_lanes,
)
from stylit_ref.randomness.random_stream import random_words
from stylit_ref.realtime.formulae.grid import first_centre, last_centre
from stylit_ref.realtime.formulae.packed_nnf import column_of, packed, row_of
from stylit_ref.realtime.formulae.random_candidate import random_column, random_row
from stylit_ref.realtime.passes.image import Image
from stylit_ref.realtime.passes.moving import ALL, any_moves

WORST = 2**31 - 1
"""The energy of a match that a label forbids."""

FREE = -1
"""The label of an entry that any pixel of the source may serve."""


DOWN, RIGHT = (-1, 1, 0, 0), (0, 0, -1, 1)
"""Where the neighbours of an entry are."""


class Grid(NamedTuple):
    """Where entries stand and what they may point to.

    Attributes
    ----------
    step : int
        Pixels from entry to entry.
    spacing : int
        Pixels of the images that the search reads from entry to entry; 1 for records.
    margin : int
        Pixels from a centre to the edge of the source.
    labels : (rows, columns) int16
        Labels of the entries, or :data:`FREE`; of no entries if there are none.
    source_labels : (height, width) uint8
    moving : (rows, columns) uint8
        Not 0 for the entries that are searched; of no entries if all are.
    """

    step: int
    spacing: int
    margin: int
    labels: NDArray[np.int16]
    source_labels: NDArray[np.uint8]
    moving: NDArray[np.uint8] = ALL


@inlined
def _draw(words, stream, first, draw):
    """Four random words of every other entry from ``first`` on; a loop of vector instructions."""
    for k in range(words.shape[1]):
        words[0, k], words[1, k], words[2, k], words[3, k] = random_words(
            stream, first + 2 * k, draw
        )


@inlined
def _place_beside(entry, down, right, bounds):
    """The place ``down`` and ``right`` of an entry's match, moved into the bounds."""
    first_y, last_y, first_x, last_x = bounds
    y = min(max(row_of(entry) + down, first_y), last_y)
    x = min(max(column_of(entry) + right, first_x), last_x)
    return y, x


@inlined
def _random_place(word, radius, y, x, bounds):
    first_y, last_y, first_x, last_x = bounds
    new_y = random_row(word, max(y - radius, first_y), min(y + radius, last_y))
    new_x = random_column(word, max(x - radius, first_x), min(x + radius, last_x))
    return new_y, new_x


@inlined
def _ask_for_records(
    records, origin, stride, unit, nnf, a, b, step, words, k, draws, largest_radius, bounds
):
    """Ask for the records that the search at entry (a, b) will probably read.

    Random candidates of the smaller half of the radii lie near its own match, and are left out.
    """
    entry = nnf[np.uint64(a), np.uint64(b)]
    y, x = row_of(entry), column_of(entry)
    prefetch(records, origin + y * stride + x * unit)
    for trial in range(4):
        na, nb = a + DOWN[trial], b + RIGHT[trial]
        if na < 0 or na >= nnf.shape[0] or nb < 0 or nb >= nnf.shape[1]:
            continue
        entry = nnf[np.uint64(na), np.uint64(nb)]
        new_y, new_x = _place_beside(entry, (a - na) * step, (b - nb) * step, bounds)
        prefetch(records, origin + new_y * stride + new_x * unit)
    for draw in range((draws + 1) // 2):
        word = words[np.uint64(draw), np.uint64(k)]
        new_y, new_x = _random_place(word, largest_radius >> draw, y, x, bounds)
        prefetch(records, origin + new_y * stride + new_x * unit)


@cache
def make_search(rows: int, pixels: int, lanes: int) -> Callable[..., None]:
    """Build ``search`` for patches of ``rows`` x ``pixels`` pixels of ``lanes`` bytes.

    Records of the scale space are patches of one row. The pass is called with

    - ``nnf``, (rows, columns) int32, changed in place: entries of one half read those of the other;
    - ``source``, an image of both guides and style, or of the style alone if ``lanes`` is 4;
    - ``guides`` and ``style``, images of the target of one geometry;
    - ``weights``, int16, of a row of a patch;
    - ``grid``, a :class:`Grid`;
    - ``stream`` of random numbers, ``parity`` of the half, ``largest_radius``;
    - ``stop``, (1,) uint8; once it is not 0, no further row is searched.
    """
    length = row_lanes(pixels, lanes)
    is_patch = rows > 1
    unit = lanes if is_patch else lanes * pixels
    style_unit = STYLE_LANES if is_patch else STYLE_LANES * pixels
    reach = pixels // 2 if is_patch else 0
    widen = make_widen(rows, pixels, lanes)
    ssd = make_patch_ssd(rows, length)

    @kernel(rows, pixels, lanes, nogil=True)
    def search(
        nnf: NDArray[np.int32],
        source: Image,
        guides: Image,
        style: Image,
        weights: NDArray[np.int16],
        grid: Grid,
        stream: tuple[int, int, int, int],
        parity: int,
        largest_radius: int,
        stop: NDArray[np.uint8],
    ) -> None:
        height, width = nnf.shape
        step, margin, labels, moving = grid.step, grid.margin, grid.labels, grid.moving
        first_y, last_y = first_centre(source.height, margin), last_centre(source.height, margin)
        first_x, last_x = first_centre(source.width, margin), last_centre(source.width, margin)
        bounds = first_y, last_y, first_x, last_x
        pixels_of, stride, source_labels = source.values, source.stride * unit, grid.source_labels
        origin = (source.border - reach) * (source.stride + 1) * unit
        target_origin = (style.border - reach) * (style.stride + 1)
        draws = 0
        while largest_radius >> draws > 0:
            draws += 1
        alike = alike_in_pairs(weights)
        for row in prange(height):
            a = np.int64(row)
            if stop[0] or (moving.size and not any_moves(moving, a)):
                continue
            begin = (a + parity) & 1
            entries = (width - begin + 1) // 2
            patch = np.empty(rows * length, np.int16)
            words = np.empty((draws + 3, entries), np.uint32)
            places = np.empty((0 if is_patch else draws, 2), np.int64)
            for draw in range(0, draws, 4):
                _draw(words[draw : draw + 4], stream, a * width + begin, draw // 4)
            for k in range(entries):
                b = begin + 2 * k
                if moving.size and not moving[np.uint64(a), np.uint64(b)]:
                    continue
                at = target_origin + (a * style.stride + b) * grid.spacing
                widen(
                    patch, guides.values, at * unit, style.stride * unit,
                    style.values, at * style_unit, style.stride * style_unit,
                )  # fmt: skip
                label = np.int64(FREE)
                if labels.size:
                    label = np.int64(labels[np.uint64(a), np.uint64(b)])
                entry = nnf[np.uint64(a), np.uint64(b)]
                y, x = row_of(entry), column_of(entry)
                at = origin + y * stride + x * unit
                best = np.int64(ssd(pixels_of, at, stride, patch, 0, weights, alike))
                if label != FREE and source_labels[np.uint64(y), np.uint64(x)] != label:
                    best = np.int64(WORST)
                # Records are short and far apart, so the search waits for memory.
                if not is_patch and b + 2 < width:
                    _ask_for_records(
                        pixels_of, origin, stride, unit, nnf, a, b + 2, step,
                        words, k + 1, draws, largest_radius, bounds,
                    )  # fmt: skip
                middle_y, middle_x = y, x
                for trial in range(4 + draws):
                    if trial < 4:
                        na, nb = a + DOWN[trial], b + RIGHT[trial]
                        if na < 0 or na >= height or nb < 0 or nb >= width:
                            continue
                        entry = nnf[np.uint64(na), np.uint64(nb)]
                        new_y, new_x = _place_beside(
                            entry, (a - na) * step, (b - nb) * step, bounds
                        )
                    else:
                        if trial == 4:
                            middle_y, middle_x = y, x
                            for draw in range(0 if is_patch else draws):
                                new_y, new_x = _random_place(
                                    words[np.uint64(draw), np.uint64(k)], largest_radius >> draw,
                                    y, x, bounds,
                                )  # fmt: skip
                                places[np.uint64(draw), 0] = new_y
                                places[np.uint64(draw), 1] = new_x
                                prefetch(pixels_of, origin + new_y * stride + new_x * unit)
                        draw = np.uint64(trial - 4)
                        if is_patch:
                            new_y, new_x = _random_place(
                                words[draw, np.uint64(k)], largest_radius >> (trial - 4),
                                middle_y, middle_x, bounds,
                            )  # fmt: skip
                        else:
                            new_y, new_x = places[draw, 0], places[draw, 1]
                    if new_y == y and new_x == x:
                        continue
                    if label != FREE and source_labels[np.uint64(new_y), np.uint64(new_x)] != label:
                        continue
                    # No early exit: near the best match all rows are needed, and a test costs more.
                    at = origin + new_y * stride + new_x * unit
                    found = np.int64(ssd(pixels_of, at, stride, patch, 0, weights, alike))
                    if found < best:
                        best, y, x = found, new_y, new_x
                nnf[np.uint64(a), np.uint64(b)] = packed(y, x)

    return search
