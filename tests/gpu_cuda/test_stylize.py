"""A whole stylization on the device is the CPU's, byte for byte."""

import numpy as np
import pytest
from small_scene import small_scene

from gpu_cuda.host import doctor
from gpu_cuda.host.device import SIMULATED
from stylit_ref import InputError, Params, Profile, stylize
from stylit_ref.cli import main

SCENE = {"source_size": (14, 16), "target_size": (13, 15)}
QUICK = {"levels": 2, "votes": 2, "patchmatch_iterations": 1}


@pytest.mark.parametrize(
    "values",
    [
        {"votes": 1},
        {"uniformity": 0, "vote_outliers": 3, "votes": 1},
        {"method": "guide_map", "epsilon": 200.0, "votes": 1},
    ],
    ids=str,
)
def test_same_bytes_on_cpu_and_device(values):
    mask = np.zeros((13, 15), bool)
    mask[:4, 7:] = "method" in values
    scene, params = small_scene(**SCENE), Params(**(QUICK | values))
    host, device = (
        stylize(*scene, params, seed=3, mask=mask, backend=backend) for backend in ("cpu", "cuda")
    )
    for name in ("image", "nnf", "omega", "error"):
        np.testing.assert_array_equal(getattr(device, name), getattr(host, name), err_msg=name)
    assert device.history == host.history
    for ours, theirs in zip(device.guide_maps, host.guide_maps, strict=True):
        np.testing.assert_array_equal(ours, theirs)


def test_shared_memory_gives_the_bytes_of_ref():
    scene = small_scene(**SCENE)
    ref, shared = (
        stylize(*scene, Params(**(QUICK | {"votes": 1})), backend=backend)
        for backend in ("cpu", "cuda:shared_memory")
    )
    np.testing.assert_array_equal(shared.nnf, ref.nnf)
    np.testing.assert_array_equal(shared.image, ref.image)


@pytest.mark.parametrize("backend", ["cuda:live", "cuda:live_sums"])
def test_live_schedules_lower_phi_as_the_canonical_one_does(backend):
    scene = small_scene(**SCENE)
    live, canonical = (
        stylize(*scene, Params(**(QUICK | {"votes": 1})), backend=name) for name in (backend, "cpu")
    )
    phi = [run.history[-1].delta + run.history[-1].penalization for run in (live, canonical)]
    assert phi[0] < 1.2 * phi[1]


def test_of_the_images_nothing_comes_back_before_the_end():
    profile = Profile()
    params = Params(**(QUICK | {"levels": 2, "votes": 1}))
    result = stylize(*small_scene(**SCENE), params, backend="cuda", profile=profile)
    results = ("image", "nnf", "omega", "error")
    assert profile.calls["download"] == len(results) + len(result.history)  # numbers of moves
    assert profile.calls["energy"] == len(result.history)


@pytest.mark.parametrize("values", [{"method": "stylit"}, {"schedule": "scanline"}], ids=str)
def test_methods_without_kernels_are_refused_or_run_on_the_cpu(values):
    scene, params = small_scene(**SCENE), Params(**(QUICK | values))
    with pytest.raises(InputError, match="has no kernels for it; choose 'cpu'"):
        stylize(*scene, params, backend="cuda")
    host, automatic = (stylize(*scene, params, backend=backend) for backend in ("cpu", "auto"))
    np.testing.assert_array_equal(automatic.nnf, host.nnf)


def test_doctor_names_the_device(capsys):
    assert main(["doctor"]) == 0
    said = capsys.readouterr().out
    assert "numba " in said
    assert ("simulator" in said) == SIMULATED


@pytest.mark.skipif(not SIMULATED, reason="a GPU's memory is too large to fill here")
def test_a_full_device_is_one_sentence(monkeypatch):
    class DriverError(Exception):
        code = 2

    def refuse(*_):
        raise DriverError

    class Context:
        @staticmethod
        def get_memory_info():
            return 3 << 20, 100 << 20

    monkeypatch.setattr("gpu_cuda.host.memory.cuda.device_array", refuse)
    monkeypatch.setattr("gpu_cuda.host.memory.cuda.to_device", refuse)
    monkeypatch.setattr("gpu_cuda.host.memory.cuda.current_context", Context)
    with pytest.raises(
        InputError, match=r"the GPU has 3 of 100 MiB free, but these images need \d+ MiB more"
    ):
        stylize(*small_scene(**SCENE), Params(**QUICK), backend="cuda")


def test_a_missing_gpu_is_one_sentence(monkeypatch):
    monkeypatch.setattr(doctor, "missing", lambda: "there is no GPU that CUDA can use: none")
    with pytest.raises(InputError, match="backend is 'cuda', but there is no GPU"):
        stylize(*small_scene(**SCENE), Params(**QUICK), backend="cuda")
