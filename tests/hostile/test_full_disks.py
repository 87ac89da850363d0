"""Disks that become full while a file is written: no broken file is left."""

import os
import resource
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
from hostile.command_line import accepted, check, refused
from hostile.programs import CHECKOUT, done, started

from data_gen.renderer import MissingRendererError, start
from stylit_ref import write_image


@contextmanager
def largest_file(size):
    """Let writing a file fail after this number of bytes, as on a disk that becomes full."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


@pytest.mark.parametrize("suffix", ["png", "tif", "exr", "bmp", "tga"])
def test_a_file_that_cannot_be_finished_is_not_there(folder, suffix):
    """Some libraries write a broken file and report no error.

    JPEG and WebP are left out: their libraries end the process, or try for ever.
    """
    rng = np.random.default_rng(0)
    write_image("style.png", rng.integers(0, 256, (50, 60, 3), dtype=np.uint8))
    np.save("nnf.npy", rng.integers(2, 48, (90, 80, 2), np.int32))
    replay = ["replay", "--style", "style.png", "--nnf", "nnf.npy", "--output", f"out.{suffix}"]
    accepted(replay)
    Path(f"out.{suffix}").unlink()
    with largest_file(5000):
        refused(replay, f"out.{suffix}: cannot be written: …")


def test_an_example_that_cannot_be_finished_is_not_there(folder):
    with largest_file(5000):
        refused(["example", "new/scenes"], "new/scenes: cannot be written: File too large")


@pytest.mark.slow
def test_a_run_of_eval_that_cannot_be_stored_ends_it(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    thesis = ["eval", "dzurenko", "--step", "7", "--targets", "hand", "--output", "report"]
    with started(*thesis, folder=tmp_path, largest_file=1000) as process:
        check(*done(process), "build/runs/…: cannot be written: File too large")
    assert not Path("report").exists()
    assert not list(Path("build/runs").iterdir())


@pytest.mark.slow
def test_a_piece_of_data_that_cannot_be_finished_is_not_there(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    try:
        start()
    except MissingRendererError as error:
        pytest.skip(str(error))
    data = ["data_gen", "--size", "60x46", "--samples", "4", "--scenes", "teapot"]
    with started(*data, "--folder", "set", folder=tmp_path, largest_file=1000) as process:
        check(*done(process), "set/partial/passes.exr: cannot be written: …")
    assert {path.name for path in Path("set").iterdir()} <= {"manifest.json"}


_COMPILES = """
import resource, sys
import numpy as np
from stylit_ref import replay
if len(sys.argv) > 1:
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
nnf = np.full((3, 3, 2), 1, np.int32)
assert replay(nnf, np.full((3, 3), 7, np.uint8), patch_width=3).tolist() == [[7] * 3] * 3
"""


@pytest.mark.slow
def test_kernels_that_cannot_be_kept_or_read_are_compiled(tmp_path):
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path), "PYTHONPATH": str(CHECKOUT)}

    def compile_kernels(*limit):
        call = [sys.executable, "-c", _COMPILES, *limit]
        run = subprocess.run(call, env=environment, capture_output=True, text=True)
        assert run.returncode == 0, run.stderr
        return {path: path.stat().st_size for path in tmp_path.rglob("*.nb?")}

    assert not any(compile_kernels("no room").values())
    kept = compile_kernels()
    assert kept
    for path in kept:
        path.write_bytes(b"garbage")
    assert compile_kernels().keys() >= kept.keys()
    assert compile_kernels() == kept
