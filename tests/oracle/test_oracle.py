"""The oracle: cases that are what they were, ports that pass, mistakes that are found."""

import hashlib
import inspect
import json
import os
import re
import shutil
import subprocess
import sys
from collections import Counter
from pathlib import Path
from types import ModuleType

import jsonschema
import naive_port
import numpy as np
import pytest

from oracle.__main__ import main as make
from oracle.cases import SECTIONS, STAGES, VERSIONS, damaged_files, folder_of, read_cases
from oracle.check import FAILED, NOT_OFFERED, PASSED, CommandPort, ModulePort, check
from oracle.make import cases
from stylit_ref import passes
from stylit_ref.cli import main

NAIVE = Path(naive_port.__file__)


def failed_stages(port, stages=STAGES):
    """Stages with a case that failed, in order, and the first message."""
    bad = [outcome for outcome in check(port, "v1", stages) if outcome.status == FAILED]
    found = list(dict.fromkeys(outcome.stage for outcome in bad))
    return found, bad[0].difference.message if bad else ""


DIGESTS = {
    "v1": "a23247307f921b0d0b3a43e0ad296c2d1163fde9e89d5f05d04ea891f6a136f7",
}
"""SHA-256 of the SHA256SUMS of every version: what is published never changes."""


def test_published_versions_are_what_they_were():
    assert DIGESTS.keys() == set(VERSIONS)
    for version, digest in DIGESTS.items():
        assert damaged_files(version) == {}
        assert (
            hashlib.sha256((folder_of(version) / "SHA256SUMS").read_bytes()).hexdigest() == digest
        )


def test_descriptions_follow_the_schema():
    text = (folder_of("v1") / "case.schema.json").read_text(encoding="utf-8")
    schema = jsonschema.Draft202012Validator(json.loads(text))
    schema.check_schema(schema.schema)
    files = sorted(folder_of("v1").glob("*/*/case.json"))
    assert len(files) > 200
    for file in files:
        schema.validate(json.loads(file.read_text(encoding="utf-8")))


def test_every_stage_has_cases_and_a_section():
    titles = [case.stage for case in read_cases("v1")]
    assert set(titles) == set(STAGES) == set(SECTIONS)
    spec = (folder_of("v1").parent / "SPEC.md").read_text(encoding="utf-8")
    assert all(f"\n## {section}. " in spec for section in SECTIONS.values())
    assert all(f"\n| {stage} |" in spec for stage in STAGES)


def test_cases_are_what_this_library_makes_of_them():
    made = {case.title: case for case in cases()}
    kept = {case.title: case for case in read_cases("v1")}
    assert made.keys() == kept.keys()
    for title, case in made.items():
        assert case.parameters == kept[title].parameters
        for ours, theirs in (
            (case.arrays, kept[title].arrays),
            (case.expected, kept[title].expected),
        ):
            assert ours.keys() == theirs.keys()
            for name, array in ours.items():
                np.testing.assert_array_equal(array, theirs[name], err_msg=f"{title} {name}")


def test_cases_are_awkward():
    """Each thing that a port may get wrong is there."""
    all_cases = {case.title: case for case in read_cases("v1")}
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
    outcomes = list(check(ModulePort("stylit_ref.passes"), "v1"))
    assert {outcome.status for outcome in outcomes} == {PASSED}


def test_a_port_written_from_the_text_alone_gives_the_same():
    assert "stylit_ref" not in NAIVE.read_text(encoding="utf-8")
    assert failed_stages(ModulePort("naive_port")) == ([], "")


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


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_found_at_its_stage(mistake, monkeypatch):
    right, wrong, stage = MISTAKES[mistake]
    source = inspect.getsource(naive_port)
    assert right in source
    code = compile(source.replace(right, wrong, 1), f"<{mistake}>", "exec")
    mistaken = ModuleType("mistaken_port")
    exec(code, vars(mistaken))
    monkeypatch.setitem(sys.modules, "mistaken_port", mistaken)
    found, message = failed_stages(ModulePort("mistaken_port"))
    assert found[0] == stage
    assert "it must be" in message
    assert "differ)" in message or "shape" in message


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
    counts = Counter(case.stage for case in read_cases("v1"))
    formulae_alone = "philox", "weights", "phi", "commit_order"
    beyond = *formulae_alone, *STAGES[STAGES.index("lower_bound") :]
    not_offered = sum(counts[stage] for stage in beyond)
    counted = Counter(dict(re.findall(r"(\d+) (.+?)[,\n]", done.stdout)[::-1]))
    assert {status: int(number) for number, status in counted.items()} == {
        "not offered": not_offered,
        "passed": counts.total() - not_offered,
    }


def test_only_what_a_module_does_is_checked(capsys, monkeypatch):
    mistaken = ModuleType("mistaken_passes")
    vars(mistaken).update({name: getattr(passes, name) for name in passes.__all__})
    mistaken.vote = lambda source, target, *rest: target.fill(7)
    monkeypatch.setitem(sys.modules, "mistaken_passes", mistaken)
    stages = ["philox", "downsample", "vote", "run"]
    outcomes = list(check(ModulePort("mistaken_passes"), "v1", stages))
    found = {outcome.stage: outcome.status for outcome in outcomes}
    assert found == {"philox": NOT_OFFERED, "downsample": PASSED, "vote": FAILED, "run": FAILED}
    assert main(["oracle", "check", "--module", "json"]) == 2
    assert "json: offers neither run_case nor a pass" in capsys.readouterr().err


def test_a_command_is_a_port(tmp_path, capsys):
    command = f"{sys.executable} {NAIVE} {{input}} {{output}}"
    report = tmp_path / "report.json"
    arguments = ["oracle", "check", "--port", command, "--stages", "philox,commit", "--jobs", "2"]
    arguments.append("--json")
    assert main([*arguments, str(report)]) == 0
    assert "passed" in capsys.readouterr().out
    outcomes = json.loads(report.read_text(encoding="utf-8"))["outcomes"]
    assert {outcome["status"] for outcome in outcomes} == {PASSED}


def test_a_port_that_fails_is_told_where(tmp_path, capsys):
    port = tmp_path / "port.py"
    port.write_text("import sys\nsys.exit('no such stage')\n", encoding="utf-8")
    command = f"{sys.executable} {port} {{input}} {{output}}"
    assert main(["oracle", "check", "--port", command, "--stages", "commit_order,knee"]) == 1
    said = capsys.readouterr().out
    assert "commit_order/first: failed: RuntimeError: exit code 1: no such stage" in said
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
    (outcome, _) = check(lambda case: found, "v1", ["commit_order"])
    assert outcome.status == FAILED
    assert said in outcome.difference.message


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--stages", "philo"], "'philo' is no stage"),
        (["--cases", "v2"], "there are no cases 'v2'; there are v1"),
        (["--port", "run it"], "must name {input} and {output}"),
        (["--port", "none {input} {output}"], "there is no program 'none'"),
        (["--port", "'none {input} {output}"], "is no command: No closing quotation"),
        (["--stages", ""], "'' is no stage"),
        (["--stages", "knee", "--module", "json"], "json: offers neither"),
        (["--json", "nowhere/a.json"], "nowhere does not exist"),
        (["--module", "no.such.module"], "no.such.module: cannot be imported"),
        (["--xfail", "nowhere.txt"], "nowhere.txt: cannot be read"),
    ],
)
def test_bad_arguments_are_one_sentence(arguments, said, capsys):
    assert main(["oracle", "check", *arguments]) == 2
    assert said in capsys.readouterr().err


@pytest.mark.parametrize(
    ("program", "said"),
    [
        ("import sys; sys.stderr.buffer.write(b'\\xff no'); sys.exit(3)", "exit code 3: \ufffd no"),
        ("import os; os.kill(os.getpid(), 11)", "signal SIGSEGV"),
        ("import time; time.sleep(60)", "no end after 2 s"),
        ("import time, os; os.fork() or time.sleep(60)", "order.npy is not there"),
        ("", "order.npy is not there"),
        ("open(OUT + '/order.npy', 'w').write('1 2')", "order.npy cannot be read as an array"),
        ("np.save(OUT + '/order.npy', np.array([None]))", "order.npy cannot be read as an array"),
        ("np.save(OUT + '/order.npy', np.zeros((16, 2), '>i4'))", "order is >i4; it must be int32"),
        ("np.save(OUT + '/order.npy', ORDER); open(OUT + '/junk.npy', 'w')", ""),
        ("np.save(OUT + '/order.npy', np.asfortranarray(ORDER)); print(chr(0xDC80))", ""),
    ],
)
def test_what_a_program_may_do(tmp_path, program, said):
    (case, _) = read_cases("v1", ["commit_order"])
    np.save(tmp_path / "order.npy", case.expected["order"])
    port = tmp_path / "a port.py"
    port.write_text(
        "import sys\nimport numpy as np\nOUT = sys.argv[1]\n"
        f"ORDER = np.load({str(tmp_path / 'order.npy')!r})\n{program}\n",
        encoding="utf-8",
    )
    command = f"'{sys.executable}' '{port}' {{output}} {{input}}"
    outcome = next(check(CommandPort(command, timeout=2), "v1", ["commit_order"]))
    if said:
        assert outcome.status == FAILED
        assert said in outcome.difference.message
    else:
        assert (outcome.status, outcome.difference) == (PASSED, None)


@pytest.mark.parametrize("answer", [None, [[1], [2, 3]], {"order": [[1], [2, 3]]}, SystemExit(0)])
def test_what_a_module_may_do(answer):
    def port(case):
        if isinstance(answer, SystemExit):
            raise answer
        return answer

    outcome = next(check(port, "v1", ["commit_order"]))
    assert outcome.status == FAILED


def test_the_report_says_where(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    module = "import numpy as np\ndef run_case(*_): return {'order': np.zeros((16, 2), np.int32)}\n"
    (tmp_path / "port_here.py").write_text(module, encoding="utf-8")
    arguments = ["--module", "port_here", "--stages", "commit_order", "--json", "report.json"]
    assert main(["oracle", "check", *arguments]) == 1
    report = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert (report["exit_code"], report["counts"]) == (1, {"failed": 2})
    first = report["outcomes"][0]
    (case, _) = read_cases("v1", ["commit_order"])
    index = tuple(first["difference"]["index"])
    assert (first["stage"], first["name"], first["section"]) == ("commit_order", "first", "9")
    assert first["difference"]["array"] == "order"
    assert first["difference"]["expected"] == case.expected["order"][index] != 0
    assert first["difference"]["found"] == 0


def test_published_cases_are_not_made_again(capsys):
    assert make(["make"]) == 2
    assert "v1 has its SHA256SUMS and never changes" in capsys.readouterr().err


def test_damage_is_told(tmp_path, monkeypatch):
    shutil.copytree(folder_of("v1"), tmp_path / "v1")
    (tmp_path / "v1" / ".DS_Store").touch()
    (tmp_path / "v1" / "knee" / "ends" / "a.npy").unlink()
    (tmp_path / "v1" / "knee" / "ends" / "b.npy").write_bytes(b"")
    monkeypatch.setattr("oracle.cases.folder_of", lambda version: tmp_path / version)
    assert damaged_files("v1") == {
        "knee/ends/a.npy": "is missing",
        "knee/ends/b.npy": "differs from SHA256SUMS",
    }
