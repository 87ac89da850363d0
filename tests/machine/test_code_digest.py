"""The digest of code depends on all imported files and on nothing else."""

import subprocess
import sys
from pathlib import Path

import pytest

import stylit_ref
from stylit_ref.machine.code_digest import code_digest, imported_files

LIBRARY = Path(stylit_ref.__file__).parent


def names(*roots):
    """The files that count, relative to the library."""
    files = imported_files(*roots)
    return {str(file.relative_to(LIBRARY)) for file in files if LIBRARY in file.parents}


def test_a_pass_depends_on_its_formulae_and_on_no_command_or_algorithm():
    found = names(LIBRARY / "passes" / "propagation.py")
    assert {"formulae/candidates.py", "metric/fast_metric.py", "machine/vector_ssd.py"} <= found
    assert not [name for name in found if name.startswith(("cli", "stylization", "files"))]
    assert "passes/commit.py" not in found


def test_an_algorithm_depends_on_the_passes():
    found = names(LIBRARY / "stylization" / "stylize.py")
    assert {"passes/propagation.py", "formulae/patch_similarity.py"} <= found
    assert not [name for name in found if name.startswith("cli")]


@pytest.fixture
def package(tmp_path):
    """A package with a formula, a pass that calls it, and what neither needs."""
    folder = tmp_path / "textures"
    (folder / "passes").mkdir(parents=True)
    (folder / "__init__.py").write_text("from textures.command import main\n")
    (folder / "command.py").write_text("import argparse\n\ndef main(): ...\n")
    (folder / "formula.py").write_text("def f(x):\n    return x * 2\n")
    (folder / "other.py").write_text("def g(x):\n    return x * 5\n")
    (folder / "passes" / "__init__.py").write_text(
        "from .double import double\nfrom ..other import g\n"
    )
    (folder / "passes" / "double.py").write_text(
        "from ..formula import f\nimport numpy as np\n\ndef double(x):\n    return f(x)\n"
    )
    (tmp_path / "user.py").write_text("from textures.passes import double\n")
    return tmp_path


def digest(folder):
    """Of ``user.py``, in a process of its own that finds the package beside it."""
    program = (
        "from pathlib import Path; from stylit_ref.machine.code_digest import code_digest; "
        "print(code_digest(Path('user.py')))"
    )
    paths = {"PYTHONPATH": f"{folder}:{LIBRARY.parent}", "PATH": ""}
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=folder, env=paths, text=True, capture_output=True
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize(
    ("file", "text", "counts"),
    [
        ("formula.py", "def f(x):\n    return x * 3\n", True),
        (
            "formula.py",
            '"""A formula."""\n\n\ndef f(x):  # twice\n    """x."""\n    return 2\n',
            True,
        ),
        (
            "formula.py",
            '"""A formula."""\n\n\ndef f(x):  # twice\n    """x."""\n    return x * 2\n',
            False,
        ),
        (
            "passes/double.py",
            "from ..other import g as f\n\ndef double(x):\n    return f(x)\n",
            True,
        ),
        ("other.py", "def g(x):\n    return x * 7\n", False),
        ("command.py", "def main(): raise SystemExit\n", False),
        ("__init__.py", "", False),
        ("passes/__init__.py", "from .double import double\n", False),
    ],
)
def test_what_counts(package, file, text, counts):
    before = digest(package)
    (package / "textures" / file).write_text(text)
    assert (digest(package) != before) == counts


IMPORTS = {
    "from mylib.formula import f": "f(x)",
    "from mylib import formula": "formula.f(x)",
    "import mylib.formula": "mylib.formula.f(x)",
    "import mylib.formula as g": "g.f(x)",
    "import mylib as m, mylib.other": "m.formula.f(x)",
}


@pytest.mark.parametrize("package", [True, False], ids=["package", "namespace"])
@pytest.mark.parametrize("statement", IMPORTS)
def test_no_form_of_an_import_is_missed(tmp_path, statement, package):
    folder = tmp_path / "mylib"
    folder.mkdir()
    if package:
        (folder / "__init__.py").write_text("")
    (folder / "other.py").write_text("")
    (folder / "formula.py").write_text("def f(x):\n    return x * 2\n")
    (tmp_path / "user.py").write_text(
        f"{statement}\n\ndef g(x):\n    return {IMPORTS[statement]}\n"
    )
    before = digest(tmp_path)
    (folder / "formula.py").write_text("def f(x):\n    return x * 3\n")
    assert digest(tmp_path) != before


def test_a_sibling_in_a_package_without_init(tmp_path):
    (tmp_path / "mylib").mkdir()
    (tmp_path / "mylib" / "formula.py").write_text("def f(x):\n    return x * 2\n")
    (tmp_path / "mylib" / "user.py").write_text("from .formula import f\n")
    program = (
        "import mylib.user; from stylit_ref.machine.code_digest import imported_files; "
        "print(*sorted(file.name for file in imported_files(mylib.user)))"
    )
    paths = {"PYTHONPATH": f"{tmp_path}:{LIBRARY.parent}", "PATH": ""}
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=tmp_path, env=paths, text=True, capture_output=True
    )
    assert done.stdout == "formula.py user.py\n", done.stderr


def test_the_folder_does_not_count(package, tmp_path_factory):
    elsewhere = tmp_path_factory.mktemp("elsewhere") / "copy"
    before = digest(package)
    package.rename(elsewhere)
    assert digest(elsewhere) == before


def test_a_package_that_does_not_count():
    stylize = LIBRARY / "stylization" / "stylize.py"
    assert code_digest(stylize) != code_digest(stylize, without=("gpu_cuda",))
    assert code_digest(stylize, without=("eval",)) == code_digest(stylize)


def test_modules_name_their_files():
    assert code_digest(sys.modules["stylit_ref.machine.code_digest"]) == code_digest(
        LIBRARY / "machine" / "code_digest.py"
    )
