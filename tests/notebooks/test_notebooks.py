"""Every notebook runs from any folder, shows pictures, and tests its exercises."""

from pathlib import Path

import jupytext
import pytest
from nbclient import NotebookClient

NOTEBOOKS = sorted(Path(__file__).parents[2].joinpath("notebooks").glob("*.py"))


def test_they_are_found():
    assert NOTEBOOKS


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_it_runs_and_shows_pictures(file, tmp_path, monkeypatch):
    monkeypatch.setenv("MPLBACKEND", "module://matplotlib_inline.backend_inline")
    notebook = jupytext.read(file)
    client = NotebookClient(
        notebook,
        timeout=300,
        kernel_name="python3",
        resources={"metadata": {"path": str(tmp_path)}},
    )
    client.execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", ())]
    assert any("image/png" in output.get("data", ()) for output in outputs)
    assert [output.text for output in outputs if output.get("name") == "stderr"] == []


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_each_exercise_has_a_folded_solution_and_a_test(file):
    cells = jupytext.read(file).cells
    heading = next(n for n, cell in enumerate(cells) if "## Exercises" in cell.source)
    exercises = cells[heading:]
    tags = [cell.metadata.get("tags", ()) for cell in exercises]
    solutions = [n for n, tag in enumerate(tags) if "hide-input" in tag]
    assert len(solutions) >= 2
    for solution in solutions:
        task, test = exercises[solution - 1], exercises[solution + 1]
        assert task.cell_type == "markdown"
        assert "def " in exercises[solution].source
        assert test.cell_type == "code"
        assert "assert " in test.source
