"""Images that ``run`` reads."""

import numpy as np
import pytest
from cli.calls import QUICK, refused, run
from exr_files import write_exr

from stylit_ref import read_image, write_image
from stylit_ref.cli import main
from stylit_ref.files.colour.bit_depth import to_linear


def test_weight_without_guide(scene, capsys):
    with pytest.raises(SystemExit) as caught:
        main(["run", "--weight", "2", "--style", "s.png", "--output", "o.png"])
    assert caught.value.code == 2
    message = capsys.readouterr().err.strip()
    assert "must follow the --guide" in message
    assert "\n" not in message


def test_mask_without_fill_is_transparent(scene):
    folder = scene[0]
    mask = np.zeros((38, 44), np.uint8)
    mask[10:30, 10:30] = 255
    write_image(folder / "mask.png", mask)
    assert run(folder, "--mask", folder / "mask.png") == 0
    np.testing.assert_array_equal(read_image(folder / "out.png")[:, :, 3], 255 - mask)


def test_mask_with_fill(scene):
    folder = scene[0]
    mask = np.zeros((38, 44), np.uint8)
    mask[10:30, 10:30] = 255
    fill = np.full((38, 44, 3), 77, np.uint8)
    write_image(folder / "mask.png", mask)
    write_image(folder / "fill.png", fill)
    assert run(folder, "--mask", folder / "mask.png", "--fill", folder / "fill.png") == 0
    assert (read_image(folder / "out.png")[mask > 0] == 77).all()


def test_exr_layers_as_guides(scene):
    """Layers of linear light give the result of the same guides as display values."""
    folder, _, sources, targets = scene
    for side, guides in (("source", sources), ("target", targets)):
        first, second = (to_linear(guide) for guide in guides)
        channels = {f"LDE.{name}": first[:, :, c] for c, name in enumerate("RGB")}
        write_exr(folder / f"{side}.exr", channels | {"LSE.Y": second[:, :, 0]}, second.shape[:2])
    command = ["run", "--style", f"{folder}/style.png", "--output", f"{folder}/exr.png", *QUICK]
    for layer in ("LDE", "LSE"):
        command += ["--guide", f"{folder}/source.exr:{layer}", f"{folder}/target.exr:{layer}"]
    assert main(command) == 0
    assert run(folder) == 0
    np.testing.assert_array_equal(read_image(folder / "exr.png"), read_image(folder / "out.png"))


def test_sixteen_bit_grey_and_alpha_styles(scene):
    folder, style, *_ = scene
    write_image(folder / "deep.png", style.astype(np.uint16) * 257)
    write_image(folder / "grey.png", style[:, :, 0])
    alpha = np.dstack([style, np.full(style.shape[:2], 200, np.uint8)])
    alpha[:, :, :3] = np.minimum(alpha[:, :, :3], 200)
    write_image(folder / "alpha.tif", alpha)
    assert run(folder) == 0
    reference = read_image(folder / "out.png")
    assert run(folder, style="deep.png") == 0
    np.testing.assert_allclose(read_image(folder / "out.png") / 257, reference, atol=0.51)
    assert run(folder, style="grey.png") == 0
    assert read_image(folder / "out.png").shape == (38, 44, 1)
    assert run(folder, style="alpha.tif") == 0
    assert (read_image(folder / "out.png")[:, :, 3] == 200).all()


def test_transparent_and_grey_guides_fit_their_partners(scene):
    """A render with a background alpha beside an opaque one, and grey beside colour."""
    folder, _, _, targets = scene
    alpha = np.full(targets[0].shape[:2], 255, np.uint8)
    alpha[:5] = 0
    write_image(folder / "target_0.png", np.dstack([targets[0] * (alpha > 0)[..., None], alpha]))
    write_image(folder / "target_1.png", targets[1].repeat(3, axis=2))
    assert run(folder) == 0
    assert read_image(folder / "out.png").shape == (38, 44, 3)


@pytest.mark.usefixtures("nothing_written")
class TestRefusals:
    """One sentence, exit code 2, and no file."""

    def test_style_and_guide_of_different_sizes(self, scene, capsys):
        folder, style, *_ = scene
        write_image(folder / "wide.png", np.pad(style, ((0, 0), (0, 9), (0, 0))))
        message = refused(capsys, run(folder, style="wide.png"))
        assert "source_0.png is 46x40 but the style is 55x40" in message

    def test_fewer_target_guides_cannot_be_said(self, scene, capsys):
        with pytest.raises(SystemExit) as caught:
            main(["run", "--style", "s.png", "--output", "o.png", "--guide", "a.png"])
        assert caught.value.code == 2
        assert "--guide" in capsys.readouterr().err

    def test_missing_file(self, scene, capsys):
        message = refused(capsys, run(scene[0], style="none.png"))
        assert "none.png: no such file" in message

    def test_missing_layer(self, scene, capsys):
        folder = scene[0]
        write_exr(folder / "source_0.exr", {"LDE.R": 0.1, "LSE.R": 0.1}, (40, 46))
        guides = ("source_0.exr:LDDE", "target_{}.png")
        message = refused(capsys, run(folder, guides=guides))
        assert "no layer 'LDDE'" in message
        assert "LDE, LSE" in message

    @pytest.mark.parametrize(
        ("role", "other_way"),
        [("guide", ", or name layers of both files with --guide-layers"), ("style", "")],
    )
    def test_a_file_without_an_unnamed_layer(self, scene, capsys, role, other_way):
        folder = scene[0]
        file = write_exr(folder / "a.exr", {"V.Combined.R": 0.5, "V.DiffDir.R": 0.5})
        names = {"style": "a.exr"} if role == "style" else {"guides": ("a.exr", "a.exr")}
        message = refused(capsys, run(folder, **names))
        assert message == (
            f"stylit-ref: {file}: has several layers; write {file}:V.Combined{other_way}; "
            "its layers are: V.Combined, V.DiffDir"
        )

    def test_nan(self, scene, capsys):
        folder = scene[0]
        write_exr(folder / "nan.exr", {"R": np.nan, "G": 0, "B": 0}, (40, 46))
        message = refused(capsys, run(folder, style="nan.exr"))
        assert "1840 pixels are NaN or infinite" in message

    def test_fill_without_mask(self, scene, capsys):
        assert "--mask" in refused(capsys, run(scene[0], "--fill", scene[0] / "style.png"))

    def test_mask_of_another_size(self, scene, capsys):
        folder = scene[0]
        assert "--mask is 46x40 but the target is 44x38" in refused(
            capsys, run(folder, "--mask", folder / "style.png")
        )

    def test_source_and_target_that_look_swapped(self, scene, capsys):
        folder = scene[0]
        message = refused(capsys, run(folder, guides=("target_{}.png", "source_{}.png")))
        assert f"--guide {folder / 'target_0.png'} is 44x38 but the style is 46x40, as " in message
        assert message.endswith("source and target look swapped; name the source first")
