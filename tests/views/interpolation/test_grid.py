"""Which views stand around a place: even, uneven, in a row, in a ring."""

import pytest

from stylit_ref import InputError
from stylit_ref.views.interpolation.axis import Axis, closes_ring
from stylit_ref.views.interpolation.grid import Grid

COLUMNS, ROWS = Axis((20.0, 25.0, 32.0)), Axis((8.0, 13.0, 18.0))
GRID = Grid(COLUMNS, ROWS, ((0, 1, 2), (3, 4, 5), (6, 7, 8)))


def test_places_count_from_the_middle():
    assert (COLUMNS.middle, COLUMNS.reach) == (26.0, (-6.0, 6.0))
    between = COLUMNS.around(-2.0)
    assert (between.low, between.high, between.at) == (0, 1, 24.0)


def test_a_position_begins_the_part_after_it_but_for_the_last():
    assert [COLUMNS.around(at - 26.0).low for at in (20.0, 24.9, 25.0, 31.9, 32.0)] == [
        0, 0, 1, 1, 1,
    ]  # fmt: skip


def test_the_closest_of_four_comes_first():
    # 24, 11: the distances are 1 and 2, 1 and 3, 4 and 2, 4 and 3.
    around = GRID.around((-2.0, -2.0), 0.0)
    assert around.views == (4, 1, 3, 0)


def test_ties_go_by_row_then_by_column():
    around = GRID.around((22.5 - 26, 10.5 - 13), 0.0)
    assert around.views == (0, 1, 3, 4)
    assert around.fading == (65536, 0, 0, 0)


@pytest.mark.parametrize("place", [(-6.0, -5.0), (-3.5, -2.5), (1.3, 0.1), (6.0, 5.0)])
@pytest.mark.parametrize("band", [0.0, 0.4, 1.0])
def test_weights_sum_up_to_the_whole(place, band):
    around = GRID.around(place, band)
    assert sum(around.linear) == sum(around.fading) == 65536
    assert around.linear[0] == max(around.linear)
    assert around.fading[0] == max(around.fading)


def test_on_a_view_it_counts_alone():
    around = GRID.around((-1.0, 0.0), 0.6)
    assert around.views[0] == 4
    assert around.linear == around.fading == (65536, 0, 0, 0)


def test_in_a_row_two_views_stand_around():
    row = Grid(COLUMNS, Axis((7.0,)), ((0, 1, 2),))
    assert row.around((3.0, 0.0), 0.5).views == (2, 1)
    row.check((-6.0, 0.0))
    with pytest.raises(InputError, match="1 degrees upwards lies outside of the grid, which rea"):
        row.check((0.0, 1.0))


def test_a_ring_goes_around():
    ring = Grid(Axis((0.0, 90.0, 200.0), is_ring=True), Axis((0.0,)), ((0, 1, 2),))
    assert ring.around((230.0, 0.0), 0.0).views == (2, 0)
    assert ring.around((-10.0, 0.0), 0.0).views == (0, 2)
    assert ring.around((360.0 + 10, 0.0), 0.0).views == (0, 1)
    ring.check((1000.0, 0.0))


def test_views_close_a_ring_if_no_gap_is_wider():
    assert closes_ring([0, 120, 240])
    assert closes_ring([10, 100, 200, 270])
    assert not closes_ring([0, 5, 10])
    assert not closes_ring([0, 180])


@pytest.mark.parametrize(
    ("place", "said"),
    [
        ((6.1, 0.0), "6.1 degrees to the right lies outside of the grid, which reaches from -6"),
        ((0.0, -5.5), "-5.5 degrees upwards lies outside of the grid, which reaches from -5 to 5"),
        ((float("nan"), 0.0), "nan degrees to the right lies outside"),
    ],
)
def test_places_outside_are_refused(place, said):
    with pytest.raises(InputError, match=said):
        GRID.check(place)
