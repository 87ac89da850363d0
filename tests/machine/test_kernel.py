"""Kernels on disk: found again, told apart, and never stale."""

import numba
import numpy as np
import pytest

import stylit_ref.machine.kernel
from stylit_ref.machine.kernel import kernel


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
    hits = sum(store.stats.cache_hits.values())
    assert hits + sum(store.stats.cache_misses.values()) == 1
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


def test_nowhere_to_write(monkeypatch):
    def nowhere(function):
        raise RuntimeError("no locator available")

    monkeypatch.setattr("numba.core.caching.CompileResultCacheImpl", nowhere)
    monkeypatch.setattr(
        "stylit_ref.machine.kernel.FunctionCache._impl_class", staticmethod(nowhere)
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


def test_another_source_makes_a_kernel_stale(monkeypatch):
    run(make_kernel(1))
    monkeypatch.setattr(stylit_ref.machine.kernel, "LIBRARY_DIGEST", "of a library with one edit")
    assert run(make_kernel(1)) == (1, False)


def test_every_file_of_the_library_counts(tmp_path, monkeypatch):
    package = tmp_path / "package"
    (package / "formulae").mkdir(parents=True)
    formula = package / "formulae" / "sum.py"
    formula.write_text("a + b")
    monkeypatch.setattr(
        stylit_ref.machine.kernel, "__file__", str(package / "machine" / "kernel.py")
    )
    before = stylit_ref.machine.kernel._library_digest()
    formula.write_text("a - b")
    assert stylit_ref.machine.kernel._library_digest() != before
