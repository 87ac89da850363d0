"""What the passes of an iteration share: the texture, its sources, settings, room to compute in."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.texture.formulae.polar import Polar

LOCKED, FREE_RIGHT, FREE_BELOW = 1, 2, 4
"""Bits of a lock: the pixel stays; the edge to its right, or below it, costs nothing."""


class Settings(NamedTuple):
    """The numbers that an iteration goes by, all integers.

    Attributes
    ----------
    stride, plane : int
        From a pixel of the exemplars to the one below; from one fraction of a pixel to the next.
    radius, max_jump, max_shift : int
        R, J_max, D_max.
    eta, exponent : int
        η and d of M.
    new_limit, existing_limit, hidden_limit : int
        How large costs may be while a cut is looked for
        (:class:`stylit_ref.texture.formulae.polar.CostLimits`).
    penalty : int
        What a change of the shift from one row to the next costs.
    fractions : int
        Whether S holds quarters of a pixel.
    predicate : int
        An index into :data:`PREDICATES`.
    second_pass : int
    prescreened, spread, coherence, tries : int
        How candidates are found.
    has_lock, has_labels, guide_weight : int
        Whether pixels are locked, or for one exemplar alone; the fixed-point weight of the guide, 0
        without one.
    """

    stride: int
    plane: int
    radius: int
    max_jump: int
    max_shift: int
    eta: int
    exponent: int
    new_limit: int
    existing_limit: int
    hidden_limit: int
    penalty: int
    fractions: int
    predicate: int
    second_pass: int
    prescreened: int
    spread: int
    coherence: int
    tries: int
    has_lock: int
    has_labels: int
    guide_weight: int


class Texture(NamedTuple):
    """S, what its seams cost, and what may change.

    Attributes
    ----------
    addresses : (H, W) int32
    seams_x, seams_y : (H, W) int32
    lock : (H, W) uint8
        :data:`LOCKED`, :data:`FREE_RIGHT`, :data:`FREE_BELOW`.
    labels : (H, W) uint8
        The number of the exemplar, from 1, that alone a pixel may show; 0 for any; (1, 1) without.
    guide : (H, W) int32
        The guide that each pixel should have, packed as colours are; (1, 1) without one.
    """

    addresses: NDArray[np.int32]
    seams_x: NDArray[np.int32]
    seams_y: NDArray[np.int32]
    lock: NDArray[np.uint8]
    labels: NDArray[np.uint8]
    guide: NDArray[np.int32]


class Sources(NamedTuple):
    """What patches are taken from.

    Attributes
    ----------
    colours : (n,) int32
        Planes of packed colours.
    guide_colours : (n,) int32
        Their guides; (1,) without one.
    clearance : (plane,) uint16
        How far the nearest pixel is that belongs to no exemplar or is not known, in whole pixels: 0
        for such a pixel itself.
    centres : (m,) int32
        Addresses where a patch may have its centre, those with 2 clearance > R, exemplar by
        exemplar.
    bounds, centre_bounds : (k + 1,) int64
        Where the addresses of each exemplar begin, and its centres.
    ring : (64, 2) int32
        Where candidates are compared.
    prices : (plane,) int64
        What the use of the surroundings of a centre costs a candidate.
    """

    colours: NDArray[np.int32]
    guide_colours: NDArray[np.int32]
    clearance: NDArray[np.uint16]
    centres: NDArray[np.int32]
    bounds: NDArray[np.int64]
    centre_bounds: NDArray[np.int64]
    ring: NDArray[np.int32]
    prices: NDArray[np.int64]


class Workspace(NamedTuple):
    """Room for each thread to compute in; the first axis of every array is the thread."""

    context: NDArray[np.int32]
    locked: NDArray[np.uint8]
    new_seams: NDArray[np.int32]
    costs: NDArray[np.int32]
    saved: NDArray[np.int32]
    crossing: NDArray[np.int32]
    steps: NDArray[np.int32]
    totals: NDArray[np.int32]
    row: NDArray[np.int32]
    paths: NDArray[np.int32]
    ends: NDArray[np.int32]
    line: NDArray[np.int32]
    shift_costs: NDArray[np.int32]
    shift_steps: NDArray[np.int32]
    shift_totals: NDArray[np.int32]


def make_workspace(polar: Polar, max_jump: int, max_shift: int, threads: int) -> Workspace:
    """Room for patches of one size."""
    rows, columns = polar.inside.shape
    places = polar.radius_at.size
    padded, shifts = columns + 2 * max_jump, 2 * max_shift + 3
    widest = max(padded, shifts)

    def room(*shape):
        return np.zeros((threads, *shape), np.int32)

    return Workspace(
        context=room(4, places),
        locked=np.zeros((threads, places), np.uint8),
        new_seams=room(2, places),
        costs=room(2, places),
        saved=room(rows, columns),
        crossing=room(rows, padded),
        steps=room(rows, padded),
        totals=room(rows + 1, padded),
        row=room(4, widest),
        paths=room(3, rows),
        ends=room(2, widest + 1),
        line=room(9, rows + 2 * max_shift),
        shift_costs=room(rows, shifts),
        shift_steps=room(rows, shifts),
        shift_totals=room(rows + 1, shifts),
    )
