"""Work that several processes are given is done by one of them."""

import os
import signal
import subprocess
import sys
import time

import pytest

from stylit_ref.machine import once as module
from stylit_ref.machine.once import once

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such locks")

HOLD = """
import sys, time
from pathlib import Path
from stylit_ref.machine.once import once
with once(Path(sys.argv[1]), 7, lambda: False, waiting=False) as is_ours:
    print(is_ours, flush=True)
    time.sleep(60)
"""


def never():
    return False


@pytest.fixture
def holder(tmp_path):
    """A process that has begun work number 7."""
    process = subprocess.Popen([sys.executable, "-c", HOLD, tmp_path], stdout=subprocess.PIPE)
    assert process.stdout.readline() == b"True\n"
    yield process
    process.kill()
    process.communicate()


def test_another_process_leaves_it_out(tmp_path, holder):
    with once(tmp_path, 7, never, waiting=False) as is_ours:
        assert not is_ours
    with once(tmp_path, 8, never, waiting=False) as is_ours:
        assert is_ours


def test_it_is_free_when_the_process_ends(tmp_path, holder):
    os.kill(holder.pid, signal.SIGKILL)
    holder.wait()
    with once(tmp_path, 7, never, waiting=False) as is_ours:
        assert is_ours


def test_who_waits_goes_on_when_the_result_is_there(tmp_path, holder):
    answers = iter([False, False, True])
    with once(tmp_path, 7, lambda: next(answers), waiting=True) as is_ours:
        assert is_ours
    assert next(answers, None) is None


def test_nobody_waits_for_a_stopped_process_for_ever(tmp_path, holder, monkeypatch):
    monkeypatch.setattr(module, "_PATIENCE", 0.2)
    begun = time.monotonic()
    with once(tmp_path, 7, never, waiting=True) as is_ours:
        assert is_ours
    assert time.monotonic() - begun >= 0.2


def test_without_a_folder_every_process_does_it(tmp_path):
    (tmp_path / "file").touch()
    with once(tmp_path / "file" / "none", 7, never, waiting=False) as is_ours:
        assert is_ours
