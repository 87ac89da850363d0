"""Cameras, and those between the cameras of a grid."""

import numpy as np
import pytest

from data_gen.camera import HOUSE
from stylit_ref import InputError
from stylit_ref.views.interpolation.camera import Camera, read_camera
from stylit_ref.views.interpolation.formulae.transfer import (
    plane_depths,
    projected,
    transfer_of,
    transferred,
)
from stylit_ref.views.interpolation.orbit import angles_of, orbit_of

SIZE = 30, 44
FACTS = {"origin": [3, 2, 5.0], "target": [0, 1, 0], "field_of_view": 40}


def of_house(azimuth, elevation):
    return Camera(*HOUSE.at(azimuth, elevation))


def house_grid(azimuths=(20, 25, 30), elevations=(8, 13)):
    return [of_house(azimuth, elevation) for elevation in elevations for azimuth in azimuths]


def seen(camera, point, size=SIZE):
    return projected.py_func(camera.matrix(size), np.float32(point))


def test_a_camera_sees_as_the_renderer_does():
    points = np.random.default_rng(1).uniform(-4, 4, (20, 3)).astype(np.float32)
    expected = HOUSE.at(20, 10).project(points.astype(np.float64), *SIZE)
    found = [seen(of_house(20, 10), point)[1::-1] for point in points]
    np.testing.assert_allclose(found, expected, atol=1e-9)


def test_a_point_behind_is_not_seen():
    camera = Camera((0, 0, 5), (0, 0, 0), 40)
    assert np.isnan(seen(camera, (0, 0, 6))).all()
    assert not np.isnan(seen(camera, (0, 0, 4))).any()


def test_a_shifted_lens_moves_the_picture():
    plain, moved = (Camera((0, 0, 5), (0, 0, 0), 40, shift=s) for s in ((0, 0), (0.1, 0.2)))
    x, y, _ = seen(plain, (1, 1, 0))
    assert seen(moved, (1, 1, 0))[:2] == pytest.approx((x - 0.1 * SIZE[0], y + 0.2 * SIZE[0]))


def test_wide_pixels_hold_more():
    plain, wide = (Camera((0, 0, 5), (0, 0, 0), 40, pixel_aspect=a) for a in (1.0, 2.0))
    middle = (SIZE[1] - 1) / 2
    x, y, _ = seen(plain, (1, 1, 0))
    assert seen(wide, (1, 1, 0))[:2] == pytest.approx((middle + (x - middle) / 2, y))


def test_where_a_pixel_appears_to_another_camera():
    one, other = of_house(20, 10), of_house(27, 14)
    transfer = transfer_of(one.matrix(SIZE), other.matrix(SIZE))
    for point in np.random.default_rng(2).uniform(-3, 3, (20, 3)).astype(np.float32):
        x, y, inverse = seen(one, point)
        found = transferred.py_func(transfer, x, y, inverse)
        assert found == pytest.approx(seen(other, point)[:2], abs=1e-6)


def test_what_lies_behind_the_other_camera_is_infinitely_far():
    one, other = Camera((0, 0, 5), (0, 0, 0), 40), Camera((0, 0, -5), (0, 0, -9), 40)
    transfer = transfer_of(one.matrix(SIZE), other.matrix(SIZE))
    assert transferred.py_func(transfer, 20.0, 15.0, 0.2) == (np.inf, np.inf)


def test_inverse_depth_is_linear_on_a_plane():
    camera = of_house(20, 10)
    corners = np.random.default_rng(3).uniform(-3, 3, (1, 3, 3))
    [(a, b, c)] = plane_depths(camera.matrix(SIZE), corners)
    for share in ((0.2, 0.3, 0.5), (0.6, 0.1, 0.3)):
        x, y, inverse = seen(camera, share @ corners[0])
        assert a * x + b * y + c == pytest.approx(inverse, rel=1e-6)


def test_cameras_between_stay_on_the_sphere():
    orbit = orbit_of(house_grid(), 2, 3)
    assert orbit.grid.columns.positions == (20, 25, 30)
    assert orbit.grid.rows.positions == (8, 13)
    between, expected = orbit.at((1.5, -2.0)), of_house(26.5, 8.5)
    np.testing.assert_allclose(between.origin, expected.origin)
    np.testing.assert_allclose(between.target, expected.target)
    assert between.field_of_view == expected.field_of_view


def test_a_camera_off_the_grid_is_met_where_it_is():
    cameras = house_grid()
    cameras[4] = of_house(25.4, 12.7)
    orbit = orbit_of(cameras, 2, 3)
    place = 0.0, orbit.grid.rows.reach[1]
    assert orbit.grid.closest(place) == 4
    found = orbit.at((orbit.grid.columns.positions[1] - orbit.grid.columns.middle, place[1]))
    np.testing.assert_allclose(found.origin, cameras[4].origin)


def test_rows_from_above_and_columns_from_the_right_are_turned_around():
    orbit = orbit_of(house_grid((30, 25, 20), (13, 8)), 2, 3)
    assert orbit.grid.columns.positions == pytest.approx((20, 25, 30))
    assert orbit.grid.frames == ((5, 4, 3), (2, 1, 0))


def test_a_ring_knows_no_beginning():
    orbit = orbit_of(house_grid((100, 220, 340), (10,)), 1, 3)
    assert orbit.grid.columns.is_ring
    np.testing.assert_allclose(orbit.at((-60.0, 0.0)).origin, of_house(40, 10).origin)


def test_cameras_that_do_not_turn_count_steps():
    cameras = [Camera((x, 0, 5), (x, 0, 0), 40) for x in (0, 1, 3)]
    orbit = orbit_of(cameras, 1, 3)
    assert orbit.grid.columns.unit == "steps"
    np.testing.assert_allclose(orbit.at((0.5, 0.0)).origin, (2, 0, 5))
    np.testing.assert_allclose(orbit.at((0.5, 0.0)).target, (2, 0, 0))


def test_scenes_whose_z_is_up_turn_as_well():
    camera = Camera((5 * np.sin(0.2), -5 * np.cos(0.2), 0), (0, 0, 0), 40, up=(0, 0, 1))
    assert angles_of(camera) == pytest.approx((np.degrees(0.2), 0, 5))


def test_facts_become_a_camera():
    assert read_camera(FACTS | {"note": "mine"}, "left") == Camera((3, 2, 5), (0, 1, 0), 40)
    assert read_camera(FACTS | {"up": [0, 0, 1]}, "left").up == (0, 0, 1)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"origin": [1, float("nan"), 2]}, r"origin of the camera of left is \[1, nan, 2\]; it mu"),
        ({"target": [1, 2]}, r"target of the camera of left is \[1, 2\]; it must be 3 finite"),
        ({"field_of_view": "wide"}, "field_of_view of the camera of left is 'wide'; it must be a"),
        ({"field_of_view": 180}, "field_of_view of the camera of left is 180; it must be more"),
        ({"pixel_aspect": 0}, "pixel_aspect of the camera of left is 0; it must be more than 0"),
        ({"target": [3, 2, 5]}, "the camera of left looks nowhere, or along its up"),
        ({"target": [3, 0, 5]}, "the camera of left looks nowhere, or along its up"),
    ],
)
def test_facts_that_are_no_camera(change, said):
    with pytest.raises(InputError, match=said):
        read_camera(FACTS | change, "left")


@pytest.mark.parametrize(
    ("facts", "said"),
    [
        (None, "there is no camera of left; the views between"),
        ({}, "there is no camera of left; the views between"),
        ({"azimuth": 3}, "the camera of left lacks 'origin', and has 'azimuth'; the views between"),
    ],
)
def test_a_camera_that_is_not_known(facts, said):
    with pytest.raises(InputError, match=said):
        read_camera(facts, "left")
