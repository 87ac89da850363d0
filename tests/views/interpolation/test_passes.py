"""Every pass against a twin that anyone can read."""

import numpy as np
import pytest
from scipy.ndimage import distance_transform_edt

from stylit_ref.realtime.formulae.packed_nnf import entries_of, places_of
from stylit_ref.views.interpolation import passes
from stylit_ref.views.interpolation.camera import Camera
from stylit_ref.views.interpolation.formulae.transfer import rays_of, transfer_of
from stylit_ref.views.interpolation.mesh_geometry import look_at_mesh
from stylit_ref.views.interpolation.painting import make_style, pixels_of, search_among, vote
from stylit_ref.views.mesh import make_mesh

SIZE = 15, 19
CAMERA = Camera((0.3, 1.2, 4.0), (0.1, 0.4, 0.0), 35)


def triangles_of(seed, count=6):
    """Random triangles, among them one that reaches behind the camera."""
    corners = np.random.default_rng(seed).uniform(-1.5, 1.5, (count, 3, 3)).astype(np.float32)
    ground = np.float32([[[-9, -0.5, 9], [9, -0.5, 9], [0, -0.5, -9]]])
    corners = np.concatenate([corners, ground])
    return make_mesh(corners.reshape(-1, 3), np.arange(len(corners) * 3).reshape(-1, 3))


def rays(camera, size):
    matrix, eye = rays_of(camera.matrix(size))
    y, x = np.mgrid[: size[0], : size[1]]
    return np.stack([x, y, np.ones_like(x)], axis=-1) @ matrix.T, eye


def nearest_triangle(mesh, camera, size):
    """The first triangle that each ray meets, by Cramer's rule: (triangles, inverse)."""
    directions, eye = rays(camera, size)
    found, inverse = np.full(size, -1), np.zeros(size)
    for number, face in enumerate(mesh.faces):
        a, b, c = mesh.vertices[face].astype(np.float64)
        for pixel in np.ndindex(size):
            system = np.stack([b - a, c - a, -directions[pixel]], axis=1)
            u, v, depth = np.linalg.solve(system, eye - a)
            near = 0.01 * np.linalg.norm(np.subtract(camera.target, camera.origin))
            if u >= 0 and v >= 0 and u + v <= 1 and depth > near and 1 / depth > inverse[pixel]:
                found[pixel], inverse[pixel] = number, 1 / depth
    return found, inverse


@pytest.mark.parametrize("seed", range(3))
def test_rasterize_finds_what_rays_meet(seed):
    mesh = triangles_of(seed)
    triangles, inverse = look_at_mesh(mesh, CAMERA, SIZE)
    expected, expected_inverse = nearest_triangle(mesh, CAMERA, SIZE)
    assert 0 < (triangles >= 0).mean() < 1
    np.testing.assert_array_equal(triangles, expected)
    np.testing.assert_allclose(inverse, expected_inverse, rtol=1e-9)


def test_triangles_that_share_edges_leave_no_gap():
    # Corners at pixels, and edges through them: where rounding would tear a surface.
    side = 8
    y, x = np.mgrid[:side, :side].reshape(2, -1)
    vertices = np.stack([x - 3.5, 3.5 - y, 0.3 * (x * y % 3)], axis=1)
    corner = np.arange(side * side).reshape(side, side)
    one, two, three, four = (
        corner[a:][: side - 1, b:][:, : side - 1].ravel() for a in (0, 1) for b in (0, 1)
    )
    faces = np.concatenate([np.stack([one, two, four], 1), np.stack([one, four, three], 1)])
    camera = Camera((0, 0, 9), (0, 0, 0), 60)
    mesh = make_mesh(vertices, faces)
    triangles, _ = look_at_mesh(mesh, camera, (61, 61))
    seen = triangles >= 0
    rows, columns = np.nonzero(seen)
    inside = seen[rows.min() + 3 : rows.max() - 2, columns.min() + 3 : columns.max() - 2]
    assert inside.size > 400
    assert inside.all()


def test_transfer_follows_points_and_leaves_the_sky():
    other = Camera((1.0, 1.5, 4.2), (0.1, 0.4, 0.0), 35)
    inverse = np.random.default_rng(4).uniform(0.1, 0.5, SIZE)
    inverse[:5] = 0
    matrices = CAMERA.matrix(SIZE), other.matrix(SIZE)
    motion = np.empty((1, *SIZE, 2), np.float32)
    passes.transfer(inverse, transfer_of(*matrices)[None], motion)
    assert not motion[0, :5].any()
    directions, eye = rays(CAMERA, SIZE)
    points = eye + directions[5:] / inverse[5:, :, None]
    across, down, depth = np.moveaxis(points @ matrices[1][:, :3].T + matrices[1][:, 3], -1, 0)
    y, x = np.mgrid[5 : SIZE[0], : SIZE[1]]
    expected = np.stack([across / depth - x, down / depth - y], axis=-1)
    np.testing.assert_allclose(motion[0, 5:], expected, atol=1e-4)


def shifting(seed):
    """Random motion with far and endless vectors, labels, silhouettes: the arguments of shift."""
    rng = np.random.default_rng(seed)
    motion = rng.normal(0, 4, (2, *SIZE, 2)).astype(np.float32)
    motion[0, 3, 4] = np.inf
    motion[1, 5, 6, 0] = -1000
    labels = rng.integers(-1, 2, SIZE, dtype=np.int32)
    beside = np.stack(np.mgrid[: SIZE[0], : SIZE[1]], axis=-1).astype(np.int32)
    beside[::3, ::2] = rng.integers(0, SIZE[0], beside[::3, ::2].shape)
    view_labels = rng.integers(-1, 2, (3, *SIZE), dtype=np.int32)
    return motion, labels, beside, view_labels, np.array([2, 0])


def held_at(place):
    """The pixel of a place, masked or not."""
    return tuple(places_of(place if place >= 0 else ~place))


def test_shift_follows_the_motion_and_masks_by_face():
    motion, labels, beside, view_labels, views = arguments = shifting(5)
    places = np.empty((2, *SIZE), np.int32)
    passes.shift(*arguments, places)
    masked = 0
    for k, y, x in np.ndindex(places.shape):
        taken = tuple(beside[y, x])
        step = motion[k][taken]
        is_near = abs(step[0]) <= SIZE[1] and abs(step[1]) <= SIZE[0]
        column, row = np.floor((x, y) + step.astype(np.float64) + 0.5) if is_near else (x, y)
        held = min(max(row, 0), SIZE[0] - 1), min(max(column, 0), SIZE[1] - 1)
        held = tuple(map(int, held))
        is_inside = is_near and held == (row, column)
        is_shown = is_inside and view_labels[views[k]][held] == labels[taken]
        masked += not is_shown
        assert (places[k, y, x] >= 0) == is_shown
        assert held_at(places[k, y, x]) == held
    assert 0.2 < masked / places.size < 0.9


def shifted_places(seed):
    places = np.empty((2, *SIZE), np.int32)
    arguments = shifting(seed)
    passes.shift(*arguments, places)
    return places, arguments[-1]


def test_fetch_takes_the_first_view_that_shows_the_point():
    places, views = shifted_places(6)
    nnfs = np.random.default_rng(7).integers(0, 900, (3, *SIZE), dtype=np.int32)
    candidates, nnf = np.empty_like(places), np.empty(SIZE, np.int32)
    passes.fetch(nnfs, views, places, candidates, nnf)
    for y, x in np.ndindex(SIZE):
        entries = [
            nnfs[view][tuple(places_of(place))] if place >= 0 else -1
            for view, place in zip(views, places[:, y, x], strict=True)
        ]
        assert list(candidates[:, y, x]) == entries
        shown = [entry for entry in entries if entry >= 0]
        held = nnfs[views[0]][held_at(places[0, y, x])]
        assert nnf[y, x] == (shown[0] if shown else held)
    assert (candidates < 0).all(axis=0).any()


def test_mix_is_the_weighted_mean():
    pictures = np.random.default_rng(8).integers(0, 256, (3, *SIZE, 3), dtype=np.uint8)
    weights = np.array([40000, 25000, 536])
    mixed = np.empty_like(pictures[0])
    passes.mix(pictures, weights, mixed)
    mean = np.einsum("k,kyxc->yxc", weights, pictures.astype(np.int64)) / 65536
    np.testing.assert_array_equal(mixed, np.floor(mean + 0.5))


@pytest.mark.parametrize("weights", [(40000, 25536), (65536, 0)])
def test_masked_pictures_are_not_mixed_in(weights):
    places, views = shifted_places(9)
    pictures = np.random.default_rng(10).integers(0, 256, (3, *SIZE, 3), dtype=np.uint8)
    mixed = np.empty_like(pictures[0])
    passes.mix_shifted(pictures, views, places, np.array(weights), mixed)
    for y, x in np.ndindex(SIZE):
        found = [
            (weight, pictures[view][tuple(places_of(place))].astype(np.int64))
            for weight, view, place in zip(weights, views, places[:, y, x], strict=True)
            if place >= 0
        ]
        whole = sum(weight for weight, _ in found)
        held = pictures[views[0]][held_at(places[0, y, x])]
        expected = found[0][1] if found else held
        if whole:
            expected = np.floor(sum(w * value for w, value in found) / whole + 0.5)
        np.testing.assert_array_equal(mixed[y, x], expected)


def painting(seed, channels=3, width=5, size=SIZE):
    """A style, an NNF whose patches lie within it, and candidates, some masked."""
    rng, radius = np.random.default_rng(seed), width // 2
    style = rng.integers(0, 256, (12, 21, channels), dtype=np.uint8)
    last = np.array(style.shape[:2]) - radius
    nnf = rng.integers(radius, last, (*size, 2), dtype=np.int32)
    candidates = rng.integers(radius, last, (3, *size, 2), dtype=np.int32)
    candidates[1] = np.where(rng.random(size)[..., None] < 0.5, nnf, candidates[1])
    candidates[rng.random((3, *size)) < 0.4] = -1
    return style, nnf, candidates


def voted(style, nnf, radius):
    """The mean of the patches over each pixel, one by one."""
    picture = np.empty((*nnf.shape[:2], style.shape[2]), np.uint8)
    for y, x in np.ndindex(nnf.shape[:2]):
        votes = [
            style[nnf[b, a, 0] + y - b, nnf[b, a, 1] + x - a].astype(int)
            for b in range(max(y - radius, 0), min(y + radius + 1, nnf.shape[0]))
            for a in range(max(x - radius, 0), min(x + radius + 1, nnf.shape[1]))
        ]
        picture[y, x] = np.floor(np.sum(votes, axis=0) / len(votes) + 0.5)
    return picture


@pytest.mark.parametrize(
    ("channels", "width", "size"), [(3, 5, SIZE), (4, 3, SIZE), (1, 5, SIZE), (3, 5, (3, 4))]
)
def test_vote_is_the_mean_of_all_patches_over_a_pixel(channels, width, size):
    style, nnf, _ = painting(11, channels, width, size)
    found = pixels_of(vote(make_style(style, width), entries_of(nnf)), channels)
    np.testing.assert_array_equal(found, voted(style, nnf, width // 2))


def test_votes_of_the_widest_patches_do_not_overflow():
    style = np.full((30, 30, 3), 255, np.uint8)
    nnf = np.full((*SIZE, 2), 15, np.int32)
    assert (pixels_of(vote(make_style(style, 15), entries_of(nnf)), 3) == 255).all()


@pytest.mark.parametrize(("channels", "width"), [(3, 5), (4, 3)])
def test_the_limited_search_takes_what_is_strictly_better(channels, width):
    style, nnf, candidates = painting(12, channels, width)
    radius = width // 2
    made = make_style(style, width)
    picture = vote(made, entries_of(nnf))
    found = places_of(search_among(made, entries_of(nnf), entries_of(candidates), picture))
    padded = np.pad(voted(style, nnf, radius), ((radius,) * 2, (radius,) * 2, (0, 0)), mode="edge")
    changed = 0
    for y, x in np.ndindex(SIZE):
        around = padded[y : y + width, x : x + width].astype(int)
        best, chosen = None, None
        for centre in (nnf[y, x], *candidates[:, y, x]):
            if centre[0] < 0:
                continue
            b, a = centre - radius
            patch = style[b : b + width, a : a + width].astype(int)
            error = ((patch - around) ** 2).sum()
            if best is None or error < best:
                best, chosen = error, centre
        changed += (chosen != nnf[y, x]).any()
        np.testing.assert_array_equal(found[y, x], chosen)
    assert changed > 20


def test_of_equal_patches_the_chosen_one_stays():
    style = np.zeros((12, 21, 3), np.uint8)
    nnf, candidates = np.full(SIZE, 2 << 16 | 2), np.full((2, *SIZE), 3 << 16 | 3)
    made = make_style(style, 5)
    nnf, candidates = nnf.astype(np.int32), candidates.astype(np.int32)
    np.testing.assert_array_equal(search_among(made, nnf, candidates, vote(made, nnf)), nnf)


@pytest.mark.parametrize("slack", [0.0, 0.7])
def test_points_land_where_they_are_seen_and_the_nearest_wins(slack):
    rng, matrix = np.random.default_rng(13), CAMERA.matrix(SIZE)
    points = rng.uniform(-1.2, 1.2, (2, *SIZE, 3)).astype(np.float32)
    points[0, 0, 0], points[1, 0, 1] = np.nan, (0.3, 1.2, 9.0)  # no number, and behind the camera
    labels = rng.integers(-1, 5, (2, *SIZE), dtype=np.int32)
    found, inverse = np.empty(SIZE, np.int32), np.empty(SIZE)
    passes.splat_points(points, labels, np.array([1, 0]), matrix, slack, found, inverse)
    expected, nearest, best = np.full(SIZE, -1), np.zeros(SIZE), np.zeros(SIZE)
    for view in (1, 0):
        for y, x in np.ndindex(SIZE):
            across, down, depth = matrix @ (*points[view, y, x].astype(np.float64), 1)
            if labels[view, y, x] < 0 or not depth > 0:
                continue
            row, column = np.floor(down / depth + 0.5), np.floor(across / depth + 0.5)
            if 0 <= row < SIZE[0] and 0 <= column < SIZE[1]:
                pixel = int(row), int(column)
                away = (across / depth - column) ** 2 + (down / depth - row) ** 2
                if (1 - slack * away) / depth > best[pixel]:
                    best[pixel] = (1 - slack * away) / depth
                    expected[pixel], nearest[pixel] = labels[view, y, x], 1 / depth
    assert (expected >= 0).sum() > 50
    np.testing.assert_array_equal(found, expected)
    np.testing.assert_allclose(inverse, nearest)


def test_a_gap_between_four_points_is_filled_along_its_row():
    found = np.array([[-1, 1, -1], [2, -1, 3], [-1, 4, -1]], np.int32)
    inverse = np.where(found >= 0, 1 / (5.0 - found), 0)
    filled, far = np.empty_like(found), np.empty_like(inverse)
    passes.fill_holes(found, inverse, filled, far)
    assert filled[1, 1] == 2
    assert far[1, 1] == inverse[1, 0]


def test_gaps_of_a_pixel_are_filled_from_the_farther_side():
    found = np.array([[0, -1, 1, -1, -1], [0, -1, -1, -1, 2], [0, 3, 1, -1, -1]], np.int32)
    inverse = np.where(found >= 0, 1 / (found + 2.0), 0)
    filled, far = np.empty_like(found), np.empty_like(inverse)
    passes.fill_holes(found, inverse, filled, far)
    np.testing.assert_array_equal(filled, [[0, 1, 1, -1, -1], [0, -1, 1, -1, 2], [0, 3, 1, -1, -1]])
    np.testing.assert_allclose(far, np.where(filled >= 0, 1 / (filled + 2.0), 0))


def test_follow_tells_what_no_view_before_has_told():
    rng = np.random.default_rng(14)
    winners = np.stack([rng.integers(-1, side, SIZE) for side in SIZE], axis=-1).astype(np.int32)
    moved, ways = (rng.random((*many, *SIZE, 2), np.float32) for many in ((), (3,)))
    shown, landed = rng.random((3, *SIZE)) < 0.7, rng.random(SIZE) < 0.3
    before, order = landed.copy(), np.array([2, 0])
    motion = np.full((2, *SIZE, 2), -7, np.float32)
    passes.follow(winners, moved, ways, shown, order, landed, motion)
    for y, x in np.ndindex(SIZE):
        row, column = winners[y, x]
        if row < 0 or before[y, x]:
            assert (motion[:, y, x] == -7).all()
            assert landed[y, x] == before[y, x]
            continue
        assert landed[y, x]
        for k, other in enumerate(order):
            way = ways[other, row, column] - moved[row, column]
            expected = way if shown[other, row, column] else np.inf
            np.testing.assert_array_equal(motion[k, y, x], expected)


@pytest.mark.parametrize("share", [0.004, 0.03, 0.6])
@pytest.mark.parametrize("size", [SIZE, (1, 9), (40, 70)])
def test_the_closest_is_found_and_of_several_the_first_by_column_and_row(share, size):
    rng = np.random.default_rng(15)
    known = rng.random(size) < share
    known[-3:] &= known[:1]  # columns in which nothing is known below
    known.flat[rng.integers(known.size)] = True
    rows, places = np.empty(size, np.int32), np.empty((*size, 2), np.int32)
    passes.find_closest(known, rows, places)
    row, column = np.nonzero(known)
    for y, x in np.ndindex(size):
        away = (row - y) ** 2 + (column - x) ** 2
        first = np.lexsort((row, column, away))[0]
        assert tuple(places[y, x]) == (row[first], column[first])


def test_the_closest_is_that_of_scipy():
    known = np.random.default_rng(16).random((60, 90)) < 0.05
    rows, places = np.empty(known.shape, np.int32), np.empty((*known.shape, 2), np.int32)
    passes.find_closest(known, rows, places)
    found = distance_transform_edt(~known, return_distances=False, return_indices=True)
    np.testing.assert_array_equal(places, np.moveaxis(found, 0, -1))


def test_where_nothing_is_known_a_pixel_is_its_own_closest():
    rows, places = np.empty(SIZE, np.int32), np.empty((*SIZE, 2), np.int32)
    passes.find_closest(np.zeros(SIZE, np.bool_), rows, places)
    np.testing.assert_array_equal(places, np.moveaxis(np.mgrid[: SIZE[0], : SIZE[1]], 0, -1))


def test_ways_are_summed_up_by_their_shares_and_followed():
    rng = np.random.default_rng(17)
    ways = rng.normal(0, 9, (3, *SIZE, 2)).astype(np.float32)
    ways[0, 2, 3] = np.inf
    views, shares, landed = np.array([2, 0]), np.float32([0.3, 0.55]), rng.random(SIZE) < 0.4
    moved, places = np.empty((*SIZE, 2), np.float32), np.empty((*SIZE, 2), np.int32)
    passes.move(ways, views, shares, landed, moved, places)
    np.testing.assert_array_equal(moved, shares[0] * ways[2] + shares[1] * ways[0])
    outcomes = set()
    for y, x in np.ndindex(SIZE):
        column, row = np.floor((x, y) + moved[y, x].astype(np.float64) + 0.5)
        is_inside = 0 <= row < SIZE[0] and 0 <= column < SIZE[1]
        is_free = is_inside and not landed[int(row), int(column)]
        assert tuple(places[y, x]) == ((row, column) if is_free else (-1, -1))
        outcomes.add((is_inside, is_free))
    assert len(outcomes) == 3
