"""Work is shared among processes: each piece is done once, and no process stays behind."""

import os
import sys
import threading
from functools import partial

import pytest

from stylit_ref.machine import shared_work
from stylit_ref.machine.shared_work import share

only_with_forks = pytest.mark.skipif(
    sys.platform != "linux", reason="processes are forked on Linux"
)


@pytest.fixture(autouse=True)
def three_processes(monkeypatch):
    monkeypatch.setattr(shared_work, "get_num_threads", lambda: 3)


def ignore(number):
    """Nobody wants to know."""


def write(folder, number):
    (folder / str(number)).touch(exist_ok=False)


def written(folder):
    return sorted(int(file.name) for file in folder.iterdir())


def test_every_piece_is_done_once(tmp_path):
    share([partial(write, tmp_path, number) for number in range(20)], ignore)
    assert written(tmp_path) == list(range(20))


def test_this_process_does_the_first(tmp_path):
    begun = []
    share([partial(write, tmp_path, number) for number in range(3)], begun.append)
    assert begun[0] == 0


@pytest.fixture
def forks(monkeypatch):
    """The numbers of the forks, whatever threads the tests before have left in this process."""
    begun, fork = [], os.fork
    monkeypatch.setattr(shared_work, "possible_processes", lambda: 3)
    monkeypatch.setattr(os, "fork", lambda: begun.append(fork()) or begun[-1])
    return begun


@only_with_forks
def test_what_a_fork_fails_at_is_left_undone(tmp_path, forks):
    own = os.getpid()

    def fail_elsewhere(number):
        if os.getpid() != own:
            raise ValueError
        write(tmp_path, number)

    share([partial(fail_elsewhere, number) for number in range(5)], ignore)
    assert forks
    assert 0 in written(tmp_path)


@only_with_forks
def test_an_error_ends_the_forks(forks):
    own = os.getpid()

    def wait_elsewhere():
        if os.getpid() == own:
            raise ValueError("an error")
        threading.Event().wait(60)

    with pytest.raises(ValueError, match="an error"):
        share([wait_elsewhere] * 3, ignore)
    assert forks
    for each in forks:
        with pytest.raises(ChildProcessError):  # it is no child any more
            os.waitpid(each, os.WNOHANG)


def test_a_process_with_threads_is_alone():
    begun, end = [], threading.Event()
    thread = threading.Thread(target=end.wait)
    thread.start()
    share([int] * 5, begun.append)
    end.set()
    thread.join()
    assert begun == [0, 1, 2, 3, 4]
