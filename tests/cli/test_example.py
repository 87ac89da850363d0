"""``stylit-ref example``."""

import shlex

from cli.calls import QUICK

from stylit_ref import read_image
from stylit_ref.cli import main


def test_the_example_can_be_stylized(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["example", "some scenes"]) == 0
    words = shlex.split(capsys.readouterr().out)
    assert words[0] == "stylit-ref"
    assert main([*words[1:], *QUICK]) == 0
    size = read_image("some scenes/teapot/FULL.png").shape[:2]
    assert read_image("some scenes/stylized.png").shape == (*size, 3)
    assert [file.name for file in tmp_path.iterdir()] == ["some scenes"]


def test_an_example_replaces_nothing(tmp_path, capsys):
    assert main(["example", str(tmp_path)]) == 2
    assert f"{tmp_path}: exists; name a new folder" in capsys.readouterr().err
