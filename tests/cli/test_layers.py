"""``stylit-ref layers``."""

import numpy as np
import pytest
from cli.calls import refused
from exr_files import write_deep, write_exr

from stylit_ref import read_guides, read_image, write_image
from stylit_ref.cli import main


def listed(capsys, file):
    assert main(["layers", str(file)]) == 0
    return [line.split(maxsplit=1) for line in capsys.readouterr().out.splitlines()]


def test_each_layer_has_a_line(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    channels = {f"VL.Combined.{c}": 1 for c in "RGBA"} | {"VL.Depth.Z": 1, "VL.Object Index.X": 1}
    channels |= {f"VL.CryptoObject{k:02}.{c}": 1 for k in range(2) for c in "rgba"}
    write_exr("a.exr", channels, depth="float")
    assert main(["layers", "a.exr"]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "a.exr:VL.Combined           R G B A  picture",
        "a.exr:VL.Combined.A         A        mask, data",
        "a.exr:VL.Depth              Z        mask, data",
        "'a.exr:VL.Object Index'     X        mask, data, labels",
        "a.exr:VL.CryptoObject                labels",
        "a.exr:VL.CryptoObject/NAME           mask, data: Cryptomatte; the file does not list its "
        "names",
    ]


def test_what_it_prints_can_be_read(tmp_path, capsys):
    """Channels beside the colours too."""
    names = ["R", "G", "B", "Z", "matte", "AO.Y", "AO.A", "N.X", "N.Y", "N.Z"]
    file = write_exr(tmp_path / "a.exr", dict.fromkeys(names, 0.5))
    lines = listed(capsys, file)
    assert {line[0].removeprefix(str(file)) for line in lines} == {
        "", ":Z", ":matte", ":AO", ":AO.A", ":N",
    }  # fmt: skip
    for name, _ in lines:
        assert read_image(name).shape[:2] == (6, 8)


@pytest.mark.parametrize(
    ("channel", "depth", "uses"),
    [
        ("IndexOB.X", "float", "mask, data, labels"),
        ("objectId.Y", "half", "mask, data, labels"),
        ("AO.Y", "half", "mask, picture"),
        ("rank.X", "uint", "labels"),
        ("Y", "uint", "labels"),
        ("Depth.Z", "float", "mask, data"),
        ("id", "float", "mask, data, labels"),
    ],
)
def test_which_layers_become_labels(tmp_path, capsys, channel, depth, uses):
    (line,) = listed(capsys, write_exr(tmp_path / "a.exr", {channel: 1}, depth=depth))
    assert line[1].split(maxsplit=1)[1] == uses
    (guide,) = read_guides([[tmp_path / "a.exr"] * 2]).encodings
    assert (guide.kind == "labels") == ("labels" in uses)


def test_the_preview_of_a_cryptomatte_has_no_line(tmp_path, capsys):
    """It has the name that the labels go by."""
    channels = {f"Crypto00.{c}": 0 for c in "rgba"} | {f"Crypto.{c}": 0.5 for c in "RGB"}
    file = write_exr(tmp_path / "a.exr", channels, depth="float")
    assert [line[0] for line in listed(capsys, file)] == [f"{file}:Crypto", f"{file}:Crypto/NAME"]


def test_a_picture_without_layers(tmp_path, capsys):
    write_image(tmp_path / "a.png", np.zeros((6, 8, 3), np.uint8))
    assert listed(capsys, tmp_path / "a.png") == [[f"{tmp_path}/a.png", "R G B  picture"]]


def test_a_deep_layer_serves_as_nothing(tmp_path, capsys):
    (line,) = listed(capsys, write_deep(tmp_path / "a.exr"))
    assert line[1].endswith(
        "nothing: its pixels are deep; oiiotool --flatten makes a picture of them"
    )


def test_no_such_file(tmp_path, capsys):
    message = refused(capsys, main(["layers", str(tmp_path / "none.exr")]))
    assert message.endswith("none.exr: no such file")
