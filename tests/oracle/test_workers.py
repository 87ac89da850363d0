"""Processes that share the cases leave nothing behind."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from processes import ends

from oracle.__main__ import main


def test_a_module_that_ends_its_process_is_told(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    module = "import os\ndef run_case(*_): os._exit(3)\n"
    (tmp_path / "port_that_ends.py").write_text(module, encoding="utf-8")
    options = ["--module", "port_that_ends", "--stages", "knee", "--jobs", "2"]
    assert main(["check", *options]) == 2
    assert "the module ended the process that it ran in" in capsys.readouterr().err


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interruption_leaves_neither_process_nor_folder(number, tmp_path):
    """Two workers run a program meanwhile, one has nothing more to do."""
    port = tmp_path / "port.py"
    port.write_text(
        "import os, pathlib, sys, time\n"
        "pathlib.Path(sys.argv[1], str(os.getpid())).touch()\n"
        "'knee' in pathlib.Path(sys.argv[2], 'case.json').read_text() or time.sleep(60)\n",
        encoding="utf-8",
    )
    pids, scratch = tmp_path / "pids", tmp_path / "scratch"
    pids.mkdir()
    scratch.mkdir()
    command = f"{sys.executable} {port} {pids} {{input}} {{output}}"
    checker = subprocess.Popen(
        [sys.executable, "-m", "oracle", "check", "--jobs", "3",
         "--stages", "commit_order,knee", "--port", command],
        env=os.environ | {"TMPDIR": str(scratch)}, stderr=subprocess.PIPE, text=True,
        start_new_session=True,
    )  # fmt: skip
    try:
        while len(list(pids.iterdir())) < 3 and checker.poll() is None:
            time.sleep(0.1)
        children = Path(f"/proc/{checker.pid}/task/{checker.pid}/children")
        for worker in children.read_text(encoding="utf-8").split():
            os.kill(int(worker), signal.SIGINT)  # it is for the checker to heed
        time.sleep(0.5)
        os.killpg(checker.pid, number)  # as a terminal does: the checker and its workers
        said = checker.communicate(timeout=30)[1]
    finally:
        checker.kill()
    assert checker.returncode == 130
    assert "Traceback" not in said
    programs = [int(file.name) for file in pids.iterdir()]
    assert len(programs) == 3
    assert all(map(ends, programs))
    assert list(scratch.iterdir()) == []
