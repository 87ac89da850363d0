"""Which states are made of which others."""

import pytest

from stylit_ref.views.plan import Plan, Task

LINE = [[1], [0, 2], [1]]
BEFORE = [[], [0], [1]]


@pytest.mark.parametrize(
    ("neighbours", "order"), [(LINE, "parallel"), (LINE, "sweeps"), (BEFORE, "sequential")]
)
def test_every_task_stands_behind_those_that_it_reads(neighbours, order):
    plan = Plan(neighbours, [2, 3], order)
    done = set()
    for task in plan.tasks():
        assert done.issuperset(plan.reads(task))
        done.add(task)
    assert len(done) == 3 * (2 + 1 + 3 + 1)


def test_in_parallel_a_frame_reads_the_iteration_before():
    plan = Plan(LINE, [2, 3], "parallel")
    assert plan.pulling(Task(1, 2, 3)) == [Task(0, 2, 2), Task(2, 2, 2)]
    assert plan.before(Task(1, 2, 3)) == Task(1, 2, 2)


def test_a_level_begins_with_the_frame_alone():
    plan = Plan(LINE, [2, 3], "parallel")
    assert plan.reads(Task(1, 2, 0)) == [Task(1, 1, 2)]
    assert plan.reads(Task(1, 1, 0)) == []


def test_sweeps_go_forth_and_back():
    plan = Plan(LINE, [2], "sweeps")
    assert [task.frame for task in plan.tasks()] == [0, 1, 2, 0, 1, 2, 2, 1, 0]
    assert plan.pulling(Task(1, 1, 1)) == [Task(0, 1, 1), Task(2, 1, 0)]
    assert plan.pulling(Task(1, 1, 2)) == [Task(0, 1, 1), Task(2, 1, 2)]


def test_in_sequential_order_finished_frames_pull():
    plan = Plan(BEFORE, [2, 1], "sequential")
    assert plan.pulling(Task(2, 1, 1)) == [Task(1, 2, 1)]
    assert [task.frame for task in plan.tasks()] == [0] * 5 + [1] * 5 + [2] * 5


def test_frames_that_follow_others_have_votes_of_their_own():
    plan = Plan([[], [0], []], [3, 2], "sequential", [1, 2])
    alone = [(1, 0), (1, 1), (1, 2), (1, 3), (2, 0), (2, 1), (2, 2)]
    following = [(1, 0), (1, 1), (2, 0), (2, 1), (2, 2)]
    assert list(plan.tasks()) == [
        Task(frame, *step)
        for frame, steps in enumerate((alone, following, alone))
        for step in steps
    ]
    assert plan.before(Task(1, 2, 0)) == Task(1, 1, 1)
    assert plan.last(0) == Task(0, 2, 2)


def test_votes_of_their_own_are_for_sequential_order():
    plan = Plan(LINE, [3, 2], "parallel", [1, 2])
    assert list(plan.tasks()) == list(Plan(LINE, [3, 2], "parallel").tasks())


def test_only_what_leads_to_a_missing_frame_is_done():
    plan = Plan(LINE, [2, 1], "parallel")
    everything = list(plan.tasks())
    assert plan.missing(lambda task: False) == everything
    assert plan.missing(lambda task: task in map(plan.last, plan.frames)) == []
    first_level = [task for task in everything if task.level == 1]
    assert plan.missing(lambda task: task.level == 1) == everything[len(first_level) :]
    # The last frame is lost; its last iteration reads those before of it and its neighbour.
    lost = plan.last(2)
    assert plan.missing(lambda task: task != lost) == [lost]


@pytest.mark.parametrize("order", ["parallel", "sweeps"])
@pytest.mark.parametrize("neighbours", [LINE, [[1], []], [[], [0], []]])
@pytest.mark.parametrize("hurried", [0, 1])
def test_no_state_goes_before_all_have_read_it(neighbours, order, hurried):
    """One frame is as far ahead as it may be, as on a cluster whose machines are not alike."""
    plan = Plan(neighbours, [3, 2], order)
    waits = plan.waits(plan.tasks())
    there, done = set(), set()
    while left := [task for task in waits if task not in done]:
        ready = [task for task in left if done.issuperset(waits[task])]
        task = next((task for task in ready if task.frame == hurried), ready[0])
        assert there.issuperset(plan.reads(task))
        there = (there | {task}) - {plan.removed_by(task)}
        done.add(task)
    assert there.issuperset(map(plan.last, plan.frames))
