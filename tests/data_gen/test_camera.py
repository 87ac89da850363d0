"""Cameras against each other's inverse."""

import numpy as np
import pytest

from data_gen.camera import GRID, HOUSE, STAGE, STAGE_ELEVATION, STAGE_VIEW


@pytest.mark.parametrize("camera", [STAGE_VIEW, GRID[0, 2]])
def test_a_point_along_a_pixels_ray_appears_at_that_pixel(camera):
    directions = camera.directions(9, 14)
    distance = np.linspace(1, 20, 9 * 14).reshape(9, 14, 1)
    places = camera.project(np.asarray(camera.origin) + distance * directions, 9, 14)
    assert places == pytest.approx(np.stack(np.mgrid[:9, :14], axis=-1).astype(float), abs=1e-9)


def test_the_target_appears_in_the_middle_and_up_is_up():
    places = STAGE_VIEW.project(np.array([STAGE_VIEW.target, (0, 1.5, 0), (1, 1.22, 0)]), 9, 15)
    assert places[0] == pytest.approx((4, 7))
    assert places[1][0] < 4
    assert places[2][1] > 7


def test_what_lies_behind_has_no_place():
    assert np.isnan(STAGE_VIEW.project(np.array([(0, 0, 30.0)]), 9, 15)).all()


def test_neighbours_of_the_grid_are_five_degrees_apart():
    middle = np.array(GRID[1, 1].target)
    for place, camera in GRID.items():
        for other in ((place[0], place[1] + 1), (place[0] + 1, place[1])):
            if other in GRID:
                a, b = np.array(camera.origin) - middle, np.array(GRID[other].origin) - middle
                angle = np.degrees(np.arccos(a @ b / np.linalg.norm(a) / np.linalg.norm(b)))
                assert 4.7 < angle <= 5.0 + 1e-9


def test_the_stages_orbit_begins_at_its_view():
    assert STAGE.at(0, STAGE_ELEVATION).origin == pytest.approx(STAGE_VIEW.origin)
    assert STAGE.at(-10, STAGE_ELEVATION).origin[0] < 0


def test_rows_of_a_grid_rise_and_columns_go_to_the_right():
    grid = HOUSE.grid((0, 10), (5, 15, 25))
    assert set(grid) == {(row, column) for row in range(3) for column in range(2)}
    assert grid[1, 0].origin[1] > grid[0, 0].origin[1]
    assert grid[0, 1].origin[0] > grid[0, 0].origin[0]
