"""Input that ``python -m eval`` refuses."""

import sys

import pytest

from eval.__main__ import main


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["stylit", "--scene", "none"], "none: is neither a folder nor TARGET/STYLE of"),
        (["stylit", "--scene", "."], "is not a scene"),
        (["stylit", "--scene", "small", "--step", "0"], "--step is 0"),
        (["spilling", "--scene", "small"], "small: has no IDMASK"),
        (["bench", "--scene", "small", "--ebsynth", "./none"], "./none: is not a program"),
    ],
    ids=lambda value: value[0] if isinstance(value, list) else "",
)
def test_bad_input(folder, capsys, arguments, message):
    assert main(arguments) == 2
    error = capsys.readouterr().err.strip().splitlines()[-1]
    assert message in error


@pytest.mark.parametrize(
    "arguments",
    [
        ["stylit", "--ebsynth", "ebsynth"],
        ["bench", "--numbers"],
        ["scenes", "--scene", "golem/oil"],
        ["epsilon", "--uniformities", "0"],
        ["schedules", "--preset", "quick"],
    ],
    ids=" ".join,
)
def test_an_option_of_another_report_is_refused(capsys, arguments):
    with pytest.raises(SystemExit) as refused:
        main(arguments)
    assert refused.value.code == 2
    assert f"unrecognized arguments: {arguments[1]}" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--scene", "small", "--targets", "golem"], "--targets cannot be used with --scene"),
        (["--style", "oil.png"], "--style needs --scene"),
    ],
    ids=["preset", "scene"],
)
def test_a_preset_and_a_scene_have_options_of_their_own(capsys, arguments, message):
    assert main(["dzurenko", *arguments]) == 2
    assert message in capsys.readouterr().err


def test_packages_that_are_missing_are_named(monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "pandas", None)
    for name in [name for name in sys.modules if name.startswith("eval.reports")]:
        monkeypatch.delitem(sys.modules, name)
    assert main(["stylit", "--help"]) == 2
    said = capsys.readouterr().err
    assert "import of pandas halted" in said
    assert "install them with pip install -e '.[eval]'" in said
