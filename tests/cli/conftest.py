"""Fixtures of the tests of the command line."""

import sys

import numpy as np
import pytest
from small_scene import small_scene

from stylit_ref import write_image
from stylit_ref.files.motion_flo import write_flo


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
def shot(scene):
    """Three frames beside the scene, and flow that leads from each into the next.

    (folder, style, source guides, target guides of every frame)
    """
    folder, style, sources, targets = scene
    frames = []
    for frame in range(3):
        frames.append([np.roll(target, frame, axis=1) for target in targets])
        for k, guide in enumerate(frames[-1]):
            write_image(folder / f"target_{k}.{frame + 1:04d}.png", guide)
        flow = np.tile(np.float32([1, 0]), (*targets[0].shape[:2], 1))
        write_flo(folder / f"flow.{frame + 1:04d}.flo", flow)
    return folder, style, sources, frames


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
