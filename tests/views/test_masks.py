"""Frames of which a part is left alone."""

import numpy as np
import pytest
from small_shot import EFFORT, sliding

from stylit_ref import (
    ArrayShot,
    Coherence,
    InputError,
    Motion,
    Params,
    replay_run,
    stylize,
    stylize_views,
    views_of_run,
)
from stylit_ref.views.coherence import without_masked
from stylit_ref.views.problem import make_problem
from stylit_ref.views.run_writer import RunWriter
from stylit_ref.views.work.keys import keys_of
from stylit_ref.views.work.walk import Walk
from stylit_ref.views.work.work_folder import WorkFolder
from stylit_ref.views.work.workbench import Workbench

PARAMS = Params(**EFFORT)


@pytest.fixture
def scene():
    return sliding(frames=2)


@pytest.fixture
def masks(scene):
    """The left half of the first frame, and a corner of the second."""
    masks = np.zeros((2, *scene.guides[0][0].shape[:2]), bool)
    masks[0, :, :22] = True
    masks[1, 25:, 30:] = True
    return masks


def shot(scene, masks, edges=None):
    return ArrayShot(scene.guides, scene.edges if edges is None else edges, masks=masks)


@pytest.mark.parametrize("method", ["ref", "stylit"])
def test_alone_they_are_those_of_stylize(scene, masks, method):
    params = Params(method=method, **EFFORT)
    results = stylize_views(
        scene.style, scene.sources, shot(scene, masks), params, Coherence(weight=0)
    )
    for result in results:
        guides, mask = scene.guides[result.frame], masks[result.frame]
        alone = stylize(scene.style, scene.sources, guides, params, mask=mask)
        assert np.array_equal(result.image, alone.image)
        assert np.array_equal(result.nnf, alone.nnf)


def test_masked_pixels_do_not_pull(scene, masks):
    """As if no motion led to them."""
    edges = {
        (to, other): without_masked(motion, masks[other])
        for (to, other), motion in scene.edges.items()
    }
    for (to, other), motion in edges.items():
        columns = np.arange(44) + other - to
        shown = ~masks[other][:, np.clip(columns, 0, 43)] & (columns >= 0) & (columns < 44)
        inside = (columns >= 0) & (columns < 44)
        assert np.array_equal(motion.visible[:, inside], shown[:, inside])
    results = [
        list(stylize_views(scene.style, scene.sources, shot(scene, masks, each), PARAMS))
        for each in (None, edges)
    ]
    for one, other in zip(*results, strict=True):
        assert np.array_equal(one.image, other.image)
        assert np.array_equal(one.nnf, other.nnf)


def test_motion_into_a_frame_without_a_mask_stays(scene):
    motion = scene.edges[0, 1]
    assert without_masked(motion, None) is motion
    nothing = without_masked(motion, np.zeros(motion.visible.shape, bool))
    assert np.array_equal(nothing.visible, motion.visible)


@pytest.mark.parametrize("order", ["parallel", "sequential"])
def test_states_do_not_depend_on_what_is_kept(scene, masks, tmp_path, order):
    problem = make_problem(
        scene.style, scene.sources, shot(scene, masks), PARAMS, Coherence(order=order)
    )
    keys, states = keys_of(problem, problem.plan()), []
    for room in (0, 1 << 30):
        bench = Workbench(problem, room=room)
        walk = Walk(problem, WorkFolder(tmp_path / str(room)), bench, keys)
        states.append({frame: state.to_bytes() for frame, state in walk.run()})
    assert states[0] == states[1]


def test_a_state_belongs_to_its_mask(scene, masks):
    def keys(masks):
        problem = make_problem(
            scene.style, scene.sources, shot(scene, masks), PARAMS, Coherence(order="sequential")
        )
        return keys_of(problem, problem.plan())

    before, other = keys(masks), masks.copy()
    other[1, 0, 0] = True
    after = keys(other)
    assert {task.frame for task in before if before[task] != after[task]} == {1}


def test_masks_that_do_not_fit_are_refused(scene, masks):
    with pytest.raises(InputError, match="masks holds 1 masks for 2 frames"):
        shot(scene, masks[:1])
    with pytest.raises(InputError, match="mask is 44x37 but the target is 44x38"):
        shot(scene, masks[:, 1:])
    with pytest.raises(InputError, match="mask covers the whole target"):
        shot(scene, [None, np.ones_like(masks[0])])


def test_a_run_keeps_masks_and_replays_them(scene, masks, tmp_path):
    some = shot(scene, [None, masks[1]])
    problem = make_problem(scene.style, scene.sources, some, PARAMS)
    writer = RunWriter(tmp_path, problem)
    for result in stylize_views(scene.style, scene.sources, some, PARAMS):
        writer.add(result)
    run = writer.finish()
    assert run.has_masks
    assert run.field(0).mask is None
    assert np.array_equal(run.field(1).mask, masks[1])
    assert np.array_equal(run.picture(1)[:, :, 3], 255 * ~masks[1])
    for frame, replayed in enumerate(replay_run(run, run.style())):
        assert np.array_equal(replayed.image, run.picture(frame))
    with pytest.raises(InputError, match="was drawn with --mask, and views between others need"):
        views_of_run(run)


def test_motion_to_nowhere_is_hidden_by_no_mask(scene, masks):
    """What leads outside stays as it was: nothing is fetched there."""
    size = masks[0].shape
    away = Motion(np.full((*size, 2), 999, np.float32), np.ones(size, bool))
    assert not without_masked(away, np.ones(size, bool)).visible.any()
