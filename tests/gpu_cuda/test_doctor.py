"""The doctor's report on drivers and devices, which are simulated."""

from types import SimpleNamespace

import pytest

from gpu_cuda.host import doctor


def machine(driver=(13, 0), capability=(9, 0), context=lambda: None, nvvm=lambda: None):
    """A stand-in for the parts of ``numba.cuda`` that the doctor uses."""
    version = SimpleNamespace(get_version=lambda: driver)
    return SimpleNamespace(
        cudadrv=SimpleNamespace(
            driver=SimpleNamespace(driver=version),
            nvvm=SimpleNamespace(NVVM=nvvm),
            libs=SimpleNamespace(get_cudalib=lambda name, static: name),
        ),
        current_context=context,
        get_current_device=lambda: SimpleNamespace(compute_capability=capability, name=b"GTX 660"),
    )


def no_compiler():
    raise OSError("libNVVM cannot be found.")


def no_driver():
    raise RuntimeError("Error at driver init:\nno CUDA-capable device is detected.")


@pytest.mark.parametrize(
    ("found", "said"),
    [
        (machine(), None),
        (machine(driver=(12, 8)), "the NVIDIA driver supports CUDA 12.8, but 13.0 is needed"),
        (machine(capability=(3, 0)), "GTX 660 has compute capability 3.0, but 7.5 is needed"),
        (machine(nvvm=no_compiler), "libNVVM cannot be found (pip install"),
        (machine(context=no_driver), "init: no CUDA-capable device is detected (pip install"),
    ],
)
def test_what_is_missing_is_one_clause(monkeypatch, found, said):
    monkeypatch.setattr(doctor, "SIMULATED", False)
    monkeypatch.setattr(doctor, "_version", lambda package: "1.0")
    monkeypatch.setattr(doctor, "cuda", found)
    missing = doctor.missing()
    assert missing is None if said is None else said in missing


def test_numba_cuda_is_named_where_it_is_missing(monkeypatch):
    monkeypatch.setattr(doctor, "SIMULATED", False)
    monkeypatch.setattr(doctor, "_version", lambda package: None)
    assert doctor.missing().startswith("numba-cuda is not installed (pip install")
