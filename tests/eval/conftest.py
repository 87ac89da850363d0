"""A scene in files, and a small data set."""

import numpy as np
import pytest
from small_scene import small_scene

from data_gen.guides import LIGHT_PASSES, guide, to_uint8
from data_gen.manifest import Manifest
from data_gen.multilayer_exr import read_layers, write_layers
from data_gen.styles import STYLES, subject
from eval.scenes import BUNDLED
from stylit_ref import read_uint8, write_image
from stylit_ref.files.colour.bit_depth import to_linear


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


@pytest.fixture
def layers(tmp_path, monkeypatch):
    """A data set of a target and a style with layers, a sixth as wide as the bundled one."""
    monkeypatch.chdir(tmp_path)
    data = tmp_path / "layers"
    manifest = Manifest.open(data)
    manifest.restart(Manifest.read(BUNDLED).recipe)
    for place in ("source", "teapot"):
        (data / place).mkdir()
        images = {
            name: read_uint8(BUNDLED / f"{place}/{name}.png")[::6, ::6]
            for name in (*LIGHT_PASSES, "IDMASK", "NORMAL")
        }
        found = {name: to_linear(images[name]) for name in LIGHT_PASSES}
        found["IDMASK"] = np.float32(images["IDMASK"] / 255)
        found["NORMAL"] = np.float32(images["NORMAL"] / 127.5 - 1)
        write_layers(data / place / "passes.exr", found)
        found = read_layers(data / place / "passes.exr")
        for name, layer in found.items():
            write_image(data / place / f"{name}.png", guide(name, layer))
        if place == "source":
            (data / "source/styles").mkdir()
            write_image(data / "source/styles/oil.png", to_uint8(STYLES["oil"](subject(found))))
        manifest.add(place)
    return data
