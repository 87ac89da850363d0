"""What is kept in memory, and what goes when it is full."""

import numpy as np
import pytest
from small_shot import EFFORT, sliding

from stylit_ref import ArrayShot, Coherence, Params
from stylit_ref.views.problem import make_problem
from stylit_ref.views.work.kept import Kept
from stylit_ref.views.work.keys import keys_of
from stylit_ref.views.work.walk import Walk
from stylit_ref.views.work.work_folder import WorkFolder
from stylit_ref.views.work.workbench import Workbench


def test_the_largest_goes_first_and_of_equal_ones_that_used_least_recently():
    kept = Kept(10)
    for key, size in (("a", 3), ("b", 3), ("small", 1)):
        kept.add(key, key, size)
    assert kept.get("a") == "a"
    kept.add("c", "c", 4)
    assert kept.get("b") is None
    assert [kept.get(key) for key in ("a", "c", "small")] == ["a", "c", "small"]


def test_what_is_taken_leaves_its_room():
    kept = Kept(10)
    for key in ("a", "b"):
        kept.add(key, key, 5)
    assert (kept.take("a"), kept.take("a")) == ("a", None)
    kept.add("c", "c", 5)
    assert (kept.get("b"), kept.get("c")) == ("b", "c")


def test_one_that_is_too_large_stays_until_the_next():
    kept = Kept(10)
    kept.add("large", 1, 99)
    assert kept.get("large") == 1
    kept.add("next", 2, 1)
    assert (kept.get("large"), kept.get("next")) == (None, 2)


@pytest.mark.parametrize("order", ["parallel", "sequential"])
@pytest.mark.parametrize("method", ["guide_map", "stylit"])
def test_states_do_not_depend_on_what_is_kept(tmp_path, method, order):
    style, sources, guides, edges = sliding(frames=2)
    problem = make_problem(
        style, sources, ArrayShot(guides, edges), Params(method=method, **EFFORT),
        Coherence(order=order),
    )  # fmt: skip
    keys, results = keys_of(problem, problem.plan()), []
    for room in (0, 1 << 30):
        folder = WorkFolder(tmp_path / str(room))
        walk = Walk(problem, folder, Workbench(problem, room=room), keys)
        results.append([state for _, state in walk.run()])
    for without, with_it in zip(*results, strict=True):
        assert np.array_equal(without.nnf, with_it.nnf)
        assert np.array_equal(without.picture, with_it.picture)
