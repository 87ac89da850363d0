"""Fixtures of the tests of the command line."""

import sys

import pytest
from small_scene import small_scene

from stylit_ref import write_image


@pytest.fixture
def scene(tmp_path):
    """Files of a small scene: (folder, style, source guides, target guides)."""
    style, sources, targets = small_scene()
    write_image(tmp_path / "style.png", style)
    for k, (source, target) in enumerate(zip(sources, targets, strict=True)):
        write_image(tmp_path / f"source_{k}.png", source)
        write_image(tmp_path / f"target_{k}.png", target)
    return tmp_path, style, sources, targets


@pytest.fixture
def nothing_written(scene):
    """The scene's folder has no result after the test."""
    yield
    assert not (scene[0] / "out.png").exists()


@pytest.fixture
def hidden(monkeypatch):
    """Have a package seem not to be installed."""

    def hide(package):
        for name in [name for name in sys.modules if name.split(".")[0] == package]:
            monkeypatch.delitem(sys.modules, name)
        monkeypatch.setitem(sys.modules, package, None)

    return hide
