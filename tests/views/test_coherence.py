"""Frames that pull at each other: what stays as it was, and what must become alike."""

from itertools import product

import numpy as np
import pytest
from small_shot import EFFORT, sliding

from stylit_ref import InputError, Params, stylize, stylize_frames
from stylit_ref.views.frames import Motion, grid_pairs, sequence_pairs
from stylit_ref.views.params import Coherence
from stylit_ref.views.stylize_views import stylize_views as stylized_views

METHODS = ("ref", "guide_map", "stylit")
ORDERS = ("parallel", "sweeps", "sequential")


def stylize_views(style, sources, guides, edges, params=None, coherence=None, **others):
    """All frames, in the order of their numbers."""
    results = stylized_views(style, sources, guides, params, coherence, edges=edges, **others)
    return sorted(results, key=lambda result: result.frame)


def difference(results, edges):
    """Mean absolute difference along the motion."""
    differences = []
    for (to, other), motion in edges.items():
        shift = int(motion.field[0, 0, 0])
        here, there = results[to].image.astype(int), results[other].image
        inside = slice(max(0, -shift), here.shape[1] - max(0, shift))
        moved = np.roll(there, -shift, axis=1)
        differences.append(np.abs(here[:, inside] - moved[:, inside]).mean())
    return np.mean(differences)


@pytest.mark.parametrize("method", METHODS)
def test_without_coherence_frames_are_those_of_stylize(method):
    style, sources, guides, edges = sliding(frames=2)
    params = Params(method=method, **EFFORT)
    alone = [stylize(style, sources, frame, params, seed=3) for frame in guides]
    for order in ORDERS:
        coherence = Coherence(weight=0, order=order)
        results = stylize_views(style, sources, guides, edges, params, coherence, seed=3)
        for result, expected in zip(results, alone, strict=True):
            assert np.array_equal(result.image, expected.image)
            assert np.array_equal(result.nnf, expected.nnf)


@pytest.mark.parametrize("method", METHODS)
def test_a_frame_without_neighbours_is_that_of_stylize(method):
    style, sources, guides, edges = sliding(frames=2)
    params = Params(method=method, **EFFORT)
    lonely = stylize_views(style, sources, [*guides, guides[0]], edges, params, seed=3)[2]
    assert np.array_equal(lonely.image, stylize(style, sources, guides[0], params, seed=3).image)


@pytest.fixture(scope="module")
def apart():
    """How much frames of each method differ that do not pull at each other."""
    style, sources, guides, edges = sliding()
    found = {}
    for method in METHODS:
        params = Params(method=method, **EFFORT)
        results = stylize_views(style, sources, guides, edges, params, Coherence(weight=0), seed=3)
        found[method] = difference(results, edges)
    return found


@pytest.mark.parametrize(
    ("method", "order", "form"),
    [
        *product(METHODS, ORDERS, ["norm"]),
        ("ref", "parallel", "plain"),
        ("stylit", "sequential", "plain"),
    ],
)
def test_coherence_makes_frames_alike(apart, method, order, form):
    style, sources, guides, edges = sliding()
    params = Params(method=method, **EFFORT)
    coherence = Coherence(weight=1, order=order, form=form)
    together = stylize_views(style, sources, guides, edges, params, coherence, seed=3)
    assert difference(together, edges) < apart[method] / 2


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("order", ORDERS)
def test_same_bytes_with_one_thread(method, order):
    style, sources, guides, edges = sliding(frames=2)
    params, coherence = Params(method, **EFFORT), Coherence(order=order)
    runs = [
        stylize_views(style, sources, guides, edges, params, coherence, threads=threads)
        for threads in (1, None)
    ]
    for one, all_threads in zip(*runs, strict=True):
        assert np.array_equal(one.image, all_threads.image)
        assert np.array_equal(one.nnf, all_threads.nnf)


def test_a_sequence_is_a_grid_of_one_row_with_its_own_coherence():
    style, sources, guides, edges = sliding(frames=2)
    params, coherence = Params(**EFFORT), Coherence(weight=1, order="sequential")
    frames = list(stylize_frames(style, sources, guides, params, edges=edges))
    views = stylize_views(style, sources, guides, edges, params, coherence)
    for frame, view in zip(frames, views, strict=True):
        assert np.array_equal(frame.image, view.image)


def test_pairs_of_a_sequence_a_ring_and_a_grid():
    assert sorted(sequence_pairs(3)) == [(0, 1), (1, 0), (1, 2), (2, 1)]
    assert sorted(sequence_pairs(3, ring=True)) == [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)]
    assert sorted(sequence_pairs(2, ring=True)) == [(0, 1), (1, 0)]
    assert sorted(grid_pairs(2, 2)) == [
        (0, 1), (0, 2), (1, 0), (1, 3), (2, 0), (2, 3), (3, 1), (3, 2),
    ]  # fmt: skip
    assert list(grid_pairs(1, 3)) == list(sequence_pairs(3))


def test_frames_of_different_sizes_are_refused():
    style, sources, guides, edges = sliding(frames=2)
    cropped = [guide[:-1] for guide in guides[1]]
    with pytest.raises(InputError, match=r"target_guides.1. is 44x37 but frame 0 is 44x38"):
        stylize_views(style, sources, [guides[0], cropped], edges)


def test_an_edge_of_another_size_or_to_no_frame_is_refused():
    style, sources, guides, edges = sliding(frames=2)
    short = Motion(edges[0, 1].field[1:], edges[0, 1].visible[1:])
    with pytest.raises(InputError, match=r"edges.0, 1. has a field of shape .37, 44, 2."):
        stylize_views(style, sources, guides, {(0, 1): short})
    with pytest.raises(InputError, match="joins frames 0 and 2; the frames are 0 to 1"):
        stylize_views(style, sources, guides, {(0, 2): edges[0, 1]})


def test_no_frame_is_refused():
    style, sources, *_ = sliding()
    with pytest.raises(InputError, match="target_guides is empty"):
        stylize_views(style, sources, [], {})
