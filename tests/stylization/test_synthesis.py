"""A run entered at every step, and what several runs share."""

from dataclasses import replace

import numpy as np
import pytest
from small_scene import small_scene

from stylit_ref import InputError, Params, passes, stylize
from stylit_ref.machine.replaced import replaced
from stylit_ref.stylization.backends import Backend
from stylit_ref.stylization.problem import make_exemplar, make_synthesis, make_target
from stylit_ref.stylization.synthesis import Synthesis

PARAMS = Params(levels=3, votes=2, patchmatch_iterations=2)
METHODS = [
    PARAMS,
    replace(PARAMS, method="guide_map", epsilon=300),
    replace(PARAMS, method="stylit", budget=0.9),
]


def same(level, result):
    """Whether a finished level is the result of a run."""
    np.testing.assert_array_equal(level.nnf, result.nnf)
    np.testing.assert_array_equal(level.style, result.image)
    np.testing.assert_array_equal(level.omega, result.omega)


@pytest.mark.parametrize("params", METHODS, ids=lambda params: params.method)
def test_step_by_step_is_the_same_as_at_once(params):
    at_once = stylize(*small_scene(), params, seed=3)
    synthesis = make_synthesis(*small_scene(), params, seed=3)
    steps = []
    for number in synthesis.level_numbers:
        synthesis.begin_level(number)
        for _ in range(synthesis.votes):
            synthesis.vote()
            steps += synthesis.search()
        synthesis.end_level()
    same(synthesis.level, at_once)
    assert tuple(steps) == at_once.history


def test_two_targets_share_an_exemplar_and_take_turns():
    """As frames of a sequence do; levels count from the finest where they are shared."""
    style, sources, targets = small_scene()
    others = [np.ascontiguousarray(guide[::-1, 3:]) for guide in targets]
    deep, flat = PARAMS, replace(PARAMS, levels=2)
    first = make_synthesis(style, sources, targets, deep, seed=3)
    second = Synthesis(first.exemplar, make_target(others, first.exemplar), flat, seed=4)
    running = [first.run(), second.run()]
    while running:
        running = [run for run in running if next(run, None)]
    same(first.level, stylize(style, sources, targets, deep, seed=3))
    same(second.level, stylize(style, sources, others, flat, seed=4))
    assert first.level.textures.source is second.level.textures.source
    assert first.level.textures.source_moments is second.level.textures.source_moments


def counting(calls):
    """The passes; what they make of the source is counted."""

    def patch_moments(texture, moments, patch_width, first, *style, style_only=False):
        calls.append("moments of the source" if first else "moments of the target")
        passes.patch_moments(texture, moments, patch_width, first, *style, style_only=style_only)

    def means(texture, sums, patch_width, first):
        calls.append("sums of the source" if first else "sums of the target")
        passes.means(texture, sums, patch_width, first)

    return replaced(passes, patch_moments=patch_moments, means=means)


def test_what_belongs_to_the_source_is_made_once():
    params, calls = METHODS[1], []
    synthesis = make_synthesis(*small_scene(), params, backend=Backend(counting(calls)))
    synthesis.finish()
    assert calls.count("moments of the source") == calls.count("sums of the source") == 3
    again = Synthesis(synthesis.exemplar, synthesis.target, params, seed=1)
    again.finish()
    assert calls.count("moments of the source") == calls.count("sums of the source") == 3
    assert calls.count("sums of the target") == 6
    synthesis.exemplar.forget(0)
    Synthesis(synthesis.exemplar, synthesis.target, params).finish()
    assert calls.count("moments of the source") == 4


def test_another_painting_over_the_same_guides():
    (style, sources, targets), params = small_scene(), METHODS[1]
    first = make_synthesis(style, sources, targets, params, seed=3)
    first.finish()
    exemplar = first.exemplar.repainted(255 - style)
    assert exemplar.level(0).guide_sums is first.exemplar.level(0).guide_sums
    repainted = Synthesis(exemplar, first.target, params, seed=3)
    same(repainted.finish(), stylize(255 - style, sources, targets, params, seed=3))
    same(first.level, stylize(style, sources, targets, params, seed=3))


def test_a_run_that_is_stopped_and_entered_again():
    """The NNF of a level is all that a run needs to go on from there."""
    whole = make_synthesis(*small_scene(), PARAMS, seed=3)
    kept = {}
    for step in whole.run():
        if (step.level, step.vote, step.patchmatch_iteration) == (2, 1, 2):
            kept["nnf"] = whole.level.nnf.copy()
    resumed = make_synthesis(*small_scene(), PARAMS, seed=3)
    resumed.begin_level(2, nnf=kept["nnf"], votes=1)
    resumed.vote()
    steps = list(resumed.search())
    resumed.end_level()
    steps += resumed.run_level(3)
    same(resumed.level, stylize(*small_scene(), PARAMS, seed=3))
    assert steps[0].vote == 2
    assert steps[-1].done == 1


def test_a_run_may_be_run_again_and_levels_follow_each_other():
    synthesis = make_synthesis(*small_scene(), PARAMS, seed=3)
    synthesis.finish()
    same(synthesis.finish(), stylize(*small_scene(), PARAMS, seed=3))
    synthesis.begin_level(1)
    with pytest.raises(InputError, match="level 3 begins with the NNF of level 2, but the run is"):
        synthesis.begin_level(3)


def test_all_levels_are_a_number_once_the_halves_are_known():
    made = make_synthesis(*small_scene(), PARAMS, seed=3)
    synthesis = Synthesis(made.exemplar, made.target, replace(PARAMS, levels="all"), seed=3)
    assert synthesis.params == PARAMS
    same(synthesis.finish(), stylize(*small_scene(), PARAMS, seed=3))


def test_halves_that_do_not_fit_are_refused():
    style, sources, targets = small_scene()
    exemplar = make_exemplar(style, sources, PARAMS)
    target = make_target(targets, exemplar)
    wide = replace(PARAMS, patch_width=7)
    with pytest.raises(InputError, match="patch_width is 7, but the exemplar was made for 5 and"):
        Synthesis(exemplar, target, wide)
    heavy = make_exemplar(style, sources, replace(PARAMS, guide_influence=3.0))
    with pytest.raises(InputError, match="exemplar and target are not packed alike"):
        Synthesis(heavy, target, PARAMS)
    with pytest.raises(InputError, match="levels is 5, but the coarsest level would be smaller"):
        Synthesis(exemplar, target, replace(PARAMS, levels=5))
    with pytest.raises(InputError, match="target_guides holds 1 guides but source_guides holds 2"):
        make_target(targets[:1], exemplar)
    with pytest.raises(InputError, match=r"source_guides\[0\] has 3 channels but target_g"):
        make_target(targets[::-1], exemplar)
    same(
        Synthesis(exemplar, target, PARAMS, seed=3).finish(),
        stylize(*small_scene(), PARAMS, seed=3),
    )


@pytest.mark.parametrize(
    ("spoil", "sentence"),
    [
        (lambda nnf: nnf[1:], r"nnf is int32 of shape \(18, 22, 2\); it must be int32 of shape"),
        (lambda nnf: nnf.astype(np.int64), "nnf is int64"),
        (lambda nnf: nnf * 0, r"nnf must hold source centres from \[2, 2\] to \[17, 20\]"),
        (lambda nnf: nnf + 99, "nnf must hold source centres"),
        (lambda nnf: nnf * 0 - 1, "and -1 elsewhere"),
    ],
)
def test_an_nnf_to_go_on_from_is_one_of_the_level(spoil, sentence):
    synthesis = make_synthesis(*small_scene(), PARAMS, seed=3)
    synthesis.begin_level(1)
    nnf = synthesis.begin_level(2).nnf.copy()
    with pytest.raises(InputError, match=sentence):
        synthesis.begin_level(2, nnf=spoil(nnf))
    again = make_synthesis(*small_scene(), PARAMS, seed=3)
    np.testing.assert_array_equal(again.begin_level(2, nnf=nnf).nnf, nnf)


@pytest.mark.parametrize("number", [0, -1, 4])
def test_a_level_that_is_not_there(number):
    with pytest.raises(InputError, match=f"there is no level {number}; levels are 1 to 3"):
        make_synthesis(*small_scene(), PARAMS).begin_level(number)


@pytest.mark.parametrize(
    "step",
    [Synthesis.vote, Synthesis.end_level, lambda synthesis: next(synthesis.search())],
    ids=["vote", "end_level", "search"],
)
def test_a_step_before_the_first_level(step):
    synthesis = make_synthesis(*small_scene(), PARAMS)
    with pytest.raises(InputError, match="no level has begun; call begin_level first"):
        step(synthesis)
    assert synthesis.vote_number == 0


def test_a_seed_is_checked_wherever_a_run_comes_from():
    made = make_synthesis(*small_scene(), PARAMS)
    with pytest.raises(InputError, match="seed is -1; it must be an integer from 0 to"):
        Synthesis(made.exemplar, made.target, PARAMS, seed=-1)


@pytest.mark.parametrize("style", [np.zeros((40, 46, 1), np.uint8), np.zeros((40, 46, 3))])
def test_a_repainting_is_shaped_like_the_painting(style):
    exemplar = make_exemplar(*small_scene()[:2], PARAMS)
    with pytest.raises(InputError, match=r"it must be uint8 of shape \(40, 46, 3\)"):
        exemplar.repainted(style)


def test_a_style_of_ones_own_between_vote_and_search():
    synthesis = make_synthesis(*small_scene(), replace(PARAMS, levels=1), seed=3)
    level = synthesis.begin_level(1)
    synthesis.vote()
    voted, delta = level.style.copy(), level.delta.copy()
    level.set_style(255 - voted)
    np.testing.assert_array_equal(level.style, 255 - voted)
    assert (level.delta != delta).any()
    level.set_style(voted)
    np.testing.assert_array_equal(level.delta, delta)
    before = list(synthesis.search())
    again = make_synthesis(*small_scene(), replace(PARAMS, levels=1), seed=3)
    again.begin_level(1)
    again.vote()
    assert list(again.search()) == before


def test_a_run_that_forgets_gives_the_same_and_cannot_begin_a_level_twice():
    kept = make_synthesis(*small_scene(), PARAMS, seed=3)
    forgetful = make_synthesis(*small_scene(), PARAMS, seed=3, forgets=True)
    np.testing.assert_array_equal(forgetful.finish().nnf, kept.finish().nnf)
    last = kept.level_numbers[-1]
    kept.begin_level(last, kept.level.nnf)
    with pytest.raises(InputError, match="is forgotten; begin with a new target"):
        forgetful.begin_level(last, forgetful.level.nnf)
