"""Kernels on disk: found again, told apart, and never stale."""

from contextlib import suppress
from pathlib import Path

import brute_force
import numba
import numpy as np
import pytest
from code_copy import CodeCopy

import stylit_ref.machine.kernel_cache
from stylit_ref.machine.code_digest import imported_files
from stylit_ref.machine.compilation import compile_missing, compiling_together
from stylit_ref.machine.kernel import kernel, rehearsal


@pytest.fixture(autouse=True)
def cache_folder(tmp_path, monkeypatch):
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))
    return tmp_path


def make_kernel(constant):
    @kernel(constant, parallel=False)
    def store(array):
        array[0] = constant

    return store


def run(store):
    """What the kernel stored, and whether it came from disk."""
    array = np.zeros(1, np.int64)
    store(array)
    hits = sum(store.dispatcher.stats.cache_hits.values())
    assert hits + sum(store.dispatcher.stats.cache_misses.values()) == 1
    return array[0], hits == 1


def test_a_kernel_is_compiled_once():
    assert run(make_kernel(1)) == (1, False)
    assert run(make_kernel(1)) == (1, True)


def test_constants_tell_kernels_apart(cache_folder):
    run(make_kernel(1))
    before = {file: file.read_bytes() for file in cache_folder.rglob("*.nb?")}
    assert run(make_kernel(2)) == (2, False)
    assert run(make_kernel(1)) == (1, True)
    assert len(list(cache_folder.rglob("*.nb?"))) == 2 * len(before) == 4
    assert {file: file.read_bytes() for file in before} == before


def test_kernels_for_other_types_have_files_of_their_own(cache_folder):
    store = make_kernel(1)
    store(np.zeros(1, np.int64))
    before = {file: file.read_bytes() for file in cache_folder.rglob("*.nb?")}
    store(np.zeros(1, np.float64))
    assert len(list(cache_folder.rglob("*.nb?"))) == 2 * len(before) == 4
    assert {file: file.read_bytes() for file in before} == before


def test_nowhere_to_write(monkeypatch):
    def nowhere(function):
        raise RuntimeError("no locator available")

    monkeypatch.setattr("numba.core.caching.CompileResultCacheImpl", nowhere)
    monkeypatch.setattr(
        "stylit_ref.machine.kernel_cache.FunctionCache._impl_class", staticmethod(nowhere)
    )
    array = np.zeros(1, np.int64)
    make_kernel(5)(array)
    assert array[0] == 5


def test_a_kernel_lost_in_a_callback_is_used_and_not_kept(cache_folder, monkeypatch):
    def nothing(library):
        raise RuntimeError(f"no compiled object yet for {library}")

    with monkeypatch.context() as lost:
        lost.setattr("numba.core.codegen.CodeLibrary._get_compiled_object", nothing)
        assert run(make_kernel(6)) == (6, False)
    assert not list(cache_folder.rglob("*.nbc"))
    assert run(make_kernel(6)) == (6, False)


def make_caller(formula):
    @kernel(parallel=False)
    def store(array):
        array[0] = formula(array[0])

    return store


def test_a_file_that_changed_after_the_start_is_neither_found_nor_kept(monkeypatch):
    run(make_kernel(1))
    monkeypatch.setattr(stylit_ref.machine.kernel_cache, "STARTED", 0)
    assert run(make_kernel(1)) == (1, False)
    monkeypatch.undo()


def test_a_formula_from_elsewhere_counts(tmp_path):
    """A factory that is handed a formula does not import the formula's file."""
    store = make_caller(numba.njit(brute_force.mean))
    files = imported_files(*stylit_ref.machine.kernel_cache._files_of(store))
    assert Path(brute_force.__file__) in files


COUNT = """
import numpy as np
from {module} import {name} as loop
array = np.arange(48, dtype=np.uint8).reshape(4, 4, 3)
{call}
stats = loop.dispatcher.stats
hits, misses = (sum(getattr(stats, f"cache_{{kind}}").values()) for kind in ("hits", "misses"))
print(value, "from disk" if hits and not misses else "compiled")
"""
DOWNSAMPLE = COUNT.format(
    module="stylit_ref.passes.pyramid",
    name="_average_blocks",
    call="half = np.zeros((2, 2, 3), np.uint8); loop(array, half); value = half[0, 0, 0]",
)


@pytest.mark.slow
def test_an_edit_compiles_what_it_concerns_and_nothing_else(tmp_path):
    code = CodeCopy(tmp_path, ("stylit_ref",))
    assert code.python("-c", DOWNSAMPLE).strip() == "8 compiled"
    code.edit("stylit_ref/cli/example.py", "import shlex\n", "import shlex  # A comment.\n")
    code.edit(
        "stylit_ref/formulae/rounding.py",
        "    return (total",
        "    # A comment.\n    return (total",
    )
    code.edit("stylit_ref/stylization/stylit.py", "LEAST_PROGRESS = 1e-3", "LEAST_PROGRESS = 1")
    assert code.python("-c", DOWNSAMPLE).strip() == "8 from disk"
    code.edit("stylit_ref/formulae/rounding.py", "(total + 2) // 4", "(total + 6) // 4")
    assert code.python("-c", DOWNSAMPLE).strip() == "9 compiled"


def test_a_kernel_of_a_notebooks_cell_is_compiled_and_not_kept(tmp_path, cache_folder):
    """A cell has no file; the folder in its place, where debuggers look, may be there."""
    source = "@kernel(parallel=False)\ndef store(array):\n    array[0] = 7\n"
    names = {"kernel": kernel}
    file = tmp_path / "ipykernel_77" / "123.py"
    file.parent.mkdir()
    file.write_text(source)
    exec(compile(source, str(file), "exec"), names)
    file.unlink()
    assert run(names["store"]) == (7, False)
    assert not list(cache_folder.rglob("*.nb?"))


@pytest.mark.slow
def test_a_kernel_outside_the_library_is_never_stale(tmp_path):
    code = CodeCopy(tmp_path, ("stylit_ref",))
    code.add("formula.py", "from numba import njit\n\n@njit\ndef formula(x):\n    return x * 2\n")
    code.add(
        "outside.py",
        "from formula import formula\nfrom stylit_ref.machine.kernel import kernel\n\n"
        "@kernel(parallel=False)\ndef double(array):\n    array[0] = formula(1) + 10 * 0\n",
    )
    program = COUNT.format(
        module="outside", name="double",
        call="value = np.zeros(1, np.int64); loop(value); value = value[0]",
    )  # fmt: skip
    assert code.python("-c", program).strip() == "2 compiled"
    assert code.python("-c", program).strip() == "2 from disk"
    code.edit("outside.py", "10 * 0", "10 * 1")
    assert code.python("-c", program).strip() == "12 compiled"
    code.edit("formula.py", "* 2", "* 3")
    assert code.python("-c", program).strip() == "13 compiled"


def test_what_is_missing_is_told_and_compiled():
    kernels = [make_kernel(number) for number in (1, 2)]
    with rehearsal() as found:
        for each in (*kernels, kernels[0]):
            each(np.zeros(1, np.int64))
    kernels[0](np.zeros(1, np.int64))
    told = []
    assert compile_missing(found, lambda *step: told.append(step)) == 1
    assert told == [(1, 1)]
    assert compile_missing(found) == 0


def test_the_first_that_is_missing_brings_the_others():
    kernels = [make_kernel(number) for number in (1, 2, 3)]
    array, told = np.zeros(1, np.int64), []
    kernels[2](array)
    with rehearsal() as found:
        for each in kernels:
            each(array)
    with compiling_together(lambda: found, lambda *step: told.append(step)):
        kernels[2](array)
        assert not told
        kernels[1](array)
        assert (told[0], array[0]) == ((1, 2), 2)
        assert all(each.is_compiled for each in found)
        before = len(told)
        kernels[2](np.zeros(1, np.int32))  # is none of them, and brings nothing again
    assert len(told) == before


def test_a_rehearsal_ends_with_its_block():
    array = np.zeros(1, np.int64)
    store = make_kernel(3)
    with suppress(ValueError), rehearsal():
        store(array)
        raise ValueError
    assert array[0] == 0
    store(array)
    assert array[0] == 3
