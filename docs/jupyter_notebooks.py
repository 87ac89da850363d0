"""Make the notebooks for Jupyter: ``python docs/jupyter_notebooks.py build/jupyter``.

The folder is whole in itself: it needs the installed package, and nothing else of the repository.
Published as the branch ``notebooks``, it is what the links to Binder and Colab open.
"""

import re
import sys
import tomllib
from base64 import b64encode
from pathlib import Path

import jupytext
import nbformat

ROOT = Path(__file__).parents[1]
NOTEBOOKS = ROOT / "notebooks"
SOURCE = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["urls"]["Source"]

FOLDED = "hide-input"
_PICTURE = re.compile(r"\]\((pictures/[^)]+)\)")

_INSTALL = f"""\
import importlib.util

if importlib.util.find_spec("stylit_ref") is None:  # as in Colab
    %pip install --quiet "stylit-ref @ git+{SOURCE}"

"""


def for_jupyter(file):
    """Convert a notebook.

    Parameters
    ----------
    file : Path
        In jupytext's percent format.

    Returns
    -------
    nbformat.NotebookNode
        Solutions and imports are folded, and pictures are inside.
    """
    notebook = jupytext.read(file)
    folded = [cell for cell in notebook.cells if FOLDED in cell.metadata.get("tags", ())]
    for cell in folded:
        cell.metadata["jupyter"] = {"source_hidden": True}
    folded[0].source = _INSTALL + folded[0].source
    for number, cell in enumerate(notebook.cells):
        cell.id = f"cell-{number}"  # a random one would differ from call to call
        if cell.cell_type == "markdown":
            _attach_pictures(cell, file.parent)
    return notebook


def _attach_pictures(cell, folder):
    for name in _PICTURE.findall(cell.source):
        held = b64encode((folder / name).read_bytes()).decode()
        cell.setdefault("attachments", {})[Path(name).name] = {"image/webp": held}
    cell.source = _PICTURE.sub(lambda name: f"](attachment:{Path(name[1]).name})", cell.source)


def main(folder):
    """Write all notebooks into a folder, and what Binder installs for them."""
    folder.mkdir(parents=True, exist_ok=True)
    for file in sorted(NOTEBOOKS.glob("*.py")):
        nbformat.write(for_jupyter(file), folder / f"{file.stem}.ipynb")
    (folder / "requirements.txt").write_text(f"stylit-ref[notebooks] @ git+{SOURCE}\n")
    (folder / "runtime.txt").write_text("python-3.12\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
