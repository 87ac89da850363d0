"""Every notebook ends with exercises and their tests; ``make docs`` runs all of it."""

import ast
import re
import sys
import tomllib
from pathlib import Path

import jupytext
import pytest

ROOT = Path(__file__).parents[2]
NOTEBOOKS = sorted(
    ROOT.joinpath("notebooks").glob("*.py"), key=lambda file: int(file.name[:-3].split("_")[0])
)
EACH = pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)

INSTALLED = {"IPython", "PIL", "matplotlib", "numba", "numpy", "scipy", "skimage"}
"""What comes with the package and its extra ``notebooks``."""


def tags(cell):
    return cell.metadata.get("tags", ())


def test_they_are_found():
    assert [int(file.name.split("_")[0]) for file in NOTEBOOKS] == list(range(1, 11))


@EACH
def test_each_exercise_has_a_folded_solution_and_a_test(file):
    cells = jupytext.read(file).cells
    heading = next(n for n, cell in enumerate(cells) if "## Exercises" in cell.source)
    exercises = cells[heading:]
    solutions = [n for n, cell in enumerate(exercises) if "hide-input" in tags(cell)]
    assert len(solutions) >= 2
    for solution in solutions:
        task, test = exercises[solution - 1], exercises[solution + 1]
        assert task.cell_type == "markdown"
        assert "def " in exercises[solution].source
        assert test.cell_type == "code"
        assert "assert" in test.source


@EACH
def test_it_begins_with_a_picture_and_one_folded_cell_of_imports(file):
    title, imports, *others = jupytext.read(file).cells
    assert re.search(rf"^!\[[^\]]+\]\(pictures/{file.stem}\.webp\)$", title.source, re.MULTILINE)
    assert "hide-input" in tags(imports)
    assert "import" in imports.source
    code = [cell.source for cell in others if cell.cell_type == "code"]
    assert not re.search(r"^(import|from) ", "\n".join(code), re.MULTILINE)


@EACH
def test_it_needs_nothing_that_the_wheel_lacks(file):
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    packages = project["tool"]["hatch"]["build"]["targets"]["wheel"]["packages"]
    nodes = list(ast.walk(ast.parse(file.read_text(encoding="utf-8"))))
    names = [alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names]
    names += [node.module for node in nodes if isinstance(node, ast.ImportFrom)]
    imported = {name.partition(".")[0] for name in names}
    assert imported - sys.stdlib_module_names <= {*packages, *INSTALLED}


def test_links_to_binder_and_colab_lead_to_each():
    page = (ROOT / "notebooks" / "README.md").read_text(encoding="utf-8")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    repository = project["urls"]["Source"].removeprefix("https://github.com/")
    for file in NOTEBOOKS:
        notebook = f"{file.stem}.ipynb"
        assert f"https://mybinder.org/v2/gh/{repository}/notebooks?labpath={notebook})" in page
        assert (
            f"https://colab.research.google.com/github/{repository}/blob/notebooks/{notebook})"
            in page
        )
