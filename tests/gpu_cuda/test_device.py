"""Kernels change no setting of the process."""

import subprocess
import sys
import warnings

import numpy as np
from device_level import to_host
from numba import config

import gpu_cuda

SETTINGS = """
from numba import config
before = dict(vars(config))
import gpu_cuda
import gpu_cuda.variants.live
changed = {name for name, value in vars(config).items() if before.get(name) is not value}
print(sorted(changed))
"""


def test_importing_sets_nothing():
    said = subprocess.run(
        [sys.executable, "-c", SETTINGS], capture_output=True, text=True, check=True
    )
    assert said.stdout == "[]\n"


def test_a_small_image_is_no_news_and_the_setting_stays(monkeypatch):
    monkeypatch.setattr(config, "CUDA_LOW_OCCUPANCY_WARNINGS", 1)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        zeros = gpu_cuda.zeros((3, 5), np.int32)
    assert not to_host(zeros).any()
    assert config.CUDA_LOW_OCCUPANCY_WARNINGS == 1
