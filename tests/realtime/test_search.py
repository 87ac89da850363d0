"""A half iteration against a search that knows patches as arrays."""

import numpy as np
import pytest

from stylit_ref.machine.vector_patch import STYLE_LANES, alike_in_pairs, row_lanes
from stylit_ref.randomness.random_stream import REALTIME_SEARCH, random_stream, random_words
from stylit_ref.realtime.formulae.feature_distance import alike_where_free, lane_weights
from stylit_ref.realtime.passes import make_extend, make_fill, make_insert_style, make_search
from stylit_ref.realtime.passes.image import make_image
from stylit_ref.realtime.passes.moving import ALL
from stylit_ref.realtime.passes.search import FREE, Grid

BORDER, STEP = 8, 3


def image_of(pixels, lanes):
    image = make_image(*pixels.shape[:2], BORDER, lanes)
    make_fill(pixels.shape[2], lanes)(np.ascontiguousarray(pixels).reshape(-1), image)
    return image


def brute_search(
    nnf, energy, source, labels, source_labels, moving, margin, stream, parity, radius
):  # fmt: skip
    """The half iteration of the thesis, with one entry after another."""
    nnf = nnf.copy()
    (h, w), (rows, columns) = source, nnf.shape[:2]
    first = min(margin, (h - 1) // 2), min(margin, (w - 1) // 2)
    last = max(h - 1 - margin, first[0]), max(w - 1 - margin, first[1])
    before = nnf.copy()
    for a, b in np.ndindex(rows, columns):
        if (a + b + parity) % 2 or not moving[a, b]:
            continue

        def fits(place, label=labels[a, b]):
            return label == FREE or source_labels[place] == label

        best_place = tuple(int(k) for k in before[a, b])
        best = energy(a, b, *best_place) if fits(best_place) else 2**31 - 1
        candidates = []
        for da, db in ((-1, 0), (1, 0), (0, -1), (0, 1)):
            if 0 <= a + da < rows and 0 <= b + db < columns:
                y, x = before[a + da, b + db] - STEP * np.array((da, db))
                place = np.clip((y, x), first, last)
                candidates.append(tuple(int(k) for k in place))
        for place in candidates:
            if fits(place) and energy(a, b, *place) < best:
                best, best_place = energy(a, b, *place), place
        middle, reach, draw = best_place, radius, 0
        while reach >= 1:
            word = int(random_words(stream, a * columns + b, draw // 4)[draw % 4])
            place = []
            for k, bits in enumerate((word >> 16, word & 0xFFFF)):
                low = max(middle[k] - reach, first[k])
                high = min(middle[k] + reach, last[k])
                place.append(low + (bits * (high - low + 1) >> 16))
            place = tuple(place)
            if fits(place) and energy(a, b, *place) < best:
                best, best_place = energy(a, b, *place), place
            reach, draw = reach // 2, draw + 1
        nnf[a, b] = best_place
    return nnf


@pytest.mark.parametrize("width", [3, 5, 7])
@pytest.mark.parametrize(("channels", "mu"), [(10, 4), (10, 0), (7, 9), (13, 4), (3, 16)])
@pytest.mark.parametrize("alike", [False, True])
@pytest.mark.parametrize(("parity", "some_move"), [(0, False), (1, False), (0, True), (1, True)])
def test_against_patches_as_arrays(width, channels, mu, alike, parity, some_move):
    random = np.random.default_rng(width + mu)
    source, target = (15, 18), (13, 10)
    guides, style, aimed, picture = (
        random.integers(0, 256, (*size, count), np.uint8)
        for size, count in ((source, channels), (source, 3), (target, channels), (target, 3))
    )
    reads_guides = mu < 16
    lanes = -(-channels // 4) * 4 + STYLE_LANES if reads_guides else STYLE_LANES
    read = image_of(style, STYLE_LANES)
    if reads_guides:
        both = image_of(guides, lanes)
        make_insert_style(lanes)(read, both, 0, both.height + 2 * BORDER)
        read = both
    shown = image_of(picture, STYLE_LANES)
    target_guides = image_of(aimed, lanes) if reads_guides else shown
    guide_weights = tuple(random.integers(0, 3, channels)) if reads_guides else (1,) * channels
    if alike:
        guide_weights = tuple(np.repeat(guide_weights[::2], 2)[:channels])
    pixel = lane_weights(mu, guide_weights, "sums", lanes)
    if alike:
        pixel = alike_where_free(pixel, channels)
        assert alike_in_pairs.py_func(pixel)
    weights = np.zeros(row_lanes(width, lanes), np.int16)
    weights[: width * lanes] = np.tile(pixel, width)

    grid = -(-target[0] // STEP), -(-target[1] // STEP)
    labels = random.integers(-1, 2, grid).astype(np.int16)
    source_labels = random.integers(0, 2, source, np.uint8)
    margin = width // 2
    place = [random.integers(margin, side - margin, grid) for side in source]
    nnf = np.stack(place, -1)
    r = width // 2

    def energy(a, b, y, x):
        def patch(pixels, cy, cx):
            padded = np.pad(pixels, ((r, r), (r, r), (0, 0)), "edge").astype(int)
            return padded[cy : cy + width, cx : cx + width]

        of_guides = patch(aimed, a * STEP, b * STEP) - patch(guides, y, x)
        of_style = patch(picture, a * STEP, b * STEP) - patch(style, y, x)
        weighed = (16 - mu) * (of_guides**2 * guide_weights).sum() + mu * (of_style**2).sum()
        return weighed

    stream = random_stream(9, REALTIME_SEARCH, 1, 2, parity)
    moving = random.integers(0, 2, grid, np.uint8) if some_move else np.ones(grid, np.uint8)
    moving[2] = 1 - some_move  # a row of none
    expected = brute_search(
        nnf, energy, source, labels, source_labels, moving, margin, stream, parity, radius=9
    )
    packed = (place[0] << 16 | place[1]).astype(np.int32)
    make_search(width, width, lanes)(
        packed, read, target_guides, shown, weights,
        Grid(STEP, STEP, margin, labels, source_labels, moving if some_move else ALL),
        stream, parity, 9, np.zeros(1, np.uint8),
    )  # fmt: skip
    assert np.array_equal(np.stack([packed >> 16, packed & 0xFFFF], -1), expected)


def test_weights_of_bytes_that_are_always_0():
    def filled(guide_weights, lanes, mu=4):
        weights = lane_weights(mu, guide_weights, "sums", lanes)
        return alike_where_free(weights, len(guide_weights)).tolist()

    assert filled((1, 1, 2, 2, 3), 12) == [3, 3, 6, 6, 9, 9, 0, 0, 1, 1, 1, 1]
    assert filled((1, 1, 1), 4, mu=16) == [1, 1, 1, 1]
    assert filled((1, 2, 0, 2), 8) == [3, 6, 0, 6, 1, 1, 1, 1]


def test_a_stopped_search_changes_nothing():
    image = image_of(np.zeros((9, 9, 3), np.uint8), STYLE_LANES)
    make_extend(STYLE_LANES)(image)
    nnf = np.full((3, 3), 4 << 16 | 4, np.int32)
    none = np.zeros((0, 0), np.int16), np.zeros((0, 0), np.uint8)
    make_search(5, 5, STYLE_LANES)(
        nnf, image, image, image, np.ones(row_lanes(5, STYLE_LANES), np.int16),
        Grid(STEP, STEP, 2, *none), random_stream(1, REALTIME_SEARCH), 0, 8,
        np.ones(1, np.uint8),
    )  # fmt: skip
    assert (nnf == (4 << 16 | 4)).all()
