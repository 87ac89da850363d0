"""The public names of the library: their origin, and what importing them must not do."""

import ast
import inspect
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import stylit_ref
from stylit_ref import Params
from stylit_ref.cli import make_parser
from stylit_ref.parameters import SPELLED


def test_every_public_name_is_there():
    for name in stylit_ref.__all__:
        assert getattr(stylit_ref, name) is not None


def test_type_checkers_are_told_the_same():
    tree = ast.parse(Path(stylit_ref.__file__).read_text(encoding="utf-8"))
    told = {
        (node.module.removeprefix("stylit_ref."), alias.name)
        for block in tree.body
        if isinstance(block, ast.If)
        for node in block.body
        for alias in node.names
    }
    assert told == {(home, name) for home, names in stylit_ref._HOMES.items() for name in names}
    assert sorted(name for _, name in told) == sorted(stylit_ref.__all__)


def test_type_checkers_trust_the_annotations():
    assert Path(stylit_ref.__file__).with_name("py.typed").exists()


def test_another_name_is_an_error():
    with pytest.raises(AttributeError, match="module 'stylit_ref' has no attribute 'stylise'"):
        stylit_ref.stylise  # noqa: B018


@pytest.mark.parametrize(
    ("imported", "absent"),
    [
        ("stylit_ref.errors, stylit_ref.files.disk.whole_file", ("numba", "numpy", "OpenImageIO")),
        ("stylit_ref; stylit_ref.stylize", ("OpenImageIO", "skimage", "scipy.optimize")),
        ("stylit_ref; stylit_ref.read_image", ("numba",)),
    ],
)
def test_what_is_not_needed_is_not_imported(imported, absent):
    program = f"import {imported}; import sys; print([m for m in {absent} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout == "[]\n", done.stderr


def test_importing_the_library_changes_no_setting_of_the_process():
    program = (
        "import os, signal, warnings\n"
        "def state():\n"
        "    handlers = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)]\n"
        "    return dict(os.environ), handlers, os.getcwd(), len(warnings.filters)\n"
        "import numba, numpy, scipy.ndimage, OpenImageIO\n"
        "before = state()\n"
        "import stylit_ref\n"
        "for name in stylit_ref.__all__: getattr(stylit_ref, name)\n"
        "import stylit_ref.passes\n"
        "assert state() == before, state()\n"
    )
    environment = {name: value for name, value in os.environ.items() if name != "GOMP_SPINCOUNT"}
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, env=environment
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(("name", "option"), SPELLED.items())
def test_a_parameter_and_its_option_name_each_other(name, option):
    description = re.search(rf"^{name} : .*\n((?: .*\n)+)", inspect.getdoc(Params), re.MULTILINE)
    assert f"``{option}`` on the command line." in " ".join(description.group(1).split())
    (action,) = (action for action in make_parser().commands["run"]._actions if action.dest == name)
    assert action.option_strings == [option]
    assert f"({name} in Python, default " in action.help
