"""Files that ``run`` writes."""

import os
import shutil

import numpy as np
import pytest
from cli.calls import refused, run
from icc_profile import icc_profile

from stylit_ref import Params, read_image, stylize, write_image
from stylit_ref.cli import main
from stylit_ref.files.colour.bit_depth import to_linear
from stylit_ref.files.colour.profile import ColourProfile, read_colour_profile


def test_guide_maps_are_saved_with_the_levels(scene):
    folder, *arrays = scene
    more = ["--method", "guide_map", "--epsilon", 200, "--save-levels", folder / "levels"]
    assert run(folder, *more) == 0
    params = Params("guide_map", levels=2, votes=1, patchmatch_iterations=1, epsilon=200)
    expected = stylize(*arrays, params).guide_maps
    assert 0 < expected[-1].mean() < 1
    for level, white in enumerate(expected, 1):
        saved = read_image(folder / "levels" / f"guide_map_{level}.png")
        np.testing.assert_array_equal(saved[:, :, 0], white * 255)


def write_deep_style(folder, style, suffix):
    """A style with more than 8 bits: 16, or light."""
    deep = style.astype(np.uint16) * 256 + np.uint16(77)
    write_image(folder / f"deep.{suffix}", to_linear(deep) if suffix == "exr" else deep)


@pytest.mark.parametrize("suffix", ["png", "tif", "exr"])
@pytest.mark.parametrize("more", ["", "--mask", "--fill"])
def test_a_deep_style_makes_a_deep_picture(scene, suffix, more, capsys):
    """The one that a replay of the style makes."""
    folder, style, *_ = scene
    write_deep_style(folder, style, suffix)
    mask = np.zeros((38, 44), np.uint8)
    mask[10:30, 10:30] = 255
    write_image(folder / "mask.png", mask)
    fill = np.random.default_rng(0).integers(0, 65536, (38, 44, 3), dtype=np.uint16)
    write_image(folder / "fill.png", fill)
    options = ["--mask", folder / "mask.png"] if more else []
    filling = ["--fill", f"{folder}/fill.png"] if more == "--fill" else []
    out, nnf = folder / f"out.{suffix}", folder / "nnf.npy"
    options += [*filling, "--output", out, "--nnf", nnf, "--quiet"]
    assert run(folder, *options, style=f"deep.{suffix}") == 0
    assert capsys.readouterr().err == ""
    replay = ["replay", "--nnf", f"{nnf}", "--style", f"{folder}/deep.{suffix}", *filling]
    assert main([*replay, "--output", f"{folder}/again.{suffix}"]) == 0
    picture = read_image(out)
    assert picture.dtype == (np.float32 if suffix == "exr" else np.uint16)
    assert len(np.unique(picture)) > 300
    np.testing.assert_array_equal(picture, read_image(folder / f"again.{suffix}"))
    if filling and suffix != "exr":
        np.testing.assert_array_equal(picture[mask > 0], fill[mask > 0])


def test_sixteen_bits_become_light_in_exr(scene):
    folder, style, *_ = scene
    write_deep_style(folder, style, "png")
    assert run(folder, style="deep.png") == 0
    assert run(folder, "--output", folder / "out.exr", style="deep.png") == 0
    expected = to_linear(read_image(folder / "out.png"))
    np.testing.assert_allclose(read_image(folder / "out.exr"), expected, rtol=1e-6)


@pytest.mark.parametrize(
    ("style_suffix", "output", "said"),
    [
        ("tif", "out.jpg", "holds 8 bits a channel; a .png, .tif or .exr file keeps the 16 of the "
         "style"),
        ("exr", "out.png", "holds display values of 8 bits; an .exr file keeps the floating point "
         "of the style"),
    ],
)  # fmt: skip
def test_bits_that_the_output_has_not_are_noted(scene, style_suffix, output, said, capsys):
    folder, style, *_ = scene
    write_deep_style(folder, style, style_suffix)
    options = "--output", folder / output
    assert run(folder, *options, style=f"deep.{style_suffix}") == 0
    assert capsys.readouterr().err.startswith(f"note: {folder / output}: {said}\n")
    assert read_image(folder / output).dtype == np.uint8


def test_the_pictures_say_what_the_style_says_of_its_colours(scene, capsys):
    folder, style, *_ = scene
    profile = ColourProfile(of_light=False, icc=icc_profile(), icc_name="Red is green")
    assert run(folder, "--save-levels", folder / "plain") == 0
    plain = read_image(folder / "out.png")
    write_image(folder / "wide.png", style, profile=profile)
    options = "--save-levels", folder / "levels", "--nnf", folder / "nnf.npy", "--quiet"
    capsys.readouterr()
    assert run(folder, *options, style="wide.png") == 0
    replay = ["replay", "--nnf", f"{folder}/nnf.npy", "--output", f"{folder}/again.png", "--quiet"]
    assert main([*replay, "--style", f"{folder}/wide.png"]) == 0
    for file in ("out.png", "again.png", "levels/level_1.png"):
        assert read_colour_profile(folder / file) == profile
    np.testing.assert_array_equal(read_image(folder / "out.png"), plain)
    assert capsys.readouterr().err == ""
    assert run(folder, "--output", folder / "out.bmp", "--quiet", style="wide.png") == 0
    assert "out.bmp: cannot hold the ICC profile 'Red is green'" in capsys.readouterr().err


@pytest.mark.usefixtures("nothing_written")
class TestRefusals:
    """One sentence, exit code 2, and no file."""

    @pytest.mark.parametrize(
        ("option", "value", "message"),
        [
            ("--output", "style.png/out.png", "style.png: is a file; name a folder"),
            ("--output", "out.docx", "'.docx'"),
            ("--nnf", "style.png/deep/nnf.npy", "style.png: is a file; name a folder"),
            ("--nnf", "nnf.txt", "must end in .npy"),
            ("--save-levels", "style.png", "style.png: is a file; name a folder"),
            ("--save-levels", "style.png/deep", "style.png: is a file; name a folder"),
        ],
    )
    def test_unwritable_outputs(self, scene, capsys, option, value, message):
        assert message in refused(capsys, run(scene[0], option, scene[0] / value))

    @pytest.mark.parametrize("taken", ["style.png", "source_0.png", "mask.png"])
    def test_outputs_that_would_overwrite_inputs(self, scene, capsys, taken):
        folder = scene[0]
        write_image(folder / "mask.png", np.zeros((38, 44, 1), np.uint8))
        before = (folder / taken).read_bytes()
        code = run(
            folder, "--mask", folder / "mask.png", "--output", folder / ".." / folder.name / taken
        )
        assert f"{taken}: the output would overwrite this input; name another file" in refused(
            capsys, code
        )
        assert (folder / taken).read_bytes() == before

    def test_outputs_of_one_name(self, scene, capsys):
        folder = scene[0]
        code = run(folder, "--save-levels", folder / "out.png")
        assert "out.png: two outputs have this name" in refused(capsys, code)

    def test_a_full_disk(self, scene, capsys, monkeypatch):
        free = shutil.disk_usage(scene[0])._replace(free=5000)
        monkeypatch.setattr(shutil, "disk_usage", lambda _: free)
        message = refused(capsys, run(scene[0]))
        assert (
            "out.png: cannot be written: it may need 0.1 MiB, and the disk has 0.0 MiB free"
            in message
        )

    @pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
    def test_folder_without_permission(self, scene, capsys, tmp_path):
        locked = tmp_path / "locked"
        locked.mkdir(mode=0o500)
        assert "permission" in refused(capsys, run(scene[0], "--output", locked / "out.png"))
