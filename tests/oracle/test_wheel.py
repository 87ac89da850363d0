"""A porter needs NumPy alone: the wheel, without what it depends on, checks a program."""

import shutil
import subprocess
import sys
from pathlib import Path

import naive_port
import numpy as np
import pytest

from oracle.families import NEWEST

ROOT = Path(__file__).parents[2]
NAIVE = Path(naive_port.__file__).parent


def run(*words, **options):
    """A program that must succeed."""
    return subprocess.run(words, check=True, capture_output=True, text=True, **options)


@pytest.fixture(scope="module")
def python(tmp_path_factory):
    """Python of an environment with NumPy and the wheel, and nothing else."""
    folder = tmp_path_factory.mktemp("porter")
    run(sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", folder, cwd=ROOT)
    (wheel,) = folder.glob("*.whl")
    run(sys.executable, "-m", "venv", "--without-pip", folder / "environment")
    python = folder / "environment" / "bin" / "python"
    pip = sys.executable, "-m", "pip", "--python", python, "--quiet", "install"
    run(*pip, "--no-deps", "--no-index", wheel)
    where = "import sysconfig; print(sysconfig.get_path('platlib'))"
    packages = Path(run(python, "-c", where).stdout.strip())
    numpy = Path(np.__file__).parent
    for part in (numpy, numpy.with_name("numpy.libs")):
        if part.exists():
            shutil.copytree(part, packages / part.name)
    return python


@pytest.mark.slow
def test_the_naive_port_is_checked_with_numpy_alone(python, tmp_path):
    command = f"{python} {NAIVE} {{input}} {{output}}"
    check = python, "-m", "oracle", "check", "--jobs", "2"
    done = run(*check, "--port", command, cwd=tmp_path)
    assert done.stdout == "233 passed\n"
    shutil.copytree(NAIVE, tmp_path / "naive_port")
    done = run(*check, "--module", "naive_port", "--json", "report.json", cwd=tmp_path)
    assert done.stdout == "233 passed\n"
    assert (tmp_path / "report.json").exists()


@pytest.mark.slow
def test_the_cases_are_found_with_numpy_alone(python, tmp_path):
    (folder,) = run(python, "-m", "oracle", "cases", cwd=tmp_path).stdout.splitlines()
    assert Path(folder).name == NEWEST
    assert (Path(folder) / "SHA256SUMS").is_file()
    assert Path(folder).is_relative_to(python.parents[1])


@pytest.mark.slow
def test_passes_need_the_library_and_it_is_said(python, tmp_path):
    done = subprocess.run(
        [python, "-m", "oracle", "check", "--stages", "knee"],
        cwd=tmp_path, check=False, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 2
    assert done.stderr.startswith("oracle: to check passes takes the package ")
    assert done.stderr.count("\n") == 1
