"""A run that was interrupted, damaged or changed: the same bytes, and no work twice."""

import os
import random
import signal
from pathlib import Path

import numpy as np
import pytest
from small_shot import EFFORT, sliding

from stylit_ref import Coherence, InputError, Motion, Params, stylize_views
from stylit_ref.views.work.work_folder import WorkFolder

PARAMS = Params(**EFFORT)
TASKS = 3 * (2 + 1)
"""Of each frame."""


class Run:
    """Arguments that can be changed, and a run of them that counts."""

    def __init__(self, order, frames=4):
        self.style, self.sources, self.guides, self.edges = sliding(frames)
        self.coherence, self.params = Coherence(order=order), PARAMS

    def results(self, work=None, at_step=None):
        """Bytes of all frames by number, and the steps that were done."""
        steps = []

        def progress(step):
            steps.append(step)
            if at_step:
                at_step(step)

        results = stylize_views(
            self.style, self.sources, self.guides, self.params, self.coherence,
            edges=self.edges, seed=3, work=work, progress=progress,
        )  # fmt: skip
        frames = {each.frame: (each.image.tobytes(), each.nnf.tobytes()) for each in results}
        return frames, steps


class Stopped(Exception):  # noqa: N818
    """Stops a run."""


def stop_at(number):
    """Stop after so many steps."""
    steps = iter(range(1, number))

    def count(step):
        if next(steps, None) is None:
            raise Stopped

    return count


@pytest.fixture(scope="module")
def expected():
    return {order: Run(order).results()[0] for order in ("parallel", "sweeps", "sequential")}


@pytest.mark.parametrize("order", ["parallel", "sweeps", "sequential"])
def test_a_stopped_run_goes_on_where_it_was(tmp_path, expected, order):
    run = Run(order)
    with pytest.raises(Stopped):
        run.results(tmp_path, stop_at(20))
    frames, steps = run.results(tmp_path)
    assert frames == expected[order]
    assert len(steps) == 4 * TASKS - 20
    assert steps[-1].done == 1


@pytest.mark.parametrize("order", ["parallel", "sweeps", "sequential"])
def test_at_most_two_iterations_of_a_frame_are_on_the_disk(tmp_path, order):
    most = []
    Run(order).results(tmp_path, lambda step: most.append(len(list(tmp_path.iterdir()))))
    assert max(most) <= (2 + 3 if order == "sequential" else 2 * 4)
    assert len(list(tmp_path.iterdir())) == 4


def kill_at(moment):
    """Kill this process at a moment of its writer, which has four for every file."""
    left = iter(range(moment))

    def pass_moment():
        if next(left, None) is None:
            os.kill(os.getpid(), signal.SIGKILL)

    replace = os.replace

    def write_in_two(path, data):
        pass_moment()
        with path.open("wb") as file:
            file.write(data[: len(data) // 2])
            file.flush()
            pass_moment()
            file.write(data[len(data) // 2 :])

    def replace_between(source, target):
        pass_moment()
        replace(source, target)
        pass_moment()

    Path.write_bytes, os.replace = write_in_two, replace_between


MOMENTS = random.Random(23).sample(range(4 * 4 * TASKS), 20)


@pytest.mark.parametrize(
    ("order", "moments"),
    [("parallel", MOMENTS[:7]), ("sweeps", MOMENTS[7:14]), ("sequential", MOMENTS[14:])],
)
def test_a_killed_run_gives_the_same_bytes(tmp_path, expected, order, moments):
    for moment in moments:
        work = tmp_path / str(moment)
        child = os.fork()
        if not child:
            kill_at(moment)
            Run(order).results(work)
            os._exit(0)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == -signal.SIGKILL
        assert Run(order).results(work)[0] == expected[order]


@pytest.mark.parametrize("order", ["parallel", "sweeps", "sequential"])
def test_damaged_states_are_made_again(tmp_path, expected, order):
    run = Run(order)
    with pytest.raises(Stopped):
        run.results(tmp_path, stop_at(30))
    files = random.Random(1).sample(sorted(tmp_path.iterdir()), 3)
    files[0].write_bytes(b"")
    files[1].write_bytes(files[1].read_bytes()[:-9])
    data = bytearray(files[2].read_bytes())
    data[99] ^= 255
    files[2].write_bytes(data)
    assert run.results(tmp_path)[0] == expected[order]


def test_a_state_that_is_lost_as_the_run_goes_on_is_made_again(tmp_path, expected, monkeypatch):
    monkeypatch.setattr("stylit_ref.views.work.walk.ROOM", 0)
    lost = []

    def lose(step):
        if step.frame == 2 and not lost:
            lost.extend(tmp_path.iterdir())
            for file in lost:
                file.unlink(missing_ok=True)  # one may be written at this moment

    assert Run("sequential").results(tmp_path, lose)[0] == expected["sequential"]
    assert lost


def test_other_votes_of_frames_that_follow_leave_finished_ones_to_go_back_to(tmp_path):
    def results(following_votes):
        run = Run("sequential")
        run.coherence = Coherence(order="sequential", following_votes=following_votes)
        return run.results(tmp_path)

    first, _ = results((1, 2))
    others, steps = results((2, 2))
    assert others != first
    assert {step.frame for step in steps} == {1, 2, 3}
    assert {step.votes for step in steps if step.level == step.levels} == {2}
    again, steps = results((1, 2))
    assert again == first
    assert not steps


def change_nothing(run):
    pass


def change_weight(run):
    run.coherence = Coherence(order=run.coherence.order, weight=0.7)


def change_style(run):
    run.style = run.style.copy()
    run.style[3, 4] ^= 1


def change_motion(run):
    field, visible = run.edges[2, 1]
    run.edges[2, 1] = Motion(field, visible & (np.arange(visible.shape[1]) > 5))


def change_guides(run, frame=2):
    run.guides[frame] = [run.guides[frame][0].copy(), *run.guides[frame][1:]]
    run.guides[frame][0][9, 9] ^= 1


@pytest.mark.parametrize(
    ("change", "frames"),
    [
        (change_nothing, []),
        (change_weight, [1, 2, 3]),  # nothing pulls at the first
        (change_style, [0, 1, 2, 3]),
        (change_motion, [2, 3]),
        (change_guides, [2, 3]),
    ],
)
def test_only_what_depends_on_a_change_is_done_again(tmp_path, change, frames):
    run = Run("sequential")
    run.results(tmp_path)
    change(run)
    again, steps = run.results(tmp_path)
    assert [step.frame for step in steps] == [frame for frame in frames for _ in range(TASKS)]
    assert again == run.results()[0]


def test_a_change_reaches_neighbours_by_one_frame_an_iteration(tmp_path):
    """All frames at once: with two iterations it ends two frames away.

    What these read of their neighbours is made again too, as far as it was removed.
    """
    run = Run("parallel", frames=6)
    run.params = Params(levels=2, votes=1, patchmatch_iterations=1)
    run.results(tmp_path)
    change_guides(run, frame=5)
    again, steps = run.results(tmp_path)
    finished = {step.frame for step in steps if (step.level, step.vote) == (2, 1)}
    assert finished == {3, 4, 5}
    assert {step.frame for step in steps} == {1, 2, *finished}
    assert again == run.results()[0]


def test_frames_that_no_motion_joins_do_not_depend_on_each_other(tmp_path):
    run = Run("parallel")
    for pair in ((1, 2), (2, 1)):
        del run.edges[pair]
    run.results(tmp_path)
    change_guides(run)
    again, steps = run.results(tmp_path)
    assert {step.frame for step in steps} == {2, 3}
    assert len(steps) == 2 * TASKS
    assert again == run.results()[0]


def test_a_full_disk_is_one_sentence(tmp_path, monkeypatch):
    def full(folder):
        return type("Usage", (), {"free": 10})

    monkeypatch.setattr("shutil.disk_usage", full)
    with pytest.raises(InputError, match=r"the disk has 0.0 MiB free"):
        Run("parallel").results(tmp_path)
    assert not list(tmp_path.iterdir())


def test_whoever_paints_over_a_result_does_not_change_the_next(expected):
    run = Run("sequential")
    results = stylize_views(
        run.style, run.sources, run.guides, PARAMS, run.coherence, edges=run.edges, seed=3
    )
    for result in results:
        assert result.image.tobytes() == expected["sequential"][result.frame][0]
        result.image[:] = 0


def test_a_run_can_be_cancelled(tmp_path):
    style, sources, guides, edges = sliding()
    coherence = Coherence(order="sequential")
    results = stylize_views(style, sources, guides, PARAMS, coherence, edges=edges, work=tmp_path)
    next(results)
    results.close()
    assert len(list(WorkFolder(tmp_path).folder.iterdir())) == 1
