"""``stylit-ref replay``."""

import os
import subprocess
import sys

import numpy as np
import pytest
from cli.calls import refused, run

from stylit_ref import read_image, write_image
from stylit_ref.cli import main


def test_replay(scene):
    folder, style, *_ = scene
    assert run(folder, "--nnf", folder / "nnf.npy") == 0
    replay = ["replay", "--nnf", f"{folder / 'nnf.npy'}", "--output", f"{folder / 'again.png'}"]
    assert main([*replay, "--style", f"{folder / 'style.png'}"]) == 0
    again = read_image(folder / "again.png")
    np.testing.assert_array_equal(again, read_image(folder / "out.png"))

    large = (style.astype(np.uint16) * 257).repeat(2, axis=0).repeat(2, axis=1)
    write_image(folder / "large.tif", large)
    assert main([*replay, "--style", f"{folder / 'large.tif'}", "--scale", "2"]) == 0
    assert read_image(folder / "again.png").shape == (76, 88, 3)
    assert read_image(folder / "again.png").dtype == np.uint16


@pytest.mark.slow
def test_replay_in_a_process_of_its_own(scene):
    """With nothing compiled before it, in the process or on disk."""
    folder, style, *_ = scene
    nnf = np.stack(np.mgrid[2:38, 2:44], axis=-1).astype(np.int32)
    np.save(folder / "nnf.npy", nnf)
    command = [sys.executable, "-m", "stylit_ref.cli", "replay", "--nnf", f"{folder / 'nnf.npy'}"]
    command += ["--style", f"{folder / 'style.png'}", "--output", f"{folder / 'out.png'}"]
    environment = os.environ | {"NUMBA_CACHE_DIR": str(folder / "kernels")}
    subprocess.run(command, check=True, env=environment)
    np.testing.assert_array_equal(read_image(folder / "out.png"), style[2:38, 2:44])


@pytest.mark.usefixtures("nothing_written")
class TestRefusals:
    """One sentence, exit code 2, and no file."""

    def test_replay_of_something_else(self, scene, capsys):
        folder = scene[0]
        (folder / "text.npy").write_text("no array")
        np.save(folder / "objects.npy", np.array([{}], object), allow_pickle=True)
        (folder / "zip.npy").write_bytes(b"PK" + bytes(100))
        np.save(folder / "float.npy", np.zeros((4, 4, 2)))
        for name in ("none.npy", "text.npy", "objects.npy", "zip.npy", "float.npy"):
            replay = ["replay", "--nnf", f"{folder / name}", "--output", f"{folder / 'out.png'}"]
            code = main([*replay, "--style", f"{folder / 'style.png'}"])
            message = refused(capsys, code)
            assert name in message or "float64" in message
