"""``stylit-ref replay``."""

import os
import subprocess
import sys

import numpy as np
import pytest
from cli.calls import refused, run

from stylit_ref import Field, read_image, write_image, write_nnf
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
    assert main([*replay, "--style", f"{folder / 'large.tif'}"]) == 0
    assert read_image(folder / "again.png").shape == (76, 88, 3)
    assert read_image(folder / "again.png").dtype == np.uint16


def write_mask(folder):
    mask = np.zeros((38, 44), np.uint8)
    mask[10:30, 10:30] = 255
    mask[14, 15:18] = 0
    write_image(folder / "mask.png", mask)
    return mask


@pytest.mark.parametrize("more", [[], ["--patch-size", 7], ["--vote-outliers", 4]], ids=str)
@pytest.mark.parametrize("method", ["ref", "stylit"])
def test_a_masked_run_replays_to_its_own_bytes_without_an_option(scene, method, more, capsys):
    folder = scene[0]
    write_mask(folder)
    options = "--mask", folder / "mask.png", "--nnf", folder / "nnf.npy", "--method", method
    assert run(folder, *options, *more) == 0
    replay = ["replay", "--nnf", f"{folder / 'nnf.npy'}", "--output", f"{folder / 'again.png'}"]
    capsys.readouterr()
    assert main([*replay, "--style", f"{folder / 'style.png'}", "--quiet"]) == 0
    assert capsys.readouterr().err == ""
    assert (folder / "again.png").read_bytes() == (folder / "out.png").read_bytes()


@pytest.mark.parametrize("channels", [1, 2, 3, 4])
def test_a_filled_run_replays_to_its_own_bytes_with_its_fill(scene, channels):
    folder = scene[0]
    write_mask(folder)
    fill = np.random.default_rng(0).integers(0, 256, (38, 44, channels), dtype=np.uint8)
    if channels in (2, 4):
        fill[..., :-1] = np.minimum(fill[..., :-1], fill[..., -1:])
    write_image(folder / "fill.png", fill)
    more = ["--mask", f"{folder / 'mask.png'}", "--fill", f"{folder / 'fill.png'}"]
    assert run(folder, "--nnf", folder / "nnf.npy", *more) == 0
    replay = ["replay", "--nnf", f"{folder / 'nnf.npy'}", "--output", f"{folder / 'again.png'}"]
    replay += ["--style", f"{folder / 'style.png'}", "--fill", f"{folder / 'fill.png'}"]
    assert main(replay) == 0
    assert (folder / "again.png").read_bytes() == (folder / "out.png").read_bytes()
    np.save(folder / "nnf.npy", np.load(folder / "nnf.npy"))  # which forgets the run
    assert main([*replay, "--mask", f"{folder / 'mask.png'}"]) == 0
    assert (folder / "again.png").read_bytes() == (folder / "out.png").read_bytes()


@pytest.mark.parametrize("depth", ["png", "tif", "exr"])
def test_a_fill_has_the_depth_of_the_style(scene, depth):
    folder, style, *_ = scene
    mask = write_mask(folder)
    fill = np.full((38, 44, 3), 100, np.uint8)
    write_image(folder / f"fill.{depth}", fill.astype(np.uint16) * 257)
    write_image(folder / "style.tif", style.astype(np.uint16) * 257)
    assert run(folder, "--nnf", folder / "nnf.npy", "--mask", folder / "mask.png") == 0
    replay = ["replay", "--nnf", f"{folder / 'nnf.npy'}", "--output", f"{folder / 'again.png'}"]
    replay += ["--style", f"{folder / 'style.tif'}", "--fill", f"{folder / f'fill.{depth}'}"]
    assert main(replay) == 0
    again = read_image(folder / "again.png")
    assert again.dtype == np.uint16
    assert (again[mask > 0] == 25700).all()


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

    @pytest.mark.parametrize(
        ("option", "message"),
        [
            (["--patch-size", "3"], "--patch-size is 3, but the field is of a run with patches of"),
            (
                ["--scale", "2"],
                "--style is 46x40, but the style of the run was 46x40; it must be 2",
            ),
            (["--style", "source_0.png", "--fill", "style.png"], "--fill needs a mask"),
            (["--mask", "style.png"], "--mask is 46x40 but the target is 44x38"),
        ],
        ids=str,
    )
    def test_what_contradicts_the_run(self, scene, capsys, monkeypatch, option, message):
        monkeypatch.chdir(scene[0])
        nnf = np.random.default_rng(0).integers(2, 37, (38, 44, 2), np.int32)
        write_nnf("nnf.npy", Field(nnf, 5, style_size=(40, 46)))
        replay = ["replay", "--nnf", "nnf.npy", "--output", "out.png", "--style", "style.png"]
        assert message in refused(capsys, main([*replay, *option]))
