"""``make notebooks``: whole .ipynb files, which the package alone can run."""

import json
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest

ROOT = Path(__file__).parents[2]


def convert(folder):
    subprocess.run([sys.executable, "docs/jupyter_notebooks.py", folder], cwd=ROOT, check=True)
    return sorted(folder.glob("*.ipynb"))


@pytest.fixture(scope="module")
def notebooks(tmp_path_factory):
    return convert(tmp_path_factory.mktemp("jupyter"))


def test_each_is_a_valid_notebook_for_python(notebooks):
    assert {file.stem for file in notebooks} == {file.stem for file in ROOT.glob("notebooks/*.py")}
    for file in notebooks:
        notebook = nbformat.read(file, as_version=nbformat.NO_CONVERT)
        nbformat.validate(notebook)
        assert notebook.metadata.kernelspec.name == "python3"


def test_each_holds_its_pictures(notebooks):
    for file in notebooks:
        title = nbformat.read(file, as_version=4).cells[0]
        assert list(title.attachments) == [f"{file.stem}.webp"]
        assert f"](attachment:{file.stem}.webp)" in title.source


def test_solutions_and_imports_are_folded(notebooks):
    for file in notebooks:
        cells = nbformat.read(file, as_version=4).cells
        folded = [cell for cell in cells if cell.metadata.get("jupyter", {}).get("source_hidden")]
        assert folded[0] == cells[1]
        assert len(folded) >= 3


def test_the_same_notebooks_are_the_same_bytes(notebooks, tmp_path):
    for file, again in zip(notebooks, convert(tmp_path), strict=True):
        assert json.loads(file.read_bytes()) == json.loads(again.read_bytes())
