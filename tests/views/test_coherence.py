"""Frames that pull at each other: what stays as it was, and what must become alike."""

from itertools import product

import numpy as np
import pytest
from small_scene import small_scene

from stylit_ref import InputError, Params, stylize
from stylit_ref.metric.packing import ONE
from stylit_ref.views.coherence import Neighbour, pull
from stylit_ref.views.frames import Motion, grid_pairs, sequence_pairs
from stylit_ref.views.params import Coherence
from stylit_ref.views.problem import make_coherent_synthesis
from stylit_ref.views.stylize_views import stylize_views as stylized_views

METHODS = ("ref", "guide_map", "stylit")
ORDERS = ("parallel", "sweeps", "sequential")
EFFORT = {"levels": 3, "votes": 2, "patchmatch_iterations": 2}


def sliding_scene(frames=3, **sizes):
    """Guides that slide to the right by a pixel a frame, and the edges between frames."""
    style, sources, targets = small_scene(**sizes)
    size = targets[0].shape[:2]
    guides = [[np.roll(guide, k, axis=1) for guide in targets] for k in range(frames)]

    def motion(to, other):
        field = np.zeros((*size, 2), np.float32)
        field[:, :, 0] = other - to
        return Motion(field, np.ones(size, bool))

    edges = {pair: motion(*pair) for pair in sequence_pairs(frames)}
    return style, sources, guides, edges


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
    style, sources, guides, edges = sliding_scene()
    params = Params(method=method, **EFFORT)
    for order in ORDERS:
        results = stylize_views(
            style, sources, guides, edges, params, Coherence(weight=0, order=order), seed=3
        )
        for frame, result in zip(guides, results, strict=True):
            alone = stylize(style, sources, frame, params, seed=3)
            assert np.array_equal(result.image, alone.image)
            assert np.array_equal(result.nnf, alone.nnf)


@pytest.mark.parametrize("method", METHODS)
def test_a_frame_without_neighbours_is_that_of_stylize(method):
    style, sources, guides, edges = sliding_scene(frames=2)
    params = Params(method=method, **EFFORT)
    lonely = stylize_views(style, sources, [*guides, guides[0]], edges, params, seed=3)[2]
    assert np.array_equal(lonely.image, stylize(style, sources, guides[0], params, seed=3).image)


@pytest.mark.parametrize(
    ("method", "order", "form"), list(product(METHODS, ORDERS, ("norm", "plain")))
)
def test_coherence_makes_frames_alike(method, order, form):
    style, sources, guides, edges = sliding_scene()
    params = Params(method=method, **EFFORT)
    apart = stylize_views(style, sources, guides, edges, params, Coherence(weight=0), seed=3)
    coherence = Coherence(weight=1, order=order, form=form)
    together = stylize_views(style, sources, guides, edges, params, coherence, seed=3)
    assert difference(together, edges) < difference(apart, edges) / 2


@pytest.mark.parametrize("order", ORDERS)
def test_same_bytes_with_one_thread(order):
    style, sources, guides, edges = sliding_scene(frames=2)
    params, coherence = Params(**EFFORT), Coherence(order=order)
    runs = [
        stylize_views(style, sources, guides, edges, params, coherence, threads=threads)
        for threads in (1, None)
    ]
    for one, all_threads in zip(*runs, strict=True):
        assert np.array_equal(one.image, all_threads.image)
        assert np.array_equal(one.nnf, all_threads.nnf)


def explicit_delta(level, own, guides, weight, nnf):
    """δ of each assignment by equation 3.1, divided by 1 + Σ λ_c; float64 squared steps."""
    packing, width = level.packing, level.patch_width
    radius = width // 2
    source = level.textures.source.astype(float)
    target = level.textures.target.astype(float)
    total = 1 + weight * len(guides)
    costs = np.zeros(nnf.shape[:2])
    padded = [np.pad(image, ((radius, radius), (radius, radius), (0, 0)), "edge").astype(float)
              for image in (own, *guides)]  # fmt: skip
    guide_channels = range(packing.style_channel - 2)
    style = slice(packing.style_channel, packing.style_channel + packing.style_channels)
    for dy, dx in product(range(-radius, radius + 1), repeat=2):
        there = source[nnf[:, :, 0] + dy, nnf[:, :, 1] + dx]
        rows = slice(radius + dy, radius + dy + nnf.shape[0])
        columns = slice(radius + dx, radius + dx + nnf.shape[1])
        for c in guide_channels:
            weighs = packing.weights[c] / ONE
            costs += weighs * (there[:, :, c] - target[rows, columns, c]) ** 2
        for image, share in zip(padded, [1, *[weight] * len(guides)], strict=True):
            squares = ((there[:, :, style] - image[rows, columns]) ** 2).mean(axis=2)
            costs += share / total * squares
    return costs


@pytest.fixture
def level():
    """A level of StyLit in the midst of a run, whose pixels have room for the spread."""
    style, sources, guides, edges = sliding_scene(frames=2)
    params = Params(method="stylit", **EFFORT)
    synthesis = make_coherent_synthesis(style, sources, guides, edges, params)
    run = synthesis.runs[0]
    for number in run.level_numbers[:-1]:
        for _ in run.run_level(number):
            pass
    level = run.begin_level(run.level_numbers[-1])
    run.vote()
    return level


def identity(size):
    return np.stack(np.mgrid[: size[0], : size[1]], axis=-1).astype(np.int32)


def test_folded_error_is_that_of_explicit_guides_where_nothing_is_rounded(level):
    own = level.style.copy()
    sign = np.random.default_rng(0).choice([-8, 8], own.shape)
    own = np.clip(own, 8, 247)
    level.set_style(own)
    guide = (own + sign).astype(np.uint8)  # M = own ± 4 and √S = 4 exactly
    pull(level, [Neighbour(identity(own.shape[:2]), guide)], 256, with_spread=True)
    expected = explicit_delta(level, own, [guide], 1, level.nnf)
    # A style channel weighs a third, rounded to 1/65536.
    assert np.allclose(level.delta / ONE, expected, rtol=2 / ONE, atol=1e-6)


def test_folded_error_is_that_of_explicit_guides_up_to_rounding(level):
    own = level.style.copy()
    rng = np.random.default_rng(1)
    guides = [np.roll(own, k, axis=0) for k in (1, 3)]
    guides.append(rng.integers(0, 256, own.shape, dtype=np.uint8))
    neighbours = [Neighbour(identity(own.shape[:2]), guide) for guide in guides]
    pull(level, neighbours, 128, with_spread=True)
    expected = explicit_delta(level, own, guides, 0.5, level.nnf)
    assert abs(level.delta.sum() / ONE / expected.sum() - 1) < 0.005


def test_spread_decides_where_source_patches_choose():
    """Without the spread, StyLit's retrieval would pick by M alone; the results differ."""
    style, sources, guides, edges = sliding_scene()
    params = Params(method="stylit", **EFFORT)
    with_it = make_coherent_synthesis(style, sources, guides, edges, params)
    list(with_it.run())
    without = make_coherent_synthesis(style, sources, guides, edges, params)
    for run in without.runs:
        run.target.packing.weights[run.target.packing.style_channel - 2] = 0
    list(without.run())
    nnfs = zip(with_it.runs, without.runs, strict=True)
    assert any(not np.array_equal(a.level.nnf, b.level.nnf) for a, b in nnfs)


def test_pairs_of_a_sequence_a_ring_and_a_grid():
    assert sorted(sequence_pairs(3)) == [(0, 1), (1, 0), (1, 2), (2, 1)]
    assert sorted(sequence_pairs(3, ring=True)) == [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)]
    assert sorted(sequence_pairs(2, ring=True)) == [(0, 1), (1, 0)]
    assert sorted(grid_pairs(2, 2)) == [
        (0, 1), (0, 2), (1, 0), (1, 3), (2, 0), (2, 3), (3, 1), (3, 2),
    ]  # fmt: skip
    assert list(grid_pairs(1, 3)) == list(sequence_pairs(3))


def test_frames_of_different_sizes_are_refused():
    style, sources, guides, edges = sliding_scene(frames=2)
    cropped = [guide[:-1] for guide in guides[1]]
    with pytest.raises(InputError, match=r"target_guides.1. is 44x37 but frame 0 is 44x38"):
        stylize_views(style, sources, [guides[0], cropped], edges)


def test_an_edge_of_another_size_or_to_no_frame_is_refused():
    style, sources, guides, edges = sliding_scene(frames=2)
    short = Motion(edges[0, 1].field[1:], edges[0, 1].visible[1:])
    with pytest.raises(InputError, match=r"edges.0, 1. has a field of shape .37, 44, 2."):
        stylize_views(style, sources, guides, {(0, 1): short})
    with pytest.raises(InputError, match="joins frames 0 and 2; the frames are 0 to 1"):
        stylize_views(style, sources, guides, {(0, 2): edges[0, 1]})


def test_no_frame_is_refused():
    style, sources, *_ = sliding_scene()
    with pytest.raises(InputError, match="target_guides is empty"):
        stylize_views(style, sources, [], {})
