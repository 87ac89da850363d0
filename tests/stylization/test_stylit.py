"""StyLit's search: retrievals from source to target, and what holds after each."""

from dataclasses import replace

import brute_force
import numpy as np
import pytest
from small_level import make_level
from small_scene import small_scene

from stylit_ref import Params, stylize
from stylit_ref.passes.claims import FIXED, FREE
from stylit_ref.randomness.random_stream import RETRIEVAL_NNF, RETRIEVAL_SEARCH, random_stream
from stylit_ref.stylization import stylit
from stylit_ref.stylization.schedules import propose_commit
from stylit_ref.stylization.stylit import Retrieval

PARAMS = Params(method="stylit", patchmatch_iterations=3)
CASES = [
    {},
    {"smooth": True, "patch_width": 3, "style_channels": 1},
    {"patch_width": 7, "source_size": (8, 30), "target_size": (3, 20)},
    {"masked": np.eye(14, 12, dtype=bool), "guide_channels": (3,) * 6},
]


def make_retrieval(**case):
    level = make_level(uniformity=0, **case)
    level.vote()
    level.update_moments()
    return level, Retrieval(level, random_stream(4, RETRIEVAL_NNF, 1, 1))


def search(level, params):
    """A search in a place of a run."""
    return stylit.search(level, params, propose_commit, seed=3, level_number=1, vote=1)


def errors_of(level):
    """δ of every target patch (first axis) with every source patch, by the definition."""
    radius = level.patch_width // 2
    metric = level.textures.source, level.textures.target, brute_force.weights_of(level.packing)
    sources = list(np.ndindex(*(length - 2 * radius for length in level.omega.shape)))
    return np.array(
        [
            [
                brute_force.delta(
                    *metric, level.patch_width, y, x, source_y + radius, source_x + radius
                )
                for source_y, source_x in sources
            ]
            for y, x in np.ndindex(*level.delta.shape)
        ]
    ).reshape(*level.delta.shape, *(length - 2 * radius for length in level.omega.shape))


@pytest.mark.parametrize("case", CASES, ids=str)
def test_a_retrieval_comes_near_the_closest_free_target_patches(case):
    level, retrieval = make_retrieval(**case)
    retrieval.taken[np.random.default_rng(5).random(level.delta.shape) < 0.7] = FIXED
    level.passes.lose_claims(retrieval.claims, retrieval.taken, retrieval.states)
    assert (retrieval.taken[level.nnf[:, :, 0] < 0] == FIXED).all()
    for iteration in range(1, 31):
        retrieval.improve(random_stream(4, RETRIEVAL_SEARCH, 1, 1, iteration))
    errors = errors_of(level)
    for y, x in np.ndindex(*retrieval.errors.shape):
        place = tuple(retrieval.claims[y, x])
        assert retrieval.taken[place] == FREE
        assert retrieval.errors[y, x] == errors[(*place, y, x)]
    free = retrieval.taken == FREE
    least = np.where(free[:, :, None, None], errors, np.iinfo(np.int64).max)
    best, chance = least.min(axis=(0, 1)).mean(), errors[free].mean()
    assert retrieval.errors.mean() - best < 0.15 * (chance - best)


def test_a_retrieval_starts_from_the_target_to_source_field_turned_round():
    level, retrieval = make_retrieval()
    for y, x in np.ndindex(*level.delta.shape):
        source_y, source_x = level.nnf[y, x] - 2
        assert retrieval.errors[source_y, source_x] <= level.delta[y, x]


def test_a_free_patch_is_taken_at_any_error():
    """The fixed patches are good matches, the free ones the worst there can be."""
    level = make_level(uniformity=0, target_size=(14, 40))
    level.textures.source[:] = 0
    level.textures.target[:, :4] = 0
    level.textures.target[:, 4:] = 255
    level.update_similarity()
    retrieval = Retrieval(level, random_stream(4, RETRIEVAL_NNF, 1, 1))
    retrieval.taken[:, :4] = FIXED
    retrieval.claims[:] = 0
    level.passes.claim_errors(level.textures, 5, retrieval.claims, retrieval.errors)
    level.passes.lose_claims(retrieval.claims, retrieval.taken, retrieval.states)
    for iteration in range(1, 6):
        retrieval.improve(random_stream(4, RETRIEVAL_SEARCH, 1, 1, iteration))
    assert (retrieval.claims[:, :, 1] >= 4).all()


def test_a_small_source_searches_the_whole_target():
    level = make_level(uniformity=0, source_size=(7, 7), target_size=(60, 60))
    level.vote()
    level.update_moments()
    *_, step = search(level, replace(PARAMS, fixed_share=0.3))
    assert step.fixed >= 0.3
    assert step.done == 1


@pytest.mark.parametrize("case", CASES, ids=str)
def test_what_is_fixed_stays_until_the_vote(case):
    level = make_level(uniformity=0, **case)
    level.vote()
    level.update_moments()
    patches = np.count_nonzero(level.nnf[:, :, 0] >= 0)
    found = None
    for step in search(level, PARAMS):
        if step.retrieval == 0:
            found = level.nnf.copy()
            assert step.fixed == 0
            continue
        now = level.nnf.copy()
        moved = (now != found).any(axis=2)
        assert moved.sum() <= step.moves
        found = now
        assert step.done <= 1
    assert (level.nnf[:, :, 0] >= 0).sum() == patches
    assert step.fixed >= PARAMS.fixed_share
    assert step.patchmatch_iteration == 3 * (step.retrieval + 1)
    delta = level.delta.copy()
    level.update_similarity()
    np.testing.assert_array_equal(delta, level.delta)


def test_a_retrieval_uses_every_source_patch_at_most_once():
    level = make_level(uniformity=0, target_size=(40, 40))
    level.vote()
    level.update_moments()
    before, used = None, 0
    for step in search(level, PARAMS):
        if step.retrieval == 1:
            fixed = level.nnf[(level.nnf != before).any(axis=2)]
            used = len(fixed)
            assert len(np.unique(fixed, axis=0)) == used
        before = level.nnf.copy()
    assert used > 20
    assert step.retrieval >= 1600 * PARAMS.fixed_share / (9 * 13)


def test_patches_beyond_the_limit_are_not_fixed():
    """α = 1: only what is no worse than the target-to-source search found."""
    level, twin = (make_level(uniformity=0, smooth=True) for _ in range(2))
    for either in (level, twin):
        either.vote()
        either.update_moments()
    for iteration in (1, 2, 3):
        propose_commit(twin, 3, 1, 1, iteration)
    *_, unlimited = search(make_level(uniformity=0, smooth=True), PARAMS)
    *_, step = search(level, replace(PARAMS, error_limit=1.0))
    assert (level.delta <= twin.delta).all()
    assert step.fixed < unlimited.fixed
    *_, step = search(twin, replace(PARAMS, error_limit=1e12))
    assert step.fixed >= PARAMS.fixed_share


def test_retrievals_that_fix_next_to_nothing_end(monkeypatch):
    monkeypatch.setattr(stylit, "LEAST_PROGRESS", 0.1)
    level = make_level(uniformity=0, target_size=(30, 30))
    level.vote()
    level.update_moments()
    steps = list(search(level, replace(PARAMS, budget=0.05, fixed_share=1.0)))
    assert steps[-1].moves < 0.1 * 900
    assert all(step.moves >= 0.1 * 900 for step in steps[1:-1])


def stylized(threads=None, **values):
    params = Params(method="stylit", levels=3, votes=2, patchmatch_iterations=2)
    return stylize(*small_scene(), replace(params, **values), seed=5, threads=threads)


def test_same_bytes_with_any_number_of_threads():
    first, second = stylized(threads=1), stylized()
    np.testing.assert_array_equal(first.nnf, second.nnf)
    np.testing.assert_array_equal(first.image, second.image)
    assert first.history == second.history


@pytest.mark.parametrize(
    "values", [{"budget": 0.5}, {"error_limit": 1.5}, {"fixed_share": 1.0}, {"vote_outliers": 3}]
)
def test_every_option_changes_the_result(values):
    assert (stylized(**values).nnf != stylized().nnf).any()


def test_history_tells_the_retrievals_of_every_vote():
    result = stylized()
    numbers = {}
    for step in result.history:
        numbers.setdefault((step.level, step.vote), []).append(step.retrieval)
    assert len(numbers) == 6
    for retrievals in numbers.values():
        assert retrievals == list(range(len(retrievals)))
        assert len(retrievals) > 1
    assert all(step.penalization == 0 for step in result.history)
    assert result.history[-1].done == 1


def test_usage_is_more_even_than_without_uniformity():
    plain = stylize(
        *small_scene(), Params(uniformity=0, levels=3, votes=2, patchmatch_iterations=2), seed=5
    )
    even = stylized()
    distinct = [len(np.unique(result.nnf.reshape(-1, 2), axis=0)) for result in (plain, even)]
    assert distinct[1] > 1.3 * distinct[0]
    assert even.omega.max() < plain.omega.max()
