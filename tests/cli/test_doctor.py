"""``stylit-ref doctor``."""

import os

import numba
import pytest

from stylit_ref import Params
from stylit_ref.cli import main
from stylit_ref.cli.methods import OFFERS
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


def test_kernels_in_an_empty_folder_and_after_a_kernel_is_compiled(told, tmp_path, monkeypatch):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    kernels = kernels_of_run(Params(), 3, (3,) * 5)
    compiled = sum(each.is_compiled for each in kernels)
    assert f"ref {compiled} of {len(kernels)}, " in told()["compiled"]
    kernels[0].dispatcher.compile(kernels[0].types)
    assert f"ref {sum(each.is_compiled for each in kernels)} of" in told()["compiled"]


def test_without_a_folder_for_kernels_it_says_so(told, monkeypatch):
    def kernels(*_):
        return [each._replace(dispatcher=numba.njit(each.dispatcher.py_func)) for each in found]

    found = kernels_of_run(Params(), 3, (3,))
    for name, offer in OFFERS.items():
        monkeypatch.setitem(OFFERS, name, offer._replace(kernels=kernels))
    assert told()["kernels"] == (
        "no folder can be written, so every run compiles; set NUMBA_CACHE_DIR"
    )
