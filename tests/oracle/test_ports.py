"""Programs and modules as ports, whatever they may do."""

import os
import sys
from types import ModuleType

import numpy as np
import pytest
from processes import ends

from oracle.__main__ import main
from oracle.cases import read_cases
from oracle.check import check
from oracle.compare import FAILED, NOT_OFFERED, PASSED
from oracle.families import NEWEST
from oracle.ports import CommandPort, ModulePort


@pytest.mark.parametrize(
    ("program", "said"),
    [
        ("import sys; sys.stderr.buffer.write(b'\\xff no'); sys.exit(3)", "exit code 3: \ufffd no"),
        ("os.kill(os.getpid(), 11)", "signal SIGSEGV"),
        ("os.kill(os.getpid(), 40)", "signal 40"),
        ("print('no ' * 10**6); print('end'); sys.exit(3)", "exit code 3: ..."),
        ("sys.exit(str(sorted(os.listdir(IN))))", "exit code 1: ['case.json']"),
        ("os.mkfifo(OUT + '/order.npy')", "order.npy is not a regular file"),
        ("import time; os.fork() or time.sleep(60)", "order.npy is missing"),
        ("", "order.npy is missing"),
        ("open(OUT + '/order.npy', 'w').write('1 2')", "order.npy cannot be read as an array"),
        ("np.save(OUT + '/order.npy', np.array([None]))", "order.npy cannot be read as an array"),
        ("np.save(OUT + '/order.npy', np.zeros((16, 2), '>i4'))", "order is >i4; it must be int32"),
        ("np.save(OUT + '/order.npy', ORDER); open(OUT + '/junk.npy', 'w')", ""),
        ("np.save(OUT + '/order.npy', np.asfortranarray(ORDER)); print(chr(0xDC80))", ""),
    ],
)
def test_what_a_program_may_do(tmp_path, program, said):
    (case, _) = read_cases(NEWEST, ["commit_order"])
    np.save(tmp_path / "order.npy", case.expected["order"])
    port = tmp_path / "a port.py"
    port.write_text(
        "import os, sys\nimport numpy as np\nOUT, IN = sys.argv[1:]\n"
        f"ORDER = np.load({str(tmp_path / 'order.npy')!r})\n{program}\n",
        encoding="utf-8",
    )
    command = f"'{sys.executable}' '{port}' {{output}} {{input}}"
    outcome = next(check(CommandPort(command), NEWEST, ["commit_order"]))
    if said:
        assert outcome.status == FAILED
        assert outcome.difference.message.startswith(said)
        assert len(outcome.difference.message) < 400
    else:
        assert (outcome.status, outcome.difference) == (PASSED, None)


@pytest.mark.parametrize(
    ("program", "said"),
    [
        (
            "print('ready'); print('panicked at main.rs:5'); [print(k) for k in range(99)]",
            "exit code 1: panicked at main.rs:5 | ... | 96 | 97 | 98",
        ),
        (
            "print('Exception ' + 'x' * 999); [print('at ' + 'y' * 99) for _ in range(9)]",
            f"exit code 1: Exception {'x' * 140}... | ...{'y' * 45} | at {'y' * 99}",
        ),
        ("raise KeyError('vote')", "exit code 1: {}, line 2, in <module> | raise KeyError('vote')"),
        ("print('by default'); [print(k) for k in range(9)]", "exit code 1: 6 | 7 | 8"),
        (
            "print('\\x1b[31merror'); [print(k) for k in range(3)]",
            "exit code 1: \ufffd[31merror | ",
        ),
    ],
)
def test_the_first_error_of_a_program_is_told(tmp_path, program, said):
    port = tmp_path / "port.py"
    port.write_text(f"import sys\n{program}\nsys.exit(1)\n", encoding="utf-8")
    port_command = CommandPort(f"{sys.executable} {port} {{input}} {{output}}")
    (outcome,) = check(port_command, NEWEST, ["knee"])
    assert outcome.difference.message.startswith(said.format(f'File "{port}"'))
    assert len(outcome.difference.message) < 400


def test_a_program_says_by_its_exit_code_that_it_does_not_do_a_stage(tmp_path):
    port = tmp_path / "port.py"
    port.write_text("import sys\nsys.exit(77)\n", encoding="utf-8")
    (outcome,) = check(
        CommandPort(f"{sys.executable} {port} {{input}} {{output}}"), NEWEST, ["knee"]
    )
    assert outcome.status == NOT_OFFERED


@pytest.mark.slow
def test_a_program_has_so_long_and_no_heir(tmp_path, capsys):
    """Processes that a program started end with it."""
    port = tmp_path / "port.py"
    port.write_text(
        "import pathlib, subprocess, sys, time\n"
        "child = subprocess.Popen(['sleep', '60'])\n"
        "pathlib.Path(sys.argv[1]).write_text(str(child.pid))\n"
        "time.sleep(60)\n",
        encoding="utf-8",
    )
    command = f"{sys.executable} {port} {tmp_path}/pid {{input}} {{output}}"
    options = ["--port", command, "--timeout", "2", "--stages", "knee"]
    assert main(["check", *options]) == 1
    assert "knee/ends: failed: did not end within 2 s" in capsys.readouterr().out
    assert ends(int((tmp_path / "pid").read_text(encoding="utf-8")))


def test_a_program_does_not_read_what_the_checker_is_given(tmp_path):
    port = tmp_path / "port.py"
    port.write_text("import sys\nsys.exit(f'read {sys.stdin.read()!r}')\n", encoding="utf-8")
    port = CommandPort(f"{sys.executable} {port} {{input}} {{output}}")
    given, giving = os.pipe()
    os.write(giving, b"a line")
    os.close(giving)
    own = os.dup(0)
    os.dup2(given, 0)
    try:
        (outcome,) = check(port, NEWEST, ["knee"])
    finally:
        os.dup2(own, 0)
        os.close(own)
        os.close(given)
    assert outcome.difference.message == "exit code 1: read ''"


def test_a_program_that_cannot_be_started_is_told_once(tmp_path, capsys):
    port = tmp_path / "port"
    port.write_text("no line that names an interpreter\n", encoding="utf-8")
    port.chmod(0o755)
    assert main(["check", "--port", f"{port} {{input}} {{output}}", "--jobs", "2"]) == 2
    said = capsys.readouterr()
    assert f"{port} cannot be started: Exec format error" in said.err
    assert "failed" not in said.out


class Raised(Exception):  # noqa: N818
    pass


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        (None, "run_case returned NoneType; it must return a dict of arrays"),
        ([[1], [2, 3]], "run_case returned list; it must return a dict of arrays"),
        ({"order": [[1], [2, 3]]}, "ValueError: setting an array element"),
        (SystemExit(0), "SystemExit: 0"),
        (Raised("\udc80"), r"Raised: \udc80"),
    ],
)
def test_what_a_module_may_do(answer, said, monkeypatch):
    def answering(stage, parameters, arrays):
        if isinstance(answer, BaseException):
            raise answer
        return answer

    module = ModuleType("answering_port")
    module.run_case = answering
    monkeypatch.setitem(sys.modules, "answering_port", module)
    outcome = next(check(ModulePort("answering_port"), NEWEST, ["commit_order"]))
    assert outcome.status == FAILED
    assert outcome.difference.message.startswith(said)
