"""The front page of all reports, and what happens if one of them cannot be made."""

import re
from dataclasses import dataclass
from types import SimpleNamespace

import pandas as pd
import pytest

from eval.__main__ import main
from eval.pages.claims import HELD, NOT_HELD, OPEN
from eval.pages.document import Document
from eval.pages.page import BUILT
from eval.reports import documents
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.textures import load_texture
from stylit_ref import InputError


@dataclass(frozen=True)
class Fails:
    """A method that fails."""

    name, code, device, cost = "fails", "1", "here", 1.0

    def run(self, texture, seed, progress=None):
        raise MemoryError("too little")


def report_of(name, verdicts, *methods):
    """A module of a report whose claims have these verdicts; without any, it cannot be made."""

    def prepared(options):
        if not verdicts:
            raise InputError(f"{name}: is not rendered")

        def sections(report):
            return [report.csv("claims", pd.DataFrame({"verdict": verdicts}))]

        texture = load_texture("bricks", (8, 8))
        tasks = [Task(Job(texture, method), ()) for method in methods]
        return {BUILT / documents.PARTS[name].folder: Document(name, tasks, sections, [])}

    return SimpleNamespace(
        add_options=lambda parser: parser.add_argument("--seeds"), prepared=prepared
    )


@pytest.fixture
def made(tmp_path, monkeypatch, capsys):
    """The exit code, and what was said, if a run of one report failed and another is left out."""
    monkeypatch.chdir(tmp_path)
    parts = {name: part._replace(options=()) for name, part in documents.PARTS.items()}
    monkeypatch.setattr(documents, "PARTS", parts)
    modules = {
        "eval.documents.lasram.report": report_of("lasram", [HELD, HELD, OPEN]),
        "eval.documents.heidrich.report": report_of("heidrich", []),
        "eval.documents.dzurenko.report": report_of("dzurenko", [NOT_HELD]),
        "eval.documents.hauptfleisch.report": report_of("hauptfleisch", [HELD], Fails()),
    }
    monkeypatch.setattr(documents, "import_module", modules.get)
    return main([]), capsys.readouterr().err


def rows_of(text):
    lines = [line.strip("|").split("|") for line in text.splitlines() if line.startswith("| [")]
    return {cells[0].strip(): [cell.strip() for cell in cells[2:5]] for cells in lines}


def test_verdicts_are_counted_and_each_report_is_linked(made):
    text = (BUILT / "documents" / "report.md").read_text(encoding="utf-8")
    assert rows_of(text) == {
        "[Lasram and Lefebvre 2012](../lasram_quick/report.html)": ["2", "0", "1"],
        "[Dzurenko 2017](../quick_golem_teapot/report.html)": ["0", "1", "0"],
    }


def test_what_cannot_be_made_is_said_in_a_sentence_and_the_others_are_made(made):
    assert "eval: heidrich is left out: heidrich: is not rendered" in made[1]
    text = (BUILT / "documents" / "report.md").read_text(encoding="utf-8")
    assert "Heidrich 2017 is left out: heidrich: is not rendered." in text
    assert (BUILT / "quick_golem_teapot" / "claims.csv").exists()


def test_a_failed_run_of_one_report_decides_the_exit_code(made):
    assert made[0] == 1
    assert "eval: failed: bricks, fails, seed 0: MemoryError: too little" in made[1]
    assert not (BUILT / "hauptfleisch_quick").exists()


def test_the_page_tells_how_long_it_took(made):
    text = (BUILT / "documents" / "report.md").read_text(encoding="utf-8")
    assert re.search(r"The command took \d+ seconds; ", text)
