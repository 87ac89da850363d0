"""Composed motion against points that are followed one by one, and paths in grids and sequences."""

import numpy as np

from eval.motion_paths import along, cells, compose, landing, pairs_apart, shortest_paths
from stylit_ref.views.frames import Motion, grid_pairs, sequence_pairs

SIZE = (9, 13)


def random_motion(seed):
    rng = np.random.default_rng(seed)
    field = rng.uniform(-4, 4, (*SIZE, 2)).astype(np.float32)
    return Motion(field, rng.random(SIZE) < 0.8)


def follow(y, x, motions):
    """The place of one pixel's point after some motions, or None where it is lost."""
    place = np.array([y, x], np.float64)
    for motion in motions:
        row, column = np.floor(place + 0.5).astype(int)
        if not (0 <= row < SIZE[0] and 0 <= column < SIZE[1] and motion.visible[row, column]):
            return None
        place += motion.field[row, column, ::-1].astype(np.float64)
    row, column = np.floor(place + 0.5).astype(int)
    return place if 0 <= row < SIZE[0] and 0 <= column < SIZE[1] else None


def test_composed_motion_follows_every_point():
    first, second, third = motions = [random_motion(seed) for seed in range(3)]
    composed = compose(compose(first, second), third)
    rows, columns, seen = landing(composed)
    count = 0
    for y in range(SIZE[0]):
        for x in range(SIZE[1]):
            place = follow(y, x, motions)
            assert seen[y, x] == (place is not None)
            if place is not None:
                count += 1
                np.testing.assert_allclose(composed.field[y, x, ::-1] + (y, x), place, atol=1e-5)
                assert (rows[y, x], columns[y, x]) == tuple(np.floor(place + 0.5))
    assert 5 < count < np.prod(SIZE)


def test_a_path_is_the_composition_of_its_edges():
    edges = {(0, 1): random_motion(0), (1, 2): random_motion(1)}
    composed = compose(edges[0, 1], edges[1, 2])
    found = along(edges, (0, 1, 2))
    np.testing.assert_array_equal(found.field, composed.field)
    np.testing.assert_array_equal(found.visible, composed.visible)
    assert along(edges, (0, 1)) is edges[0, 1]


def test_what_is_no_number_leads_nowhere():
    motion = random_motion(0)
    motion.field[2, 3], motion.field[4, 5, 1] = np.nan, np.inf
    *_, seen = landing(motion)
    assert not seen[2, 3]
    assert not seen[4, 5]


def test_paths_are_shortest_and_both_ways():
    edges = dict.fromkeys(grid_pairs(2, 3))
    assert shortest_paths(edges, 0)[5] == (0, 1, 2, 5)
    assert len(pairs_apart(edges, 6, 1)) == len(edges)
    sequence = dict.fromkeys(sequence_pairs(6))
    assert pairs_apart(sequence, 6, 5) == [(0, 1, 2, 3, 4, 5), (5, 4, 3, 2, 1, 0)]
    assert pairs_apart(sequence, 6, 6) == []


def test_a_grid_has_a_loop_for_each_cell_and_a_sequence_none():
    assert cells(dict.fromkeys(grid_pairs(2, 3))) == [(0, 1, 4, 3), (1, 2, 5, 4)]
    assert cells(dict.fromkeys(sequence_pairs(5))) == []
    assert cells(dict.fromkeys(sequence_pairs(4, ring=True))) == [(0, 1, 2, 3)]
