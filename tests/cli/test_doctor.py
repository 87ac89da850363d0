"""``stylit-ref doctor``."""

import os

import numba
import numpy as np
import pytest

from stylit_ref import Params
from stylit_ref.cli import doctor, main
from stylit_ref.cli.methods import OFFERS
from stylit_ref.machine.kernel import kernel, rehearsal
from stylit_ref.stylization.warm_up import kernels_of_run


@pytest.fixture
def told(capsys):
    """What the doctor says, by the first word of each line."""

    def ask():
        assert main(["doctor"]) == 0
        lines = capsys.readouterr().out.splitlines()
        return {line[:13].strip(): line[14:] for line in lines}

    return ask


def test_without_kernels_of_a_gpu_it_says_so(told, hidden):
    hidden("gpu_cuda")
    assert told()["GPU"].startswith("none: the kernels cannot be loaded: ")


def test_threads_files_and_versions(told):
    said = told()
    threads = numba.config.NUMBA_NUM_THREADS
    assert said["threads"].startswith(f"{threads} of {os.cpu_count()};")
    assert {"png", "openexr", "gif"} <= set(said["reads"].split(", "))
    assert {"png", "openexr"} <= set(said["writes"].split(", "))
    assert "gif" not in said["writes"]
    assert said["stylit-ref"].startswith("0.")


@pytest.fixture
def kernels(monkeypatch):
    """The kernels that methods and textures are said to need, in the place of their own."""

    def need(found):
        for name, offer in OFFERS.items():
            monkeypatch.setitem(OFFERS, name, offer._replace(kernels=lambda *_: found))
        monkeypatch.setattr(doctor, "kernels_of_all_textures", lambda: found)

    return need


def test_it_counts_what_is_compiled(told, kernels, tmp_path, monkeypatch):
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))

    @kernel(parallel=False)
    def first(array):
        array[0] = 1

    @kernel(parallel=False)
    def second(array):
        array[0] = 2

    with rehearsal() as found:
        first(np.zeros(1))
        second(np.zeros(1))
    kernels(list(found))
    said = told()
    assert said["compiled"].startswith("0 of 2 for ref, 0 of 2 for guide_map, 0 of 2 for stylit, ")
    assert "0 of 2 for textures; " in said["compiled"]
    assert f" MiB in {tmp_path}" in said["kernels"]
    first(np.zeros(1))
    assert told()["compiled"].startswith("1 of 2 for ref, ")


def test_without_a_folder_for_kernels_it_says_so(told, kernels):
    found = kernels_of_run(Params(), 3, (3,))
    kernels([each._replace(dispatcher=numba.njit(each.dispatcher.py_func)) for each in found])
    assert told()["kernels"] == (
        "no folder can be written, so every run compiles; set NUMBA_CACHE_DIR to one that can"
    )


def test_a_folder_that_cannot_be_written_is_named(told, tmp_path, monkeypatch):
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path / "elsewhere"))
    assert told()["kernels"].endswith(
        f"; NUMBA_CACHE_DIR names {tmp_path / 'elsewhere'}, which cannot be written"
    )
