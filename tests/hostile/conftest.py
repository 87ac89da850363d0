"""A working directory with all files that a command needs."""

import numpy as np
import pytest
from small_scene import small_scene

from stylit_ref import write_image


@pytest.fixture(scope="session")
def images():
    style, sources, targets = small_scene(source_size=(12, 13), target_size=(11, 14))
    named = {"style.png": style}
    for k in range(2):
        named |= {f"source_{k}.png": sources[k], f"target_{k}.png": targets[k]}
    return named


@pytest.fixture
def folder(tmp_path, images, monkeypatch):
    for name, image in images.items():
        write_image(tmp_path / name, image)
    nnf = np.random.default_rng(0).integers(2, 10, (11, 14, 2), np.int32)
    np.save(tmp_path / "nnf.npy", nnf)
    monkeypatch.chdir(tmp_path)
    return tmp_path
