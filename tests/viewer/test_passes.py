"""The page's passes against Numba's: from the vote on bit for bit, fed with its shifted NNFs."""

from dataclasses import replace

import numpy as np
import pytest
from small_views import SIZE, cameras, small_views

from stylit_ref.realtime.formulae.packed_nnf import entries_of, places_of
from stylit_ref.viewer.contents import make_contents
from stylit_ref.viewer.write_page import page_bytes
from stylit_ref.views.interpolation import passes
from stylit_ref.views.interpolation.mesh_geometry import MeshGeometry
from stylit_ref.views.interpolation.painting import make_style, pixels_of, search_among, vote
from stylit_ref.views.interpolation.positions_geometry import (
    PositionsGeometry,
    positions_of_mesh,
)
from stylit_ref.views.interpolation.view_interpolator import Stylized, ViewInterpolator

pytestmark = pytest.mark.slow  # a browser is a process of its own

ENGINES = "webgl", "script"
PLACES = (0.0, 0.0), (0.75, -1.0), (-2.5, 2.5), (1.75, 0.5)
BAND = 0.6


@pytest.fixture(scope="module")
def views():
    return small_views()


@pytest.fixture(scope="module")
def painting(views):
    return make_style(views.style, views.patch_width)


def reference_of(views, painting):
    frames = range(np.size(views.grid.frames))
    nnfs = np.stack([entries_of(views.view(frame)) for frame in frames])
    pictures = np.stack([pixels_of(vote(painting, nnf), 3) for nnf in nnfs])
    geometry = MeshGeometry(views.mesh, views.orbit, SIZE)
    stylized = Stylized(views.style, views.patch_width, nnfs, pictures)
    return ViewInterpolator(views.grid, geometry, stylized, BAND)


@pytest.fixture(scope="module")
def reference(views, painting):
    return reference_of(views, painting)


@pytest.fixture(scope="module", params=ENGINES)
def engine(request):
    return request.param


@pytest.fixture(scope="module")
def page(engine, open_shared_page, page_file):
    return open_shared_page(page_file, f"?engine={engine}").started()


def places_in_views(page, engine, place):
    """Where each pixel lies in the views around, as ``passes.shift`` tells it."""
    if engine == "script":
        (flat,) = page.draws(place, "nnf", "places")
        flat = np.moveaxis(flat, 2, 0)
        shown = np.where(flat < 0, ~flat, flat)
        shown = shown.astype(int)
        packed = (shown // SIZE[1]) << 16 | shown % SIZE[1]
        return np.where(flat < 0, ~packed, packed)
    first, second, hidden = page.draws(place, "nnf", "motion01", "motion23", "hidden")
    offsets = np.concatenate([first, second], axis=2).astype(int)
    found = []
    for k in range(4):
        there = np.mgrid[: SIZE[0], : SIZE[1]] + offsets[..., [2 * k + 1, 2 * k]].transpose(2, 0, 1)
        y, x = (np.clip(each, 0, side - 1) for each, side in zip(there, SIZE, strict=True))
        is_hidden = (hidden[..., 0] >> k & 1).astype(bool) | (y != there[0]) | (x != there[1])
        found.append(np.where(is_hidden, ~(y << 16 | x), y << 16 | x))
    return np.stack(found)


@pytest.mark.parametrize("place", PLACES)
def test_places_are_those_of_the_reference(page, engine, reference, place):
    found = places_in_views(page, engine, place)
    expected = reference.shift(place).places
    assert np.mean((found != expected).any(axis=0)) <= 0.002


@pytest.mark.parametrize("place", PLACES)
def test_passes_give_the_same_bytes(page, engine, reference, painting, place):
    shifted = reference.shift(place)
    own = shifted._replace(places=places_in_views(page, engine, place).astype(np.int32))
    candidates, nnf = reference.fetch(own)
    first, voted, searched, picture = page.draws(
        place, "limited", "shifted", "voted", "searched", "frame0"
    )
    assert np.array_equal(first, places_of(nnf))
    once = vote(painting, nnf)
    assert np.array_equal(voted[..., :3], pixels_of(once, 3))
    better = search_among(painting, nnf, candidates, once)
    assert np.array_equal(searched, places_of(better))
    assert (better != nnf).any()
    assert np.array_equal(picture[..., :3], pixels_of(vote(painting, better), 3))


@pytest.mark.parametrize("place", [(0.25, -0.5), (2.4, 0.1)])
def test_frames_fade_by_whole_weights(page, reference, place):
    around = reference.grid.around(place, BAND)
    weights = [weight for weight in around.fading if weight]
    names = [f"frame{k}" for k in range(len(weights))]
    *frames, mixed = page.draws(place, "fade", *names, "mixed")
    expected = np.empty((*SIZE, 3), np.uint8)
    pictures = np.stack([frame[..., :3] for frame in frames])
    passes.mix(pictures, np.array(weights), expected)
    assert len(weights) > 1
    assert np.array_equal(mixed[..., :3], expected)


@pytest.mark.parametrize("mode", ["linear", "image", "blend"])
def test_pictures_are_mixed_as_in_the_reference(page, reference, mode):
    place = (0.75, -1.0)
    (picture,) = page.draws(place, mode, "mixed")
    differ = (picture[..., :3] != reference.picture(place, mode)).any(axis=2)
    assert differ.mean() <= (0 if mode == "linear" else 0.002)


def odd_cameras():
    """Each with a lens, a tilt and a distance of its own; they do not turn around one point."""
    return [
        replace(
            camera,
            origin=tuple(np.multiply(camera.origin, 1 + 0.04 * k).tolist()),
            target=(0.1 * k, 0.05, -0.1 * k),
            field_of_view=26.0 + k,
            up=(0.03 * k, 1.0, 0.02),
            shift=(0.02 * k, -0.03),
            pixel_aspect=1.0 + 0.05 * k,
        )
        for k, camera in enumerate(cameras(2, 2))
    ]


def row_of_cameras():
    """A row, in which the views are not equally far apart."""
    return [cameras(1, 1, apart=0)[0], *cameras(1, 3, apart=7)[1:]]


def ring_of_cameras():
    return cameras(1, 9, apart=40)


@pytest.mark.parametrize(
    ("seen_by", "rows", "columns", "place"),
    [
        (odd_cameras(), 2, 2, (0.75, -1.0)),
        (row_of_cameras(), 1, 3, (2.0, 0.0)),
        (ring_of_cameras(), 1, 9, (345.0, 0.0)),
    ],
    ids=["odd", "row", "ring"],
)
def test_any_cameras(engine, open_page, tmp_path, painting, seen_by, rows, columns, place):
    views = small_views(rows, columns, seen_by=seen_by)
    reference = reference_of(views, painting)
    file = tmp_path / "page.html"
    contents = make_contents(views, title="Any cameras", band=BAND)
    file.write_bytes(page_bytes(contents))
    page = open_page(file, f"?engine={engine}").started()
    found = places_in_views(page, engine, place)
    expected = reference.shift(place).places
    assert np.mean((found[: len(expected)] != expected).any(axis=0)) <= 0.002
    (mixed,) = page.draws(place, "linear", "mixed")
    assert np.array_equal(mixed[..., :3], reference.picture(place, "linear"))


def test_styles_of_more_than_twelve_bits(engine, open_page, tmp_path):
    views = small_views(style_size=(12, 4500))
    reference = reference_of(views, make_style(views.style, views.patch_width))
    file = tmp_path / "page.html"
    contents = make_contents(views, title="A wide style", band=BAND)
    file.write_bytes(page_bytes(contents))
    page = open_page(file, f"?engine={engine}").started()
    (shifted,) = page.draws((0.0, 0.0), "nnf", "shifted")
    assert np.array_equal(shifted, places_of(reference.fetch(reference.shift((0.0, 0.0)))[1]))
    assert shifted.max() > 4095


def test_points_serve_in_place_of_a_mesh(engine, views, painting, open_page, tmp_path):
    cameras = views.orbit.cameras
    positions = [positions_of_mesh(views.mesh, camera, SIZE) for camera in cameras]
    with_points = replace(views, mesh=None, points=positions.__getitem__)
    file = tmp_path / "points.html"
    contents = make_contents(with_points, title="Points", band=BAND)
    file.write_bytes(page_bytes(contents))
    geometry = PositionsGeometry(
        np.stack([each.points for each in positions]),
        np.stack([each.labels for each in positions]),
        views.orbit,
    )
    nnfs = np.stack([entries_of(views.view(frame)) for frame in range(4)])
    stylized = Stylized(views.style, views.patch_width, nnfs, np.empty((4, 0, 0, 3), np.uint8))
    expected = ViewInterpolator(views.grid, geometry, stylized, BAND).shift((0.75, -1.0)).places
    page = open_page(file, f"?engine={engine}").started()
    found = places_in_views(page, engine, (0.75, -1.0))
    assert np.mean((found != expected).any(axis=0)) <= 0.002


def test_motion_at_every_second_pixel_is_nearly_the_same(page, reference):
    place = (0.75, -1.0)
    (picture,) = page.draws(place, "image", "mixed", motion="half")
    expected = reference.picture(place, "image")
    assert (picture[..., :3] == expected).all(axis=2).mean() > 0.7
