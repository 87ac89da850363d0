"""Frames run with all threads or with one, whichever is faster, on a machine with a fake clock."""

import numba
import pytest

from stylit_ref.machine import free_threads
from stylit_ref.machine.free_threads import FreeThreads


class Machine:
    """Of two processors, on which ``others`` programs are busy."""

    def __init__(self, monkeypatch):
        monkeypatch.setattr(free_threads, "available_threads", lambda: 2)
        monkeypatch.setattr("stylit_ref.machine.thread_count.available_threads", lambda: 2)
        monkeypatch.setattr(numba, "set_num_threads", self._set_threads)
        monkeypatch.setattr(numba, "get_num_threads", lambda: 2)
        self.now = self.own = 0.0
        self.others = 0
        self.threads = 2
        self.free = FreeThreads(lambda: self.now, lambda: self.own)

    def _set_threads(self, threads):
        self.threads = threads

    def frame(self, work=0.02, kind="cold"):
        """Compute a frame; its seconds and threads."""
        with self.free.frame(kind):
            threads = self.threads
            if threads == 1:
                seconds = work * (1, 1, 1.5)[self.others]
            else:
                seconds = work * (0.6, 1.4, 10)[self.others]
            self.now += seconds
            self.own += work / threads
        return seconds, threads

    def cancelled_frame(self):
        with self.free.frame("cold"):
            self.now += 100
            raise InterruptedError

    def run(self, seconds, **frame):
        """Compute frames for so long; their seconds and threads."""
        end = self.now + seconds
        frames = []
        while self.now < end:
            frames.append(self.frame(**frame))
        return frames


@pytest.fixture
def machine(monkeypatch):
    return Machine(monkeypatch)


def part_with_all(frames):
    return sum(threads == 2 for _, threads in frames) / len(frames)


def test_a_quiet_machine_gives_all_threads(machine):
    assert part_with_all(machine.run(10)) > 0.98


@pytest.mark.parametrize("others", [1, 2])
def test_beside_busy_programs_one_thread_computes(machine, others):
    machine.run(3)
    machine.others = others
    frames = machine.run(20)
    usual = 0.02 * (1, 1.5)[others - 1]
    assert sum(seconds for seconds, _ in frames) < 1.05 * usual * len(frames)
    assert frames[1][1] == 1


@pytest.mark.parametrize("others", [1, 2])
@pytest.mark.parametrize("busy", [0.5, 3, 60])
@pytest.mark.parametrize("work", [0.003, 0.02, 0.1])
def test_two_seconds_after_other_programs_all_threads_compute(machine, others, busy, work):
    machine.run(1, work=work)
    machine.others = others
    machine.run(busy, work=work)
    machine.others = 0
    machine.run(2, work=work)
    assert part_with_all(machine.run(1, work=work)) > 0.85


def test_a_start_beside_busy_programs(machine):
    machine.others = 2
    machine.run(1)
    assert machine.free.number == 1
    machine.others = 0
    machine.run(2)
    assert machine.free.number == 2


def test_a_slow_first_frame_does_not_count_for_long(machine):
    machine.frame(work=20)
    machine.run(1)
    assert machine.free.number == 2


def test_kinds_of_frames_are_not_compared_with_each_other(machine):
    for _ in range(100):
        machine.frame(work=0.02, kind="cold")
        machine.frame(work=0.005, kind="warm")
    assert machine.free.number == 2


def test_a_cancelled_frame_tells_nothing(machine):
    machine.run(1)
    with pytest.raises(InterruptedError):
        machine.cancelled_frame()
    assert machine.free.number == 2


def test_frames_of_another_size_are_measured_anew(machine):
    machine.run(1, work=0.01)
    machine.free.forget()
    machine.frame(work=0.1)
    assert machine.free.number == 2
