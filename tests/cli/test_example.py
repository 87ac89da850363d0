"""``stylit-ref example``."""

import shlex

import pytest
from cli.calls import QUICK

from stylit_ref import read_image
from stylit_ref.cli import main, make_parser


def test_the_example_can_be_stylized(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["example", "some scenes"]) == 0
    words = shlex.split(capsys.readouterr().out)
    assert words[0] == "stylit-ref"
    assert main([*words[1:], *QUICK]) == 0
    size = read_image("some scenes/teapot/FULL.png").shape[:2]
    assert read_image("some scenes/stylized.png").shape == (*size, 3)
    assert [file.name for file in tmp_path.iterdir()] == ["some scenes"]


def test_three_frames_of_the_house_can_be_stylized(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["example", "scenes"]) == 0
    words = shlex.split(capsys.readouterr().err.splitlines()[-1])
    assert words[:2] == ["stylit-ref", "sequence"]
    assert main([*words[1:], *QUICK]) == 0
    assert len(list(tmp_path.glob("scenes/house.*.png"))) == 3


def files_of(folder):
    return {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()}


def test_an_example_again_completes_and_replaces_nothing(tmp_path, capsys):
    folder = tmp_path / "scenes"
    assert main(["example", str(folder)]) == 0
    printed = capsys.readouterr().out
    (folder / "source" / "styles" / "oil.png").write_bytes(b"painted over")
    before = files_of(folder)
    (folder / "teapot" / "FULL.png").unlink()
    assert main(["example", str(folder)]) == 0
    assert capsys.readouterr().out == printed
    assert files_of(folder) == before


def test_an_example_in_an_empty_folder(tmp_path):
    assert main(["example", str(tmp_path)]) == 0
    assert (tmp_path / "teapot" / "FULL.png").exists()


@pytest.mark.parametrize("folder", ["scenes", "-scenes"])
def test_the_printed_command_is_one_of_ours(tmp_path, monkeypatch, capsys, folder):
    monkeypatch.chdir(tmp_path)
    assert main(["example", "--", folder]) == 0
    words = shlex.split(capsys.readouterr().out)
    make_parser().parse_args(words[1:])


def test_another_manifest_makes_no_folder_of_scenes(tmp_path, capsys):
    (tmp_path / "manifest.json").write_text("{}")
    assert main(["example", str(tmp_path)]) == 2
    assert "holds other files" in capsys.readouterr().err
    assert [file.name for file in tmp_path.iterdir()] == ["manifest.json"]


def test_an_example_among_other_files_is_refused(tmp_path, capsys):
    (tmp_path / "thesis.tex").touch()
    assert main(["example", str(tmp_path)]) == 2
    assert f"{tmp_path}: holds other files; name a new folder" in capsys.readouterr().err
    assert [file.name for file in tmp_path.iterdir()] == ["thesis.tex"]
