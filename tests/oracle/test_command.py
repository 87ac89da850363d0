"""The command line of the checker: what it refuses, what it says, what it writes."""

import json
import sys
from pathlib import Path

import naive_port
import pytest

from oracle.__main__ import main
from oracle.cases import read_cases
from oracle.compare import PASSED
from oracle.families import NEWEST, folder_of
from oracle.report import HOW_TO_DECLINE
from stylit_ref import __version__

NAIVE = Path(naive_port.__file__).parent


def test_a_command_is_a_port(tmp_path, capsys):
    command = f"{sys.executable} {NAIVE} {{input}} {{output}}"
    report = tmp_path / "report.json"
    arguments = ["check", "--port", command, "--stages", "commit_order,philox", "--jobs", "2"]
    arguments.append("--json")
    assert main([*arguments, str(report)]) == 0
    assert "passed" in capsys.readouterr().out
    outcomes = json.loads(report.read_text(encoding="utf-8"))["outcomes"]
    assert {outcome["status"] for outcome in outcomes} == {PASSED}
    assert [outcome["stage"] for outcome in outcomes[:2]] == ["philox", "commit_order"]


def test_a_port_that_fails_is_told_where(tmp_path, capsys):
    port = tmp_path / "port.py"
    port.write_text("import sys\nsys.exit('no such stage')\n", encoding="utf-8")
    command = f"{sys.executable} {port} {{input}} {{output}}"
    assert main(["check", "--port", command, "--stages", "commit_order,knee"]) == 1
    said = capsys.readouterr().out
    assert "commit_order/first: failed: exit code 1: no such stage" in said
    assert "Begin with stage commit_order: section 9 of" in said


BEGUN = """
import naive_port
def run_case(stage, parameters, arrays):
    if stage in ("philox", "commit_order"):
        return naive_port.run_case(stage, parameters, arrays)
    if stage == "weights":
        return {"weights": arrays}
    raise {error}
"""


def lines_of_a_port_just_begun(error, folder, capsys, monkeypatch):
    """What the checker says of a port that does two stages, and a third one wrong."""
    name = f"begun_{len(error)}"
    (folder / f"{name}.py").write_text(BEGUN.replace("{error}", error), encoding="utf-8")
    monkeypatch.chdir(folder)
    assert main(["check", "--module", name]) == 1
    return capsys.readouterr().out.splitlines()


@pytest.mark.parametrize("error", ["KeyError(stage)", "ValueError(f'no stage {stage} yet')"])
def test_stages_that_a_port_does_not_know_share_a_line(error, tmp_path, capsys, monkeypatch):
    lines = lines_of_a_port_just_begun(error, tmp_path, capsys, monkeypatch)
    unknown = [line for line in lines if "Error" in line and not line.startswith("weights/")]
    assert len(unknown) == 2
    assert unknown[0].startswith("random_nnf/all_ties: failed: ")
    assert "(so do all 217 cases of random_nnf, downsample, " in unknown[0]
    assert unknown[0].endswith("stylit_search, stylit_run)")
    assert unknown[1] == HOW_TO_DECLINE
    assert sum(line.startswith("weights/") for line in lines) == 13
    assert len(lines) == 13 + 2 + 2


def test_stages_that_a_port_does_not_offer_are_named_once(tmp_path, capsys, monkeypatch):
    error = "NotImplementedError"
    lines = lines_of_a_port_just_begun(error, tmp_path, capsys, monkeypatch)
    assert lines[13] == "3 passed, 13 failed, 217 not offered"
    assert lines[14].startswith("Not offered: random_nnf, downsample, ")
    assert lines[15].startswith("Begin with stage weights: section 2 of ")
    assert len(lines) == 16


def test_failures_of_one_stage_need_no_advice(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    module = "def run_case(*_): raise ValueError('no')\n"
    (tmp_path / "port_that_fails.py").write_text(module, encoding="utf-8")
    assert main(["check", "--module", "port_that_fails", "--stages", "commit_order"]) == 1
    assert capsys.readouterr().out.splitlines()[:2] == [
        "commit_order/first: failed: ValueError: no (so do all 2 cases of commit_order)",
        "2 failed",
    ]


def test_the_folder_of_the_cases_is_printed(capsys):
    assert main(["cases"]) == main(["cases", NEWEST]) == 0
    assert capsys.readouterr().out == f"{folder_of(NEWEST)}\n" * 2
    assert main(["cases", "v0"]) == 2
    assert "there is no version 'v0' of the cases; choose one of: v1" in capsys.readouterr().err


def test_expected_failures_do_not_count_but_unexpected_passes_do(tmp_path, capsys):
    wrong = "knee/*  # not yet\n"
    (tmp_path / "xfail.txt").write_text(wrong, encoding="utf-8")
    (tmp_path / "port.py").write_text("", encoding="utf-8")
    command = f"{sys.executable} {tmp_path / 'port.py'} {{input}} {{output}}"
    options = ["--stages", "knee", "--xfail", str(tmp_path / "xfail.txt")]
    assert main(["check", "--port", command, *options]) == 0
    assert "1 failed as expected" in capsys.readouterr().out
    assert main(["check", *options]) == 1
    assert "knee/ends: passed unexpectedly" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--port", ""], "port '' must contain {input} and {output}"),
        (["--module", ""], "module '' cannot be imported"),
        (["--json", ""], "is a folder"),
        (["--cases", ""], "there is no version ''"),
        (["--port", "true {input} {output}", "--module", "json"], "cannot be used together"),
        (["--port", "true {input} {output}", "--timeout", "0"], "--timeout is 0; it must be above"),
        (["--port", "true {input} {output}", "--timeout", "nan"], "--timeout is nan"),
        (["--timeout", "5"], "--timeout needs --port"),
        (["--jobs", "0", "--module", "no.such.module"], "--jobs is 0; it must be 1 or more"),
        (["--module", "json"], "module 'json' offers neither run_case nor a pass"),
        (["--stages", "philox", "--module", "numpy"], "nothing was checked"),
        (["--stages", "philo"], "'philo', which is not a stage of these cases; they are philox"),
        (["--stages", "cut"], "'cut', which is not a stage of these cases; write --cases texture"),
        (["--cases", "v0"], "there is no version 'v0' of the cases; choose one of: v1"),
        (["--port", "run it"], "must contain {input} and {output}"),
        (["--port", "none {input} {output}"], "cannot be run: there is no program 'none'"),
        (["--port", "'none {input} {output}"], "is not a command: No closing quotation"),
        (["--stages", ""], "'', which is not a stage"),
        (["--json", "unknown.txt/a.json"], "unknown.txt: is a file; name a folder"),
        (["--module", "my_port.py"], "Python imports modules by name; write my_port"),
        (["--module", "no.such.module"], "module 'no.such.module' cannot be imported"),
        (["--xfail", "nowhere.txt"], "nowhere.txt: cannot be read"),
        (["--xfail", "unknown.txt"], "unknown.txt: 'kne/*' matches no case"),
    ],
)
def test_bad_arguments_are_one_sentence(arguments, said, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "unknown.txt").write_text("kne/*\n", encoding="utf-8")
    assert main(["check", *arguments]) == 2
    assert said in capsys.readouterr().err


def test_a_report_does_not_overwrite_what_is_read(tmp_path, capsys):
    given = tmp_path / "xfail.txt"
    given.write_text("knee/*\n", encoding="utf-8")
    options = ["--stages", "knee", "--xfail", str(given), "--json", str(given)]
    assert main(["check", *options]) == 2
    assert (
        "xfail.txt: the output would overwrite this input; name another file"
        in capsys.readouterr().err
    )
    assert given.read_text(encoding="utf-8") == "knee/*\n"


def test_the_report_says_where(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    module = "import numpy as np\ndef run_case(*_): return {'order': np.zeros((16, 2), np.int32)}\n"
    (tmp_path / "port_here.py").write_text(module, encoding="utf-8")
    arguments = ["--module", "port_here", "--stages", "commit_order", "--json", "report.json"]
    assert main(["check", *arguments]) == 1
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
    assert main(["check", *arguments]) == 1
    text = (tmp_path / "report.json").read_text(encoding="utf-8")
    report = json.loads(text, parse_constant=pytest.fail)
    assert report["stylit-ref"] == __version__
    difference = report["outcomes"][0]["difference"]
    assert (difference["found"], difference["index"]) == (None, [0])
    assert "x[0] is nan" in difference["message"]
