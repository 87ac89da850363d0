"""The record of a GPU, made in the simulator."""

import argparse
import json

import numpy as np
import pytest
from small_scene import small_scene

import gpu_cuda
from eval.reports import gpu
from gpu_cuda.host.device import SIMULATED
from gpu_cuda.variants import live
from stylit_ref import Params
from stylit_ref.stylization.backends import Backend


def options(*arguments):
    """What the command line would make of arguments."""
    parser = argparse.ArgumentParser()
    gpu.add_options(parser)
    return parser.parse_args(arguments)


QUICK = {"levels": 1, "votes": 1, "patchmatch_iterations": 1}


@pytest.mark.skipif(not SIMULATED, reason="make test-gpu makes a whole one")
def test_a_record_compares_and_times(tmp_path, monkeypatch):
    style, sources, targets = small_scene(source_size=(6, 7), target_size=(5, 6))
    guides = {f"source_{k}": guide for k, guide in enumerate(sources)}
    guides |= {f"target_{k}": guide for k, guide in enumerate(targets)}
    np.savez(tmp_path / "scene.npz", scene="small/scene", style=style, **guides)
    settings = {
        "canonical": (Params(**QUICK), Backend(gpu_cuda)),
        "live": (Params(**QUICK), Backend(gpu_cuda, live.live)),
    }
    monkeypatch.setattr(gpu, "RUNS", 1)
    monkeypatch.chdir(tmp_path)
    assert gpu.main(options("scene.npz"), settings) == 0
    (written,) = gpu.record_files(tmp_path / "build" / "reports" / "gpu")
    (found,) = json.loads(written.read_text(encoding="utf-8"))["scenes"]
    assert found["scene"] == "small/scene"
    assert found["identical to the CPU"] == {"canonical": True}
    assert all(seconds > 0 for seconds in found["seconds"].values())
    assert found["kernels [s]"]["canonical"]["commit_kernel"]["launches"] == 4
    assert found["kernels [s]"]["live"]["propagation_kernel"]["launches"] == 3


def test_a_scene_is_packed_for_a_machine_that_reads_no_images(tmp_path):
    assert gpu.main(options("golem/pen", "--pack", str(tmp_path / "golem.npz"))) == 0
    name, style, sources, targets = gpu.read_scene(tmp_path / "golem.npz")
    assert name == "golem/pen"
    assert style.shape == (228, 300, 3)
    assert len(sources) == len(targets) == 5
