"""Tests that need a GPU: full sizes, the thesis' blocks, and real shared memory."""

import shutil
import subprocess
import sys
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest
from device_level import on_device, to_host
from small_level import make_level
from small_scene import small_scene

from gpu_cuda.host.device import SIMULATED
from gpu_cuda.variants import shared_memory
from stylit_ref import Params, passes, stylize
from stylit_ref.randomness.random_stream import RANDOM_SEARCH, random_stream

pytestmark = pytest.mark.skipif(SIMULATED, reason="needs a GPU: make test-gpu")

STREAM = random_stream(7, RANDOM_SEARCH, 1, 2, 3)


def full_scene(size):
    return small_scene(source_size=size, target_size=size, guide_channels=(3,) * 5)


@lru_cache
def on_cpu(size, method):
    return stylize(*full_scene(size), Params(method))


@pytest.mark.parametrize(
    ("method", "backend"), [("ref", "cuda"), ("ref", "cuda:shared_memory"), ("guide_map", "cuda")]
)
@pytest.mark.parametrize("size", [(228, 300), (912, 1200)])
def test_whole_runs_give_the_bytes_of_the_cpu(size, method, backend):
    scene = full_scene(size)
    device = stylize(*scene, Params(method), backend=backend)
    host = on_cpu(size, method)
    for name in ("image", "nnf", "omega", "error"):
        np.testing.assert_array_equal(getattr(device, name), getattr(host, name), err_msg=name)
    assert device.history == host.history


@pytest.mark.parametrize("shared", [False, True])
@pytest.mark.parametrize(
    ("name", "parameters"), [("propagation", (2,)), ("random_search", (STREAM, 100))]
)
def test_blocks_of_the_thesis(name, parameters, shared):
    level = make_level(source_size=(90, 70), target_size=(75, 100), guide_channels=(3,) * 5)
    device = on_device(level)
    getattr(passes, name)(*level.proposal, *parameters)
    getattr(shared_memory.in_blocks((32, 32), shared), name)(*device.proposal, *parameters)
    np.testing.assert_array_equal(to_host(device.proposed_nnf), level.proposed_nnf)
    np.testing.assert_array_equal(to_host(device.proposed_delta), level.proposed_delta)


def test_no_kernel_reads_or_writes_where_it_must_not():
    if not shutil.which("compute-sanitizer"):
        pytest.skip("compute-sanitizer is not installed")
    tests = Path(__file__).with_name("test_passes.py")
    small = [sys.executable, "-m", "pytest", tests, "-k", "not source_size"]
    command = ["compute-sanitizer", "--report-api-errors", "no", "--error-exitcode", "3", *small]
    found = subprocess.run(command, check=False, capture_output=True, text=True)
    if "Device not supported" in found.stdout:
        pytest.skip("compute-sanitizer does not support this device")
    assert found.returncode == 0, found.stdout[-2000:]
