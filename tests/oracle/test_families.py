"""To add a system takes three rows in tables, and files of its own."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import oracle

ROWS = {
    "families.py": (
        "FAMILIES = STYLIZATION, TEXTURE, REALTIME, VIEWS, INTERPOLATION",
        "FAMILIES = STYLIZATION, TEXTURE, REALTIME, VIEWS, INTERPOLATION, "
        'Family("made_up", ("made_up/v1",), {"double": "1"})',
    ),
    "stages/__init__.py": (
        "SYSTEMS = {\n",
        "import doubling\nfrom oracle.stages import made_up\n\n"
        'SYSTEMS = {\n    "made_up": System(doubling, made_up.STAGES),\n',
    ),
    "make/__init__.py": (
        "MAKERS = {",
        'from oracle.make.made_up import made_up_cases\n\nMAKERS = {"made_up": made_up_cases, ',
    ),
}
"""The rows of a new family in existing files."""

OWN = {
    "oracle/stages/made_up.py": """
from oracle.stages.stage import Stage

def _double(passes, parameters, arrays):
    return {"image": passes.double(arrays["image"])}

STAGES = {"double": Stage(_double, ("double",))}
""",
    "oracle/make/made_up.py": """
import numpy as np
from oracle.cases import Case

def made_up_cases(version):
    image = np.arange(6, dtype=np.int32)
    yield Case(version, "double", "plain", "1", {}, {}, {"image": image}, {"image": 2 * image})
""",
    "oracle/made_up/SPEC.md": "Version 1. \n\n## 1. Twice\n",
    "oracle/made_up/v1/case.schema.json": "{}",
    "doubling.py": "def double(image): return 2 * image\n",  # the passes of the system
    "tripling.py": "def double(image): return 3 * image\n",  # a port of them, with a mistake
    "port.py": "def run_case(stage, parameters, arrays): return {'image': arrays['image'] * 2}\n",
}


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """A copy of the oracle to which a family was added."""
    folder = tmp_path_factory.mktemp("copy")
    shutil.copytree(Path(oracle.__file__).parent, folder / "oracle")
    for name, (known, row) in ROWS.items():
        file = folder / "oracle" / name
        text = file.read_text(encoding="utf-8")
        assert known in text
        file.write_text(text.replace(known, row), encoding="utf-8")
    for name, text in OWN.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    assert run(folder, "make made_up/v1").returncode == 0
    return folder


def run(folder, arguments):
    """``python -m oracle`` of a copy."""
    folders = os.pathsep.join([str(folder), *filter(None, sys.path)])
    return subprocess.run(
        [sys.executable, "-m", "oracle", *arguments.split()],
        cwd=folder, env=os.environ | {"PYTHONPATH": folders},
        check=False, capture_output=True, text=True,
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        ("cases made_up/v1", 0, "/oracle/made_up/v1\n"),
        ("check --cases made_up/v1", 0, "1 passed\n"),
        ("check --cases made_up/v1 --module doubling", 0, "1 passed\n"),
        ("check --cases made_up/v1 --module port", 0, "1 passed\n"),
        ("check --cases made_up/v1 --module tripling", 1, "image[1] is 3; it must be 2"),
        ("check --cases made_up/v1 --module tripling", 1, "oracle/made_up/SPEC.md."),
        (
            "check --cases made_up/v1 --stages philox",
            2,
            "which is not a stage of these cases; write --cases v1",
        ),
        ("check --module doubling", 2, "neither run_case nor a pass of stylit_ref.passes"),
        ("check --stages knee", 0, "1 passed\n"),
        (
            "check --cases v1 --stages double",
            2,
            "'double', which is not a stage of these cases; write --cases made_up/v1",
        ),
        ("make made_up/v1", 2, "made_up/v1 is published and never changes"),
    ],
)
def test_a_family_is_checked_beside_the_first(arguments, code, said, copy):
    done = run(copy, arguments)
    assert done.returncode == code
    assert said in done.stdout + done.stderr


@pytest.mark.slow
def test_a_family_changes_nothing_of_the_first(copy):
    ours = Path(oracle.__file__).parent / "v1"
    files = sorted(file.relative_to(ours) for file in ours.rglob("*") if file.is_file())
    theirs = copy / "oracle" / "v1"
    assert files == sorted(f.relative_to(theirs) for f in theirs.rglob("*") if f.is_file())
    assert all((ours / file).read_bytes() == (theirs / file).read_bytes() for file in files)
