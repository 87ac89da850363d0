"""Every notebook ends with exercises and their tests; ``make docs`` runs all of it."""

from pathlib import Path

import jupytext
import pytest

NOTEBOOKS = sorted(Path(__file__).parents[2].joinpath("notebooks").glob("*.py"))


def test_they_are_found():
    assert [file.name[0] for file in NOTEBOOKS] == list("123456789")


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
        assert "assert" in test.source
