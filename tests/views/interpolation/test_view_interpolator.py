"""Pictures of places: on a view they are its own, and change from there to the next."""

import numpy as np
import pytest
from small_run import SIZE, box_on_ground, camera_at, true_motion, write_run

from stylit_ref import InputError, views_of_run
from stylit_ref.views.frames import grid_pairs
from stylit_ref.views.interpolation import positions_geometry
from stylit_ref.views.interpolation.fields_geometry import FieldsGeometry
from stylit_ref.views.interpolation.mesh_geometry import MeshGeometry
from stylit_ref.views.interpolation.orbit import orbit_of
from stylit_ref.views.interpolation.painting import pixels_of, search_among, vote
from stylit_ref.views.interpolation.positions_geometry import (
    PositionsGeometry,
    positions_of_mesh,
    splatting_error,
)
from stylit_ref.views.interpolation.view_interpolator import MODES

CORNER, BETWEEN = (-11.0, -5.0), (-4.0, 2.0)


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return write_run(tmp_path_factory.mktemp("run"))


@pytest.fixture(scope="module")
def views(run):
    return views_of_run(run)


@pytest.mark.parametrize("mode", ["linear", "image", "blend", "nnf"])
def test_on_a_view_the_picture_is_its_own(run, views, mode):
    np.testing.assert_array_equal(views.picture(CORNER, mode), run.picture(0))


def test_the_linear_blend_is_the_weighted_mean_of_the_pictures(run, views):
    # -4 lies at 6 of 10 between -10 and 0 (the middle is 1), 2 at 7 of 10 between -5 and 5.
    across, upwards = round(0.7 * 256), round(0.7 * 256)
    weights = [(256 - across) * (256 - upwards), across * (256 - upwards)]
    weights += [(256 - across) * upwards, across * upwards]
    pictures = [run.picture(frame).astype(np.int64) for frame in (0, 1, 3, 4)]
    mean = sum(w * p for w, p in zip(weights, pictures, strict=True)) / 65536
    np.testing.assert_array_equal(views.picture(BETWEEN, "linear"), np.floor(mean + 0.5))


def test_most_points_are_found_in_the_closest_view(views):
    shifted = views.shift(BETWEEN)
    assert shifted.around.views == (4, 1, 3, 0)
    assert (shifted.places[0] >= 0).mean() > 0.8
    assert (shifted.places >= 0).any(axis=0).mean() > 0.9


def test_the_limited_search_is_a_search_and_a_vote_more(run, views):
    candidates, nnf = views.fetch(views.shift(BETWEEN))
    style = views._style
    first = vote(style, nnf)
    np.testing.assert_array_equal(views.picture(BETWEEN, "nnf"), pixels_of(first, 3))
    found = search_among(style, nnf, candidates, first)
    assert (found != nnf).any()
    expected = pixels_of(vote(style, found), 3)
    np.testing.assert_array_equal(views.picture(BETWEEN, "limited"), expected)


def test_a_fade_is_the_frame_of_the_closest_view_away_from_the_middle(views):
    np.testing.assert_array_equal(
        views.picture((-10.5, -4.5), "fade"), views.picture((-10.5, -4.5), "limited")
    )


def test_in_the_middle_frames_of_both_sides_count_alike(run):
    switching = views_of_run(run, band=0.0)
    middle = -6.0, -5.0  # azimuth -5
    left = switching.picture(middle, "limited").astype(int)
    right = switching.picture((middle[0] + 1e-9, middle[1]), "limited").astype(int)
    assert (left != right).any()
    expected = (left + right + 1) // 2
    np.testing.assert_array_equal(views_of_run(run).picture(middle, "fade"), expected)


@pytest.mark.parametrize("mode", MODES)
def test_pictures_do_not_depend_on_what_was_shown_before(run, views, mode):
    first = views.picture(BETWEEN, mode)
    views.picture(CORNER, mode)
    np.testing.assert_array_equal(views.picture(BETWEEN, mode), first)
    assert first.shape == (*SIZE, 3)


def test_what_cannot_be_shown_is_refused(views):
    with pytest.raises(InputError, match="20 degrees to the right lies outside of the grid"):
        views.picture((20.0, 0.0))
    with pytest.raises(InputError, match="mode is 'fast'; choose one of linear, image"):
        views.picture(BETWEEN, "fast")


def test_fields_tell_nearly_the_motion_of_the_mesh():
    size, mesh = (60, 80), box_on_ground()
    orbit = orbit_of([camera_at(a, e) for e in (10, 20) for a in (0, 10)], 2, 2)
    pairs = grid_pairs(2, 2)
    edges = {
        (to, other): true_motion(mesh, orbit.cameras[to], orbit.cameras[other], size)
        for to, other in pairs
    }
    meshed = MeshGeometry(mesh, orbit, size)
    (_, motion), (_, expected) = (
        geometry.look((1.0, 1.0), (3, 1, 2, 0))
        for geometry in (FieldsGeometry(edges, orbit.grid, size), meshed)
    )
    known = np.isfinite(motion).all(axis=3)
    assert known.mean() > 0.8
    apart = np.abs(motion - expected).max(axis=3)[known]
    assert np.median(apart) < 0.15
    assert np.quantile(apart, 0.95) < 1


def test_on_a_view_fields_leave_everything_where_it_is(run):
    grid, pairs = views_of_run(run).grid, grid_pairs(2, 3)
    geometry = FieldsGeometry({pair: run.motion(*pair) for pair in pairs}, grid, SIZE)
    surface, motion = geometry.look(CORNER, (0, 1, 3, 4))
    assert not motion[0].any()
    np.testing.assert_array_equal(motion[1], np.where(
        run.motion(0, 1).visible[..., None], run.motion(0, 1).field, np.inf))  # fmt: skip
    assert not surface.labels.any()


def splatted_box(size):
    """The mesh, and the points that four views of it show."""
    mesh = box_on_ground()
    orbit = orbit_of([camera_at(a, e) for e in (10, 20) for a in (0, 10)], 2, 2)
    seen = [positions_of_mesh(mesh, camera, size) for camera in orbit.cameras]
    points, labels = (np.stack(each) for each in zip(*seen, strict=True))
    return mesh, PositionsGeometry(points, labels, orbit)


def test_fewer_faces_are_wrong_where_points_beside_the_middle_count_less(monkeypatch):
    mesh, splatted = splatted_box((120, 160))

    def wrong():
        places = (1.0, 1.0), (0.0, 0.0), (2.0, -3.0)
        return sum(splatting_error(splatted, mesh, place)[1] for place in places)

    better = wrong()
    monkeypatch.setattr(positions_geometry, "SLACK", 0.0)
    assert better < 0.85 * wrong()


def test_positions_tell_nearly_the_motion_of_the_mesh():
    size = 60, 80
    mesh, splatted = splatted_box(size)
    orbit = splatted.orbit
    meshed = MeshGeometry(mesh, orbit, size)
    np.testing.assert_array_equal(splatted.view_labels(), meshed.view_labels())
    holes, wrong = splatting_error(splatted, mesh, (1.0, 1.0))
    assert holes < 0.003
    assert wrong < 0.02
    (surface, motion), (true, true_motion) = (
        geometry.look((1.0, 1.0), (0, 1)) for geometry in (splatted, meshed)
    )
    alike = (surface.labels == true.labels) & (true.labels >= 0)
    apart = np.abs(motion - true_motion)[:, alike]
    assert np.median(apart) < 0.05
    assert np.quantile(apart, 0.99) < 0.5
