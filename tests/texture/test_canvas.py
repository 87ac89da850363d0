"""S, which of its pixels may change, and what it costs."""

import numpy as np
import pytest
from small_textures import spots

from stylit_ref.randomness.random_stream import GRID, random_stream
from stylit_ref.texture.beginning import begin_with_noise
from stylit_ref.texture.canvas import make_canvas
from stylit_ref.texture.exemplars import make_exemplars
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.passes.layout import LOCKED

EXEMPLARS = make_exemplars([spots(1), spots(2, 40)], 8, fractions=False)
SIZE = 30, 44
NONE = np.zeros((1, 1), np.uint8)
STREAM = random_stream(5, GRID)


def canvas(locked=False, labels=NONE, wraps=True):
    """Noise, of which the upper half may be locked."""
    addresses, lock = np.empty(SIZE, np.int32), np.zeros(SIZE, np.uint8)
    begin_with_noise(addresses, EXEMPLARS, NONE, seed=3)
    lock[:15] = locked
    guide = np.zeros((1, 1), np.int32)
    return make_canvas(addresses, lock, labels, guide, free_band=2, wraps=wraps)


def counted(made):
    """Its cost, as the canvas counts it."""
    return made.count(EXEMPLARS, TextureParams(), np.zeros(1, np.int32), 0)


def test_all_pixels_of_a_plain_canvas_may_change():
    made = canvas()
    assert made.size == SIZE
    assert (made.free, made.has_lock, made.has_labels) == (None, False, False)
    assert len(made.cells(5, STREAM)) == 3 * 4


def test_cells_lie_where_pixels_may_change():
    made = canvas(locked=True)
    assert made.has_lock
    assert np.array_equal(made.free, np.arange(15 * 44, 30 * 44))
    counted(made)
    assert (made.cells(5, STREAM)[:, 0] >= 15).all()


def test_the_cost_is_that_of_the_seams():
    made = canvas()
    assert counted(made) == made.texture.seams_x.sum() + made.texture.seams_y.sum() > 0


def test_seams_across_a_border_that_does_not_wrap_cost_nothing():
    whole, made = canvas(), canvas(wraps=False)
    counted(whole)
    counted(made)
    assert not made.texture.seams_x[:, -1].any()
    assert not made.texture.seams_y[-1].any()
    assert np.array_equal(made.texture.seams_x[:, :-1], whole.texture.seams_x[:, :-1])
    assert np.array_equal(made.texture.seams_y[:-1], whole.texture.seams_y[:-1])


@pytest.mark.parametrize("wraps", [True, False])
def test_a_part_of_a_canvas_shares_its_pixels_and_costs_the_same(wraps):
    whole = canvas(wraps=wraps)
    mask = np.zeros(SIZE, np.uint8)
    mask[3:9, 5:11] = 1
    part = whole.only(mask)
    assert np.array_equal(part.free, np.flatnonzero(mask))
    assert np.array_equal(part.texture.lock & LOCKED, 1 - mask)
    assert part.texture.addresses is whole.texture.addresses
    assert part.has_lock
    assert counted(part) == counted(whole)
    assert not (whole.texture.lock & LOCKED).any()


def test_labels_are_free_near_their_borders():
    labels = np.ones(SIZE, np.uint8)
    labels[:, 22:] = 2
    free = (canvas(labels=labels).texture.labels == 0).all(axis=0)
    assert np.array_equal(np.flatnonzero(free), [0, 1, 20, 21, 22, 23, 42, 43])
