"""Which RUNs can be opened for views between theirs, and what is said of the others."""

import json

import numpy as np
import pytest
from small_run import AZIMUTHS, SIZE, cameras_of_grid, facts_of, write_run

from stylit_ref import InputError, Run, views_of_run, write_image, write_nnf
from stylit_ref.files.npy_file import write_arrays
from stylit_ref.views.interpolation import of_run
from stylit_ref.views.interpolation.positions_geometry import PositionsGeometry
from stylit_ref.views.mesh import make_mesh
from stylit_ref.views.run_folder import digest_of

FACTS = [facts_of(camera) for camera in cameras_of_grid()]


def changed(run, name, write):
    """The RUN with one file written anew, as if the run had done it."""
    write(run.folder / name)
    facts = run.facts | {"digests": run.facts["digests"] | {name: digest_of(run.folder / name)}}
    (run.folder / "run.json").write_text(json.dumps(facts), encoding="utf-8")
    return Run(run.folder)


def test_a_run_with_positions_serves_as_well(tmp_path):
    views = views_of_run(write_run(tmp_path, holds="positions"))
    assert views.picture((0.0, 0.0)).shape == (*SIZE, 3)


def test_a_row_of_views(tmp_path):
    cameras = cameras_of_grid(elevations=(10,))
    views = views_of_run(write_run(tmp_path, cameras, (1, 3)))
    assert views.grid.columns.positions == pytest.approx(AZIMUTHS)
    assert views.picture((5.0, 0.0)).any()


def test_a_huge_mesh_becomes_points_and_its_error_is_told(tmp_path, monkeypatch, caplog):
    caplog.set_level("INFO")
    monkeypatch.setattr(of_run, "MOST_TRIANGLES", 5)
    views = views_of_run(write_run(tmp_path))
    assert isinstance(views.geometry, PositionsGeometry)
    [said] = [record.message for record in caplog.records]
    assert "the mesh has 14 triangles, so its points in the views are carried along" in said
    assert "% of the pixels find none" in said


def test_patches_that_reach_beyond_the_style_are_moved_inside(tmp_path, caplog):
    caplog.set_level("INFO")
    run = write_run(tmp_path)
    field = run.field(0)
    field.nnf[0, :3] = 0
    views = views_of_run(changed(run, "nnfs/0.npy", lambda file: write_nnf(file, field)))
    assert "3 pixels have patches that reach beyond the style" in caplog.records[0].message
    assert views.picture((-11.0, -5.0), "nnf").any()


def test_a_mesh_of_another_scene_is_refused(tmp_path):
    run = write_run(tmp_path, motion_scale=-1.0)
    with pytest.raises(InputError, match="its mesh and cameras do not match its motion, which dif"):
        views_of_run(run)


def test_a_scene_5000_km_away_looks_the_same(tmp_path):
    far = np.array([5e6, -2e6, 3e3])
    facts = [
        camera | {key: (far + camera[key]).tolist() for key in ("origin", "target")}
        for camera in FACTS
    ]
    near, run = write_run(tmp_path / "near"), write_run(tmp_path / "far", facts=facts)
    mesh = near.mesh()
    mesh = make_mesh(mesh.vertices.astype(np.float64) + far, mesh.faces)
    run = changed(run, "mesh.npy", lambda file: write_arrays(file, list(mesh)))
    pictures = [views_of_run(each).picture((2.0, 1.0)) for each in (near, run)]
    np.testing.assert_array_equal(*pictures)


def test_positions_that_a_camera_sees_elsewhere_are_refused(tmp_path):
    feet = FACTS[4] | {key: [3.28 * each for each in FACTS[4][key]] for key in ("origin", "target")}
    run = write_run(tmp_path, facts=[*FACTS[:4], feet, FACTS[5]], holds="positions")
    with pytest.raises(InputError, match=r"0: the camera of 4 sees the points .* [1-9]\d*\.\d pi"):
        views_of_run(run)


def test_positions_behind_their_camera_are_refused(tmp_path):
    eye, target = (np.array(FACTS[0][key]) for key in ("origin", "target"))
    away = FACTS[0] | {"target": (2 * eye - target).tolist()}
    run = write_run(tmp_path, facts=[away, *FACTS[1:]], holds="positions")
    with pytest.raises(InputError, match="camera of 0 sees the points of its positions nowhere"):
        views_of_run(run)


def test_a_wrong_camera_of_any_view_is_refused(tmp_path):
    wrong = FACTS[5] | {"field_of_view": 2 * FACTS[5]["field_of_view"]}
    with pytest.raises(InputError, match=r"do not match its motion, .* from 5 to "):
        views_of_run(write_run(tmp_path, facts=[*FACTS[:5], wrong]))


def test_a_ring_of_fields_needs_the_motion_from_the_last_view_to_the_first(tmp_path):
    cameras = cameras_of_grid((0, 90, 180, 270), (10,))
    run = write_run(tmp_path, cameras, (1, 4), holds="nothing")
    with pytest.raises(InputError, match="the motion between all neighbours, such as that from 0 "):
        views_of_run(run)


def test_a_run_that_tells_nothing_of_motion_is_refused(tmp_path):
    with pytest.raises(InputError, match="holds neither a mesh, nor positions of all views, nor"):
        views_of_run(write_run(tmp_path, holds="nothing", has_motion=False))


def test_without_mesh_and_cameras_places_count_steps(tmp_path, caplog):
    caplog.set_level("INFO")
    views = views_of_run(write_run(tmp_path, holds="nothing", facts=[{}] * 6))
    assert "holds neither a mesh nor positions, so views between others" in caplog.text
    assert views.grid.columns.positions == (0, 1, 2)
    with pytest.raises(InputError, match="2 steps to the right lies outside of the grid"):
        views.picture((2.0, 0.0))


def test_one_view_has_nothing_beside_it(tmp_path):
    run = write_run(tmp_path, cameras_of_grid((0,), (10,)), (1, 1))
    with pytest.raises(InputError, match="is a grid of 1 view, and nothing lies between views"):
        views_of_run(run)


@pytest.mark.parametrize(
    ("facts", "said"),
    [
        ([{}, *FACTS[1:]], "there is no camera of 0; the views between"),
        ([*FACTS[:5], FACTS[5] | {"origin": [float("nan"), 0, 0]}], "origin of the camera of 5 is"),
    ],
)
def test_cameras_that_cannot_be_used(tmp_path, facts, said):
    with pytest.raises(InputError, match=said):
        views_of_run(write_run(tmp_path, facts=facts))


def test_views_of_different_sizes_are_refused(tmp_path):
    run = write_run(tmp_path)
    small = run.picture(2)[:-1]
    run = changed(run, "pictures/2.png", lambda file: write_image(file, small))
    with pytest.raises(InputError, match="the picture of 2 is 34x26, and its views are 34x27"):
        views_of_run(run)


def test_a_file_that_is_missing_is_named(tmp_path):
    run = write_run(tmp_path)
    (run.folder / "mesh.npy").unlink()
    with pytest.raises(InputError, match=r"mesh.npy: is missing; run.json names it"):
        views_of_run(run)


def test_patches_that_are_too_wide(tmp_path):
    with pytest.raises(InputError, match="its patches are 17 pixels wide; views between others"):
        views_of_run(write_run(tmp_path, patch_width=17))


def test_a_band_is_a_share(tmp_path):
    with pytest.raises(InputError, match=r"band is 1\.5; it must be between 0 and 1"):
        views_of_run(write_run(tmp_path), band=1.5)


def test_mesh_and_positions_come_back(tmp_path):
    run = write_run(tmp_path / "a", holds="positions")
    assert run.mesh() is None
    positions = run.positions(1)
    assert positions.points.shape == (*SIZE, 3)
    assert np.unique(positions.labels).size > 3
    run = write_run(tmp_path / "b")
    assert run.positions(1) is None
    assert run.mesh().groups.max() == 6
