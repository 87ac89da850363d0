"""A scene in files, and a small data set."""

import numpy as np
import pytest
from small_scene import small_scene

from data_gen.manifest import Manifest
from eval.scenes import BUNDLED
from stylit_ref import read_uint8, write_image


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A scene in files, far from the reports and results of the checkout."""
    monkeypatch.chdir(tmp_path)
    style, sources, targets = small_scene()
    (tmp_path / "small").mkdir()
    write_image(tmp_path / "small" / "source_style.png", style)
    for name, source, target in zip(("fullgi", "id"), sources, targets, strict=True):
        write_image(tmp_path / "small" / f"source_{name}.png", source)
        write_image(tmp_path / "small" / f"target_{name}.png", target)
    return tmp_path / "small"


@pytest.fixture
def data(tmp_path, monkeypatch):
    """A data set of one target, a sixth as wide as the bundled one."""
    monkeypatch.chdir(tmp_path)
    data = tmp_path / "small"
    manifest = Manifest.open(data)
    manifest.restart(Manifest.read(BUNDLED).recipe)
    for piece in ("source", "teapot"):
        for file in Manifest.read(BUNDLED).pieces[piece]:
            image = read_uint8(BUNDLED / file)[::6, ::6]
            (data / file).parent.mkdir(parents=True, exist_ok=True)
            write_image(data / file, np.ascontiguousarray(image))
        manifest.add(piece)
    return data
