"""Runs done side by side, in processes of their own."""

import os
import signal
import sys
import threading
from dataclasses import dataclass, replace
from functools import partial

import numba
import numpy as np
import pytest
from threadpoolctl import threadpool_info

from eval.outcome import Outcome
from eval.runs import side_by_side
from eval.runs.complete import Task, complete
from eval.runs.job import Job
from eval.runs.side_by_side import do_all
from eval.runs.store import stored, stored_numbers
from eval.scenes import load_scene
from stylit_ref import InputError
from stylit_ref.machine.interruption import heed_interruptions

pytestmark = pytest.mark.skipif(
    sys.platform != "linux" or numba.config.NUMBA_NUM_THREADS == 1,
    reason="runs are done side by side on Linux, with two threads or more",
)

MAIN = os.getpid()
SEVERAL = 8


@dataclass(frozen=True)
class Told:
    """A method whose picture is the process and the threads that it ran with."""

    what: str = "nothing"

    name = code = device = "told"
    cost = 1.0

    def run(self, scene, seed, progress=None):
        if self.what == "fails" and seed == 1:
            raise InputError("is not possible", parameter="seed")
        if self.what == "is killed" and seed == 1 and os.getpid() != MAIN:
            os.kill(os.getpid(), signal.SIGKILL)
        image = np.random.default_rng(seed).integers(0, 1 << 40, (100, 100, 3))  # fills any pipe
        image[0, 0] = os.getpid(), numba.get_num_threads(), seed
        image[0, 1] = max(each["num_threads"] for each in threadpool_info())
        return Outcome(image, 0.0)


@dataclass(frozen=True)
class Alone(Told):
    """The same, alone."""

    alone = True


@pytest.fixture
def tasks_of(folder, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(threading, "active_count", lambda: 1)  # a test before may have left one
    scene = load_scene(folder)

    def of(method):
        return [Task(Job(scene, method, seed), ()) for seed in range(SEVERAL)]

    return of


def told(tasks):
    """Processes, threads and seeds of finished runs."""
    return np.array([stored(task.job).image[0, 0] for task in tasks]).T


def test_processes_have_one_thread_each(tasks_of):
    tasks = tasks_of(Told())
    assert complete(tasks) == {}
    processes, threads, seeds = told(tasks)
    assert MAIN not in processes
    assert set(threads) == {1}
    assert {stored(task.job).image[0, 1, 0] for task in tasks} == {1}
    np.testing.assert_array_equal(seeds, range(SEVERAL))


def test_what_is_to_be_alone_is_done_by_this_process(tasks_of):
    tasks = tasks_of(Alone())
    assert complete(tasks) == {}
    processes, threads, _ = told(tasks)
    assert set(processes) == {MAIN}
    assert set(threads) == {numba.get_num_threads()}


def test_a_run_that_fails_is_named_and_the_others_are_kept(tasks_of):
    tasks = tasks_of(Told("fails"))
    failures = complete(tasks)
    assert list(failures) == [tasks[1].job.key]
    assert failures[tasks[1].job.key].startswith(f"{tasks[1].job.title}: ")
    assert "seed is not possible" in failures[tasks[1].job.key]
    assert [stored(task.job) is None for task in tasks] == [seed == 1 for seed in range(SEVERAL)]


def test_what_a_killed_process_leaves_is_done_alone(tasks_of):
    before = [signal.getsignal(each) for each in (signal.SIGTERM, signal.SIGINT)]
    tasks = tasks_of(Told("is killed"))
    heed_interruptions()  # as python -m eval does: SIGTERM is an exception in this process
    try:
        assert complete(tasks) == {}
    finally:
        for each, handler in zip((signal.SIGTERM, signal.SIGINT), before, strict=True):
            signal.signal(each, handler)
    processes, _, seeds = told(tasks)
    assert processes[1] == MAIN
    np.testing.assert_array_equal(seeds, range(SEVERAL))


@pytest.mark.usefixtures("tasks_of")
@pytest.mark.parametrize("processes", [1, 2])
def test_all_pieces_are_called_even_if_some_fail(tmp_path, monkeypatch, processes):
    monkeypatch.setattr(side_by_side, "possible_processes", lambda: processes)

    def write(number):
        (tmp_path / str(number)).write_text(str(os.getpid()))
        if number in (0, 2):
            raise InputError(f"is {number}", parameter="number")

    errors = do_all({number: partial(write, number) for number in range(4)})
    assert {number: str(error) for number, error in errors.items()} == {
        0: "number is 0", 2: "number is 2",
    }  # fmt: skip
    found = {(tmp_path / str(number)).read_text() for number in range(4)}
    assert (found == {str(MAIN)}) == (processes == 1)


def test_a_run_that_two_reports_share_is_done_once_and_measured_for_both(tasks_of):
    (first, *_) = tasks_of(Told())
    usage = Task(first.job, ("usage",))
    assert complete([first, usage]) == {}
    assert stored_numbers(first.job).keys() == {"usage"}


def test_one_scene_under_two_names_has_a_run_of_each(tasks_of):
    (first, *_) = tasks_of(Told())
    other = Task(replace(first.job, scene=replace(first.job.scene, name="other")), ())
    assert other.job.key == first.job.key
    assert complete([first, other]) == {}
    assert None not in (stored(first.job), stored(other.job))
