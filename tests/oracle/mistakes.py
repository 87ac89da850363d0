"""Plant mistakes in a naive port, and see at which stage the cases find them."""

import re
import shutil

from oracle.check import check
from oracle.compare import FAILED
from oracle.ports import ModulePort


def first_failure(port, version):
    """The first case that fails, if any does."""
    outcomes = check(port, version)
    return next((outcome for outcome in outcomes if outcome.status == FAILED), None)


def assert_found(naive, name, mistake, version, tmp_path, monkeypatch):
    """A copy of a port with a mistake fails at the stage that the mistake belongs to.

    Parameters
    ----------
    naive : Path
        The folder of the port; its sections are ``spec_*.py``.
    name : str
        What the copy is called; no other module may have the name.
    mistake : tuple of 3 str
        What stands in a section, what to write there, and the stage.
    version : str
        That of the cases.
    """
    right, wrong, stage = mistake
    shutil.copytree(naive, tmp_path / name, ignore=shutil.ignore_patterns("__pycache__"))
    sections = sorted((tmp_path / name).glob("spec_*.py"))
    file = next(file for file in sections if right in file.read_text(encoding="utf-8"))
    file.write_text(file.read_text(encoding="utf-8").replace(right, wrong, 1), encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    found = first_failure(ModulePort(name), version)
    assert found.stage == stage
    assert re.search(r"it must be .*(differ\)|\))$", found.difference.message)
