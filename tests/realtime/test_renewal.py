"""The renewal of old matches, against entries that are asked one after another."""

import numpy as np
import pytest
from small_realtime import make_case, make_session

from stylit_ref.machine.vector_patch import STYLE_LANES, row_lanes
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.passes import make_fill, make_renew
from stylit_ref.realtime.passes.image import make_image
from stylit_ref.realtime.passes.search import FREE, Grid

BORDER, STEP, MARGIN, LANES = 4, 3, 2, 8


def image_of(pixels):
    image = make_image(*pixels.shape[:2], BORDER, LANES)
    make_fill(pixels.shape[2], LANES)(np.ascontiguousarray(pixels).reshape(-1), image)
    return image


def ends(side):
    return min(MARGIN, (side - 1) // 2), max(side - 1 - MARGIN, (side - 1) // 2)


def centres(rng, grid, size):
    return np.stack([rng.integers(*np.add(ends(side), (0, 1)), grid) for side in size], -1)


def entries(places):
    return (places[..., 0] << 16 | places[..., 1]).astype(np.int32)


def brute_renew(nnf, fresh, level, distance, labels, source_labels, sizes):
    """Level 0 is the first of each pair of labels, source labels and sizes."""
    out = nnf.copy()

    def fits(k, entry, place):
        return labels[k][entry] == FREE or source_labels[k][tuple(place)] == labels[k][entry]

    for entry in np.ndindex(nnf.shape[:2]):
        parent = tuple(k >> level for k in entry)
        corner = tuple(k << level for k in parent)
        own = np.array([
            np.clip(place >> level, *ends(side))
            for place, side in zip(nnf[corner], sizes[1], strict=True)
        ])  # fmt: skip
        old = distance(parent, own) > 4 * distance(parent, fresh[parent])
        if old or not fits(1, parent, own) or not fits(0, entry, nnf[entry]):
            place = [
                np.clip((f << level) + STEP * (k - c), *ends(side))
                for f, k, c, side in zip(fresh[parent], entry, corner, sizes[0], strict=True)
            ]
            if fits(0, entry, place):
                out[entry] = place
    return out


@pytest.mark.parametrize("level", [1, 2])
@pytest.mark.parametrize("labelled", [False, True])
def test_renewal_equals_one_entry_after_another(level, labelled):
    rng = np.random.default_rng(level)
    target, source = ((43, 55), (31, 42))
    coarse = [tuple(-(-side >> level) for side in size) for size in (target, source)]
    grids = [tuple(-(-side // STEP) for side in size) for size in (target, coarse[0])]
    guides = [  # a ramp, on which matches differ by much or little
        np.add.outer(9 * np.arange(size[0]), 5 * np.arange(size[1]))[..., None]
        + rng.integers(0, 9, (*size, 3))
        for size in coarse
    ]
    guides = [image.astype(np.uint8) for image in guides]
    sizes = source, coarse[1]
    nnf, fresh = (centres(rng, grid, size) for grid, size in zip(grids, sizes, strict=True))
    labels = [rng.integers(FREE, 2, grid).astype(np.int16) for grid in grids]
    source_labels = [rng.integers(0, 2, size, dtype=np.uint8) for size in sizes]

    def distance(entry, place):
        here, there = (
            np.pad(image, ((2, 2), (2, 2), (0, 0)), "edge")[y : y + 5, x : x + 5].astype(int)
            for image, (y, x) in zip(guides, (STEP * np.array(entry), place), strict=True)
        )
        return ((here - there) ** 2).sum()

    if not labelled:
        labels = [np.full(grid, FREE) for grid in grids]
    expected = brute_renew(nnf, fresh, level, distance, labels, source_labels, sizes)
    if not labelled:
        labels = [np.zeros((0, 0), np.int16)] * 2
        source_labels = [np.zeros((0, 0), np.uint8)] * 2
    fine, grid = (
        Grid(STEP, STEP, MARGIN, *both) for both in zip(labels, source_labels, strict=True)
    )
    weights = np.zeros(row_lanes(5, LANES), np.int16)
    weights[: 5 * LANES] = np.tile([1] * 3 + [0] * (LANES - 3), 5)
    found, style = entries(nnf), make_image(*coarse[0], BORDER, STYLE_LANES)
    make_renew(5, 5, LANES)(
        found, entries(fresh), level, image_of(guides[1]), image_of(guides[0]), style, weights,
        grid, *source, fine,
    )  # fmt: skip
    np.testing.assert_array_equal(found, entries(expected))
    assert 0 < (found != entries(nnf)).mean() < 1


def show(session, case, shift):
    """A target that has moved."""
    session.set_target(
        *(np.roll(image, shift, axis=1) for image in (case.target, case.target_labels))
    )


def test_a_warm_frame_after_a_cut_is_near_a_cold_one():
    """A target that shows something else: what was there is not dragged along."""
    case = make_case((40, 44), (41, 45), channels=3)
    pictures = {}
    for level in (0, 2):
        session = make_session(case, RealtimeParams(renewal_level=level))
        session.frame()
        show(session, case, 20)
        pictures[level] = session.frame(warm=True).astype(int)
    cold = session.frame().astype(int)
    error = {level: np.abs(picture - cold).mean() for level, picture in pictures.items()}
    assert error[2] < 0.9 * error[0]


def test_a_warm_frame_leaves_coarse_levels_for_a_stroke():
    """The levels that a warm frame searched from nothing are those of a cold one."""
    case = make_case((40, 44), (41, 45), channels=3)
    session, other = (make_session(case, RealtimeParams()) for _ in range(2))
    session.frame()
    for each in (session, other):
        show(each, case, 3)
    session.frame(warm=True)
    np.testing.assert_array_equal(session.frame(), other.frame())
