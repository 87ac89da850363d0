"""Reports on publications: runs, verdicts, and when a page is written again."""

from dataclasses import dataclass

import numpy as np
import pytest

from eval.outcome import Outcome
from eval.pages.claims import (
    HELD,
    NOT_HELD,
    OPEN,
    Claim,
    by_case,
    claims_section,
    majority,
    verdict_section,
)
from eval.pages.document import Document, made_on, make_documents
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.textures import load_texture
from stylit_ref import InputError


@dataclass(frozen=True)
class Grey:
    """A method that shows grey, or fails."""

    fails: bool = False

    name, code, device, cost = "grey", "1", "here", 1.0

    def run(self, texture, seed, progress=None):
        if self.fails:
            raise MemoryError("too little")
        return Outcome(np.full((*texture.shape, 3), 128, np.uint8), 0.5)


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def document(*methods, inputs=()):
    texture = load_texture("bricks", (8, 8))
    tasks = [Task(Job(texture, method), ("usage",)) for method in methods]
    return Document("Grey", tasks, lambda report: made_on(tasks), list(inputs))


def test_a_page_is_written_again_only_if_something_changed(tmp_path, capsys):
    folder = tmp_path / "report"
    assert make_documents({folder: document(Grey())}) == 0
    assert "- stylit-ref" in (folder / "report.md").read_text(encoding="utf-8")
    assert "is up to date" not in capsys.readouterr().err
    assert make_documents({folder: document(Grey())}) == 0
    assert "is up to date" in capsys.readouterr().err
    assert make_documents({folder: document(Grey(), inputs=["other code"])}) == 0
    assert "is up to date" not in capsys.readouterr().err


def test_a_failed_run_is_named_and_there_is_no_page(tmp_path, capsys):
    folder = tmp_path / "report"
    assert make_documents({folder: document(Grey(), Grey(fails=True))}) == 1
    said = capsys.readouterr().err
    assert "eval: failed: bricks, grey, seed 0: MemoryError: too little" in said
    why = "is not written: 1 of 2 runs failed; the others are kept"
    assert f"eval: {folder / 'report.html'} {why}" in said
    assert not folder.exists()


def test_of_two_reports_with_a_run_in_common_that_without_failures_is_written(tmp_path, capsys):
    whole, lacking = tmp_path / "whole", tmp_path / "lacking"
    documents = {lacking: document(Grey(), Grey(fails=True)), whole: document(Grey())}
    assert make_documents(documents) == 1
    assert (whole / "report.html").exists()
    assert not lacking.exists()
    assert "is up to date" not in capsys.readouterr().err
    assert make_documents(documents) == 1
    assert f"eval: {whole / 'report.html'} is up to date" in capsys.readouterr().err


def failing(error):
    def sections(report):
        raise error

    return document(Grey())._replace(sections=sections)


def test_a_page_that_cannot_be_written_is_named_and_the_others_are_written(tmp_path, capsys):
    bad, whole = tmp_path / "bad", tmp_path / "whole"
    documents = {bad: failing(InputError("is odd", parameter="sketch")), whole: document(Grey())}
    assert make_documents(documents) == 2
    assert f"eval: {bad / 'report.html'} is not written: sketch is odd" in capsys.readouterr().err
    assert (whole / "report.html").exists()


def test_a_fault_in_a_page_is_raised_when_the_others_are_written(tmp_path):
    bad, whole = tmp_path / "bad", tmp_path / "whole"
    with pytest.raises(ZeroDivisionError):
        make_documents({bad: failing(ZeroDivisionError()), whole: document(Grey())})
    assert (whole / "report.html").exists()


def test_a_tie_does_not_hold():
    assert majority([True, False]) == NOT_HELD
    assert majority([True, False, True]) == HELD


def test_verdicts_are_counted_and_listed():
    claims = [Claim(name, "3", each, "", "") for name, each in (("a", HELD), ("b", OPEN))]
    title, counts, table = verdict_section(claims)
    assert title == "## Verdicts"
    assert counts.startswith("Of 2 claims 1 held and 0 did not; 1 cannot be judged here.")
    assert [line.split("|")[1:4] for line in table.replace(" ", "").splitlines()[2:]] == [
        ["1", "a", "held"],
        ["2", "b", "cannotbejudgedhere"],
    ]


def test_equal_figures_are_told_once():
    assert by_case({"a": "3"}) == "3 for a"
    assert by_case({"a": "3", "b": "4", "c": "3"}) == "3 for a and c, and 4 for b"
    assert by_case(dict(zip("abc", "345", strict=True))) == "3 for a; 4 for b, and 5 for c"


def test_a_claim_shows_its_rule_and_figures_and_its_table_has_no_flags():
    tables = {}

    class Report:
        def csv(self, name, numbers):
            tables[name] = list(numbers.columns)
            return name

    claim = Claim("It is grey", "3", OPEN, "all is grey", "nothing was seen", of_time=True)
    title, text, _ = claims_section("Claims", [claim], Report())
    assert title == "## Claims"
    assert text == (
        "1. **It is grey** (3): **cannot be judged here**. Nothing was seen. *It counts as held if "
        "all is grey.*"
    )
    assert tables == {"claims": ["claim", "section", "verdict", "rule", "evidence"]}
