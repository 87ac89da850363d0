"""What only a GPU can show: whole sizes, the thesis' blocks, and memory that is really shared."""

import shutil
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
from device_level import on_device, to_host
from small_level import make_level
from small_scene import small_scene

from gpu_cuda.device import SIMULATED
from gpu_cuda.metric import launch_search
from stylit_ref import Params, passes, stylize
from stylit_ref.formulae.random_stream import RANDOM_SEARCH, random_stream

pytestmark = pytest.mark.skipif(SIMULATED, reason="needs a GPU: make test-gpu")

STREAM = random_stream(7, RANDOM_SEARCH, 1, 2, 3)


@pytest.mark.parametrize("method", ["ref", "shared_memory", "guide_map"])
@pytest.mark.parametrize("size", [(228, 300), (912, 1200)])
def test_whole_runs_give_the_bytes_of_the_cpu(size, method):
    scene = small_scene(source_size=size, target_size=size, guide_channels=(3,) * 5)
    device = stylize(*scene, Params(method), backend="cuda")
    host = stylize(*scene, Params("ref" if method == "shared_memory" else method))
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
    kernel = import_module(f"gpu_cuda.{name}").make_kernel
    for either, run in (
        (level, getattr(passes, name)),
        (device, lambda *search: launch_search(kernel, *search, block=(32, 32), shared=shared)),
    ):
        run(
            either.textures, either.omega_sums, either.occurrence_weight, either.patch_width,
            either.nnf, either.delta, either.proposed_nnf, either.proposed_delta, *parameters,
        )  # fmt: skip
    np.testing.assert_array_equal(to_host(device.proposed_nnf), level.proposed_nnf)


def test_no_kernel_reads_or_writes_where_it_must_not():
    if not shutil.which("compute-sanitizer"):
        pytest.skip("compute-sanitizer is not installed")
    tests = Path(__file__).with_name("test_passes.py")
    command = ["compute-sanitizer", "--error-exitcode", "3", sys.executable, "-m", "pytest", tests]
    assert subprocess.run(command, check=False).returncode == 0
