"""Options that name the guides, and what together they say."""

import json
import re

import numpy as np
import pytest
from cli.calls import QUICK, refused
from exr_files import write_exr

from stylit_ref import read_image, read_nnf
from stylit_ref.cli import main
from stylit_ref.files.colour.bit_depth import to_linear
from stylit_ref.files.layers.cryptomatte import id_of


@pytest.fixture
def renders(scene):
    """Two EXR files as Blender 5 writes them: HDR light, an index and a Cryptomatte."""
    folder, _, sources, targets = scene
    for name, (colour, grey) in (("source", sources), ("target", targets)):
        light = to_linear(colour) * 3
        index = np.float32(grey[:, :, 0] > 128) + 1
        ids = np.where(index > 1, *(np.uint32(id_of(one)).view(np.float32) for one in "ab"))
        channels = {f"ViewLayer.Combined.{c}": light[:, :, k] for k, c in enumerate("RGB")}
        channels |= {f"ViewLayer.Diffuse Direct.{c}": light[:, :, 0] for c in "RGB"}
        channels |= {"ViewLayer.Object Index.X": index, "ViewLayer.Depth.Z": 5 + index}
        channels |= {"ViewLayer.CryptoObject00.r": ids, "ViewLayer.CryptoObject00.g": 1}
        attributes = {
            "cryptomatte/1/name": "ViewLayer.CryptoObject",
            "cryptomatte/1/manifest": json.dumps({one: f"{id_of(one):08x}" for one in "ab"}),
        }
        write_exr(
            folder / f"{name}.exr", channels, colour.shape[:2], depth="float", attributes=attributes
        )
    return folder


def run_layers(folder, *more, output="out.png", guides=(("source.exr", "target.exr"),)):
    """Call ``run`` on the renders; ``more`` comes after the guides."""
    command = ["run", "--style", f"{folder / 'style.png'}", "--output", f"{folder / output}"]
    for pair in guides:
        command += ["--guide", *(f"{folder / file}" for file in pair)]
    return main([*command, *map(str, more), *QUICK])


def notes(capsys):
    return [line for line in capsys.readouterr().err.splitlines() if line.startswith("note: ")]


def test_layers_of_two_files_are_guides(renders, capsys):
    """Short names and long ones name the same."""
    layers = "Combined", "Diffuse Direct", "Object Index"
    pairs = [(f"source.exr:ViewLayer.{one}", f"target.exr:ViewLayer.{one}") for one in layers]
    assert run_layers(renders, "--guide-layers", "Combined,DiffDir,IndexOB", output="a.png") == 0
    (note,) = notes(capsys)
    assert re.fullmatch(
        r"note: --guide-encoding makes 8 bits of floating point, in source and target alike: "
        r"Combined at 0\.\d+ of its brightness, Diffuse Direct at 0\.\d+ of its brightness, "
        r"Object Index as 2 labels with a colour each; "
        r"with none, values outside \[0, 1\] would be clipped",
        note,
    )
    assert run_layers(renders, guides=pairs) == 0
    np.testing.assert_array_equal(read_image(renders / "a.png"), read_image(renders / "out.png"))


def test_a_weight_belongs_to_all_layers_of_its_guide(renders):
    layers = "Combined", "Object Index"
    pairs = [(f"source.exr:ViewLayer.{one}", f"target.exr:ViewLayer.{one}") for one in layers]
    weigh = ["--guide-layers", "Combined,Object Index", "--weight", 3]
    depth = ["--guide", renders / "source.exr:Depth", renders / "target.exr:Depth"]
    assert run_layers(renders, *weigh, *depth, output="a.png") == 0
    command = ["--weight", 3, *depth]
    first = ["--guide", *(renders / file for file in pairs[0]), "--weight", 3]
    assert run_layers(renders, *command, guides=pairs[1:], output="c.png") == 0
    assert (
        main(
            [
                *map(str, ["run", "--style", renders / "style.png", *first]),
                *map(str, ["--guide", *(renders / file for file in pairs[1]), *command]),
                *map(str, ["--output", renders / "b.png", *QUICK]),
            ]
        )
        == 0
    )
    weighed = read_image(renders / "a.png")
    np.testing.assert_array_equal(weighed, read_image(renders / "b.png"))
    assert (weighed != read_image(renders / "c.png")).any()


def test_a_view_layer_may_stand_in_the_files_names(renders):
    pair = "source.exr:ViewLayer", "target.exr:ViewLayer"
    assert run_layers(renders, "--guide-layers", "Combined", guides=[pair]) == 0


def test_a_cryptomatte_is_a_guide(renders, capsys):
    assert run_layers(renders, "--guide-layers", "CryptoObject") == 0
    assert "CryptoObject as 2 labels" in notes(capsys)[0]


def test_encoding_is_off_on_request(renders, capsys):
    layers = ["--guide-layers", "Combined,IndexOB"]
    assert run_layers(renders, *layers, output="a.png") == 0
    capsys.readouterr()
    assert run_layers(renders, *layers, "--guide-encoding", "none") == 0
    clipped, constant = notes(capsys)
    assert "are clipped" in clipped
    assert "IndexOB has one value all over" in constant
    assert (read_image(renders / "a.png") != read_image(renders / "out.png")).any()


def test_the_field_keeps_the_encoding_for_the_next_frame(renders):
    layers = ["--guide-layers", "Combined,IndexOB"]
    assert run_layers(renders, *layers, "--nnf", renders / "a.npy", output="a.png") == 0
    encodings = read_nnf(renders / "a.npy").guide_encodings
    assert [encoding.kind for encoding in encodings] == ["light", "labels"]
    next_run = ["--guide-encoding", renders / "a.npy", "--nnf", renders / "b.npy"]
    darker = ("source.exr", "source.exr")
    assert run_layers(renders, *layers, *next_run, guides=[darker]) == 0
    assert read_nnf(renders / "b.npy").guide_encodings == encodings


def test_all_weights_0(renders, capsys):
    assert run_layers(renders, "--guide-layers", "IndexOB", "--weight", 0) == 0
    assert notes(capsys)[-1] == "note: --weight is 0 for every guide, so the guides guide nothing"


@pytest.mark.usefixtures("nothing_written")
class TestRefusals:
    """One sentence, exit code 2, and no file."""

    def test_a_layer_that_is_not_there(self, renders, capsys):
        message = refused(capsys, run_layers(renders, "--guide-layers", "Combined,GlossDir"))
        assert "source.exr: has no layer 'GlossDir'; its layers are: ViewLayer.Combined" in message

    def test_layers_before_a_guide(self, capsys):
        with pytest.raises(SystemExit) as caught:
            main(["run", "--guide-layers", "A", "--style", "s.png", "--output", "o.png"])
        assert caught.value.code == 2
        assert "--guide-layers: must follow the --guide" in capsys.readouterr().err

    @pytest.mark.parametrize("option", ["--guide-layers", "--weight"])
    def test_twice_for_one_guide(self, renders, capsys, option):
        with pytest.raises(SystemExit) as caught:
            run_layers(renders, option, 1, option, 2)
        assert caught.value.code == 2
        assert f"{option}: the --guide before it has one already" in capsys.readouterr().err

    @pytest.mark.parametrize("names", ["", "Combined,", ","])
    def test_no_name_between_commas(self, renders, capsys, names):
        with pytest.raises(SystemExit) as caught:
            run_layers(renders, "--guide-layers", names)
        assert caught.value.code == 2
        assert "it must be names with commas between them" in capsys.readouterr().err

    def test_another_word_for_an_encoding(self, renders, capsys):
        layers = ["--guide-layers", "Combined"]
        message = refused(capsys, run_layers(renders, *layers, "--guide-encoding", "off"))
        assert message.endswith(
            "--guide-encoding is off; it must be auto, none, or the .npy file of an earlier run"
        )

    def test_a_field_without_encodings(self, renders, capsys):
        np.save(renders / "a.npy", np.zeros((4, 4, 2), np.int32))
        command = ["--guide-layers", "Combined", "--guide-encoding", renders / "a.npy"]
        message = refused(capsys, run_layers(renders, *command))
        assert "a.npy: does not say how the guides of its run were encoded" in message

    def test_the_field_of_another_run_is_not_overwritten(self, renders, capsys):
        layers = ["--guide-layers", "Combined"]
        assert run_layers(renders, *layers, "--nnf", renders / "a.npy", output="a.png") == 0
        capsys.readouterr()
        both = ["--guide-encoding", renders / "a.npy", "--nnf", renders / "a.npy"]
        assert "a.npy" in refused(capsys, run_layers(renders, *layers, *both))
