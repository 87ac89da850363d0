"""The oracle: cases that are what they were, ports that pass, mistakes that are found."""

import inspect
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections import Counter
from fnmatch import fnmatchcase
from pathlib import Path
from types import ModuleType

import naive_port
import numpy as np
import pytest

from oracle.cases import NEWEST, SECTIONS, STAGES, folder_of, read_cases, spec_of, write_input
from oracle.check import FAILED, NOT_OFFERED, PASSED, CommandPort, ModulePort, check
from oracle.make import cases
from oracle.stages import NEEDS, is_offered, run_case
from stylit_ref import __version__, passes
from stylit_ref.cli import main

NAIVE = Path(naive_port.__file__)


def first_failure(port):
    """The first case that fails, if any does."""
    outcomes = check(port, NEWEST)
    return next((outcome for outcome in outcomes if outcome.status == FAILED), None)


def test_every_stage_has_cases_and_a_section():
    titles = [case.stage for case in read_cases(NEWEST)]
    assert set(titles) == set(STAGES) == set(SECTIONS)
    spec = spec_of(NEWEST).read_text(encoding="utf-8")
    assert all(f"\n## {section}. " in spec for section in SECTIONS.values())
    assert all(f"\n| {stage} |" in spec for stage in STAGES)


def test_every_name_of_a_case_is_explained():
    table = spec_of(NEWEST).read_text(encoding="utf-8").partition("\n| name | why it is there |")[2]
    rows = re.findall(r"^\| (`.+`) \|", table.partition("\n## ")[0], re.MULTILINE)
    explained = {name.strip("`") for row in rows for name in row.split(", ")}
    used = set()
    for case in read_cases(NEWEST):
        plain = re.sub(r"_\d$", "", case.name)
        found = {name for name in explained if fnmatchcase(case.name, name) or name == plain}
        assert found, case.title
        used |= found
    assert used == explained


@pytest.mark.slow
def test_cases_are_what_this_library_makes_of_them(tmp_path):
    made = {case.title: case for case in cases()}
    kept = {case.title: case for case in read_cases(NEWEST)}
    assert made.keys() == kept.keys()
    for title, case in made.items():
        write_input(case, tmp_path)
        description = folder_of(NEWEST) / title / "case.json"
        assert (tmp_path / "case.json").read_bytes() == description.read_bytes()
        for ours, theirs in (
            (case.arrays, kept[title].arrays),
            (case.expected, kept[title].expected),
        ):
            assert ours.keys() == theirs.keys()
            for name, array in ours.items():
                np.testing.assert_array_equal(array, theirs[name], err_msg=f"{title} {name}")


def test_cases_are_awkward():
    """Each thing that a port may get wrong is there."""
    all_cases = {case.title: case for case in read_cases(NEWEST)}
    levels = [case for title, case in all_cases.items() if title.startswith("iteration/")]
    assert {case.parameters["patch_width"] for case in levels} == {3, 5, 7}
    assert any(case.parameters["occurrence_weight"] == 0 for case in levels)
    assert any((case.arrays["nnf"] < 0).any() for case in levels)
    assert any(np.unique(case.arrays["source"]).size == 1 for case in levels)
    styles = {case.arrays["source"].shape[2] - case.parameters["guide_channels"] for case in levels}
    assert styles == {1, 3, 4}
    assert all(
        (case.expected["nnf"] != case.arrays["nnf"]).any()
        for case in levels
        if "all_ties" not in case.title
    )


def test_our_passes_give_what_they_must():
    outcomes = list(check(ModulePort("stylit_ref.passes"), NEWEST))
    assert {outcome.status for outcome in outcomes} == {PASSED}


@pytest.mark.slow
def test_a_port_written_from_the_text_alone_gives_the_same():
    assert "stylit_ref" not in NAIVE.read_text(encoding="utf-8")
    assert first_failure(ModulePort("naive_port")) is None


MISTAKES = {
    "an off-by-one radius": (
        "while 2**k <= max(height, width) // 2:",
        "while 2**k < max(height, width) // 2:",
        "random_search",
    ),
    "a float metric": (
        "total += (weights * difference * difference).sum(axis=-1)",
        "total += (weights * difference * difference).astype(np.float32).sum(axis=-1).astype(int)",
        "delta",
    ),
    "a metric of doubles": (
        "total += (weights * difference * difference).sum(axis=-1)",
        "total = total + (weights * difference * difference).astype(float).sum(axis=-1)",
        "delta",
    ),
    "Ω live instead of committed": (
        """for class_y, class_x in order:
        in_class = (ys % 4 == class_y) & (xs % 4 == class_x) & assigned_pixels(nnf)""",
        """pixels = [(y, x) for c, d in order for y in range(c, len(ys), 4)
              for x in range(d, len(ys[0]), 4)]
    for pixel_y, pixel_x in pixels:
        in_class = (ys == pixel_y) & (xs == pixel_x) & assigned_pixels(nnf)""",
        "commit",
    ),
    "commit classes in another order": (
        "order = [(k // 4, k % 4) for k in range(16)]",
        "order = [(k % 4, k // 4) for k in range(16)]",
        "commit_order",
    ),
    "a swapped candidate order": (
        "((0, distance), (distance, 0), (0, -distance), (-distance, 0))",
        "((distance, 0), (0, distance), (0, -distance), (-distance, 0))",
        "propagation",
    ),
    "round half to even": (
        "(2 * total + n) // np.maximum(2 * n, 1)",
        "np.rint(total / np.maximum(n, 1)).astype(int)",
        "vote",
    ),
    "mirrored instead of clamped": (
        "y = np.clip(pixels[..., 0] + dy, 0, height - 1)",
        "y = np.pad(np.arange(height), 9, mode='symmetric')[pixels[..., 0] + dy + 9]",
        "delta",
    ),
    "an equal candidate replaces": (
        "better = valid & (candidate_phi < self.phi)",
        "better = valid & (candidate_phi <= self.phi)",
        "propagation",
    ),
    "the seed's words swapped": (
        "seed & WORD, (seed >> 32) & WORD",
        "(seed >> 32) & WORD, seed & WORD",
        "random_nnf",
    ),
    "an iteration counted from 0": (
        "for iteration in range(1, iterations + 1):",
        "for iteration in range(iterations):",
        "level",
    ),
    "a later claim wins a tie": (
        "error < delta_values[pixel]:",
        "error <= delta_values[pixel]:",
        "settle",
    ),
    "all claims made anew in a retrieval": (
        "for iteration in range(iterations * k + 1,",
        "claims[:] = 0\n        for iteration in range(iterations * k + 1,",
        "stylit_search",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_found_at_its_stage(mistake, monkeypatch):
    right, wrong, stage = MISTAKES[mistake]
    source = inspect.getsource(naive_port)
    assert right in source
    code = compile(source.replace(right, wrong, 1), f"<{mistake}>", "exec")
    mistaken = ModuleType("mistaken_port")
    exec(code, vars(mistaken))
    monkeypatch.setitem(sys.modules, "mistaken_port", mistaken)
    found = first_failure(ModulePort("mistaken_port"))
    assert found.stage == stage
    assert re.search(r"it must be .*(differ\)|\))$", found.difference.message)


@pytest.mark.slow
def test_cuda_kernels_give_what_they_must():
    """In Numba's simulator, which needs a process of its own."""
    command = [sys.executable, "-m", "stylit_ref.cli", "oracle", "check", "--module", "gpu_cuda"]
    command += ["--jobs", "2"]
    done = subprocess.run(
        command,
        check=False, capture_output=True, text=True,
        env=os.environ | {"NUMBA_ENABLE_CUDASIM": "1"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout
    counts = Counter(case.stage for case in read_cases(NEWEST))
    formulae_alone = "philox", "weights", "phi", "commit_order"
    beyond = *formulae_alone, *STAGES[STAGES.index("lower_bound") :]
    not_offered = sum(counts[stage] for stage in beyond)
    assert {status: int(n) for n, status in re.findall(r"(\d+) (.+?)[,\n]", done.stdout)} == {
        "not offered": not_offered,
        "passed": counts.total() - not_offered,
    }


class Listening:
    """Our passes, and which of them are asked for."""

    def __init__(self):
        self.heard = set()

    def __getattr__(self, name):
        self.heard.add(name)
        return getattr(passes, name)


@pytest.mark.parametrize("stage", NEEDS)
def test_a_stage_is_offered_where_a_module_has_all_that_it_uses(stage):
    ours = Listening()
    for case in read_cases(NEWEST, [stage]):
        run_case(stage, case.parameters, dict(case.arrays), ours)
    assert ours.heard == set(NEEDS[stage])
    few = ModuleType("few_passes")
    vars(few).update({name: getattr(passes, name) for name in NEEDS[stage]})
    assert is_offered(stage, few)
    for name in NEEDS[stage]:
        fewer = ModuleType("fewer_passes")
        vars(fewer).update({key: value for key, value in vars(few).items() if key != name})
        assert not is_offered(stage, fewer)


def test_only_what_a_module_does_is_checked(monkeypatch):
    mistaken = ModuleType("mistaken_passes")
    vars(mistaken).update({name: getattr(passes, name) for name in passes.__all__})
    mistaken.vote = lambda source, target, *rest: target.fill(7)
    monkeypatch.setitem(sys.modules, "mistaken_passes", mistaken)
    stages = ["philox", "downsample", "vote", "run"]
    outcomes = list(check(ModulePort("mistaken_passes"), NEWEST, stages))
    found = {outcome.stage: outcome.status for outcome in outcomes}
    assert found == {"philox": NOT_OFFERED, "downsample": PASSED, "vote": FAILED, "run": FAILED}


@pytest.mark.slow
def test_a_command_is_a_port(tmp_path, capsys):
    command = f"{sys.executable} {NAIVE} {{input}} {{output}}"
    report = tmp_path / "report.json"
    arguments = ["oracle", "check", "--port", command, "--stages", "commit,philox", "--jobs", "2"]
    arguments.append("--json")
    assert main([*arguments, str(report)]) == 0
    assert "passed" in capsys.readouterr().out
    outcomes = json.loads(report.read_text(encoding="utf-8"))["outcomes"]
    assert {outcome["status"] for outcome in outcomes} == {PASSED}
    assert [outcome["stage"] for outcome in outcomes[:2]] == ["philox", "commit"]


def test_a_port_that_fails_is_told_where(tmp_path, capsys):
    port = tmp_path / "port.py"
    port.write_text("import sys\nsys.exit('no such stage')\n", encoding="utf-8")
    command = f"{sys.executable} {port} {{input}} {{output}}"
    assert main(["oracle", "check", "--port", command, "--stages", "commit_order,knee"]) == 1
    said = capsys.readouterr().out
    assert "commit_order/first: failed: exit code 1: no such stage" in said
    assert "Begin with stage commit_order: section 9 of" in said


def test_expected_failures_do_not_count_but_unexpected_passes_do(tmp_path, capsys):
    wrong = "knee/*  # not yet\n"
    (tmp_path / "xfail.txt").write_text(wrong, encoding="utf-8")
    (tmp_path / "port.py").write_text("", encoding="utf-8")
    command = f"{sys.executable} {tmp_path / 'port.py'} {{input}} {{output}}"
    options = ["--stages", "knee", "--xfail", str(tmp_path / "xfail.txt")]
    assert main(["oracle", "check", "--port", command, *options]) == 0
    assert "1 failed as expected" in capsys.readouterr().out
    assert main(["oracle", "check", *options]) == 1
    assert "knee/ends: passed unexpectedly" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("found", "said"),
    [
        ({}, "order is not there"),
        ({"order": np.zeros((16, 2), np.int64)}, "order is int64; it must be int32"),
        ({"order": np.zeros((2, 16), np.int32)}, "order has shape (2, 16); it must be (16, 2)"),
    ],
)
def test_what_differs_is_named(found, said):
    (outcome, _) = check(lambda case: found, NEWEST, ["commit_order"])
    assert outcome.status == FAILED
    assert said in outcome.difference.message


@pytest.mark.parametrize(
    ("off", "status"), [(0, PASSED), (0.5, PASSED), (2, FAILED), (np.nan, FAILED)]
)
def test_a_tolerance_is_relative(off, status):
    (case,) = read_cases(NEWEST, ["knee"])
    found = {"x": case.expected["x"] * (1 + off * case.tolerances["x"])}
    (outcome,) = check(lambda case: found, NEWEST, ["knee"])
    assert outcome.status == status


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--port", ""], "port '' must name {input} and {output}"),
        (["--module", ""], "module '' cannot be imported"),
        (["--json", ""], "is a folder"),
        (["--cases", ""], "there are no cases ''"),
        (["--port", "true {input} {output}", "--module", "json"], "exclude each other"),
        (["--port", "true {input} {output}", "--timeout", "0"], "--timeout is 0; it must be above"),
        (["--port", "true {input} {output}", "--timeout", "nan"], "--timeout is nan"),
        (["--timeout", "5"], "--timeout is for a --port"),
        (["--jobs", "0", "--module", "no.such.module"], "--jobs is 0; it must be 1 or more"),
        (["--module", "json"], "module 'json' offers neither run_case nor a pass"),
        (["--stages", "philox", "--module", "numpy"], "nothing was checked"),
        (["--stages", "philo"], "'philo' is no stage"),
        (["--cases", "v0"], "there are no cases 'v0'; there are v1"),
        (["--port", "run it"], "must name {input} and {output}"),
        (["--port", "none {input} {output}"], "there is no program 'none'"),
        (["--port", "'none {input} {output}"], "is no command: No closing quotation"),
        (["--stages", ""], "'' is no stage"),
        (["--json", "nowhere/a.json"], "nowhere does not exist"),
        (["--module", "no.such.module"], "module 'no.such.module' cannot be imported"),
        (["--xfail", "nowhere.txt"], "nowhere.txt: cannot be read"),
        (["--xfail", "unknown.txt"], "unknown.txt: 'kne/*' names no case"),
    ],
)
def test_bad_arguments_are_one_sentence(arguments, said, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "unknown.txt").write_text("kne/*\n", encoding="utf-8")
    assert main(["oracle", "check", *arguments]) == 2
    assert said in capsys.readouterr().err


def test_a_report_does_not_overwrite_what_is_read(tmp_path, capsys):
    given = tmp_path / "xfail.txt"
    given.write_text("knee/*\n", encoding="utf-8")
    options = ["--stages", "knee", "--xfail", str(given), "--json", str(given)]
    assert main(["oracle", "check", *options]) == 2
    assert "xfail.txt: is read too; name another file" in capsys.readouterr().err
    assert given.read_text(encoding="utf-8") == "knee/*\n"


@pytest.mark.parametrize(
    ("program", "said"),
    [
        ("import sys; sys.stderr.buffer.write(b'\\xff no'); sys.exit(3)", "exit code 3: \ufffd no"),
        ("os.kill(os.getpid(), 11)", "signal SIGSEGV"),
        ("os.kill(os.getpid(), 40)", "signal 40"),
        ("print('no ' * 10**6); print('end'); sys.exit(3)", "exit code 3: ..."),
        ("sys.exit(str(sorted(os.listdir(IN))))", "exit code 1: ['case.json']"),
        ("os.mkfifo(OUT + '/order.npy')", "order.npy is no file"),
        ("import time; os.fork() or time.sleep(60)", "order.npy is not there"),
        ("", "order.npy is not there"),
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


@pytest.mark.slow
def test_a_program_has_so_long_and_no_heir(tmp_path, capsys):
    """What it starts ends with it."""
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
    assert main(["oracle", "check", *options]) == 1
    assert "knee/ends: failed: no end after 2 s" in capsys.readouterr().out
    assert ends(int((tmp_path / "pid").read_text(encoding="utf-8")))


def ends(process):
    """Whether a process that was killed ends soon; one that only waits to be collected has."""
    for _ in range(50):
        try:
            state = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
        except (FileNotFoundError, ProcessLookupError):
            return True
        if state.rpartition(")")[2].split()[0] == "Z":
            return True
        time.sleep(0.1)
    return False


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
    assert main(["oracle", "check", "--port", f"{port} {{input}} {{output}}", "--jobs", "2"]) == 2
    said = capsys.readouterr()
    assert f"{port} cannot be started: Exec format error" in said.err
    assert "failed" not in said.out


class Raised(Exception):  # noqa: N818
    pass


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        (None, "run_case returned NoneType; it must be a dict of arrays"),
        ([[1], [2, 3]], "run_case returned list; it must be a dict of arrays"),
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


@pytest.mark.slow
def test_a_module_that_ends_its_process_is_told(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    module = "import os\ndef run_case(*_): os._exit(3)\n"
    (tmp_path / "port_that_ends.py").write_text(module, encoding="utf-8")
    options = ["--module", "port_that_ends", "--stages", "knee", "--jobs", "2"]
    assert main(["oracle", "check", *options]) == 2
    assert "the module ended the process it ran in" in capsys.readouterr().err


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
        [sys.executable, "-m", "stylit_ref.cli", "oracle", "check", "--jobs", "3",
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


def test_the_report_says_where(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    module = "import numpy as np\ndef run_case(*_): return {'order': np.zeros((16, 2), np.int32)}\n"
    (tmp_path / "port_here.py").write_text(module, encoding="utf-8")
    arguments = ["--module", "port_here", "--stages", "commit_order", "--json", "report.json"]
    assert main(["oracle", "check", *arguments]) == 1
    report = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert (report["exit_code"], report["counts"]) == (1, {"failed": 2})
    first = report["outcomes"][0]
    (case, _) = read_cases(NEWEST, ["commit_order"])
    index = tuple(first["difference"]["index"])
    assert (first["stage"], first["name"], first["section"]) == ("commit_order", "first", "9")
    assert first["difference"]["array"] == "order"
    assert first["difference"]["expected"] == case.expected["order"][index] != 0
    assert first["difference"]["found"] == 0


def test_a_report_is_json(tmp_path, monkeypatch):
    """Which has no NaN."""
    monkeypatch.chdir(tmp_path)
    module = "def run_case(stage, parameters, arrays): return {'x': arrays['a'] + float('nan')}\n"
    (tmp_path / "port_of_nan.py").write_text(module, encoding="utf-8")
    arguments = ["--module", "port_of_nan", "--stages", "knee", "--json", "report.json"]
    assert main(["oracle", "check", *arguments]) == 1
    text = (tmp_path / "report.json").read_text(encoding="utf-8")
    report = json.loads(text, parse_constant=pytest.fail)
    assert report["stylit-ref"] == __version__
    difference = report["outcomes"][0]["difference"]
    assert (difference["found"], difference["index"]) == (None, [0])
    assert "x[0] is nan" in difference["message"]
