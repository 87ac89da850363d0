"""What holds for every command: exit codes, and refusals that name what was typed."""

import logging
import re
import warnings
from dataclasses import fields

import numpy as np
import pytest
from cli.calls import refused, run

from stylit_ref import InputError, Params, write_image
from stylit_ref.cli import main, make_parser
from stylit_ref.cli.methods import OFFERS
from stylit_ref.cli.notes import notes_on_stderr
from stylit_ref.notes import note

PARAMETERS = {
    "run": {field.name for field in fields(Params)} | {"seed", "backend", "threads", "fill"},
    "replay": {"patch_width", "scale"},
    "oracle check": {"jobs", "timeout"},
}
"""What each command may hear refused by the name of a parameter."""

NEEDED = {
    "run": ["--style", "s", "--guide", "a", "b", "--output", "o"],
    "replay": ["--style", "s", "--nnf", "n", "--output", "o"],
    "oracle check": [],
}


@pytest.fixture
def raise_in_run(monkeypatch):
    """Have ``run`` raise an error once it has read and checked everything."""

    def arrange(error):
        def work(*_, **__):
            raise error

        monkeypatch.setitem(OFFERS, "ref", OFFERS["ref"]._replace(run=work))

    return arrange


@pytest.mark.parametrize("command", PARAMETERS)
def test_every_parameter_has_a_flag_of_its_command(command):
    options = make_parser().parse_args([*command.split(), *NEEDED[command]])
    flags = [options.parser.flag_of(name) for name in sorted(PARAMETERS[command])]
    assert all(flag.startswith("--") for flag in flags), flags
    assert len(set(flags)) == len(flags)


@pytest.mark.parametrize(
    ("parameter", "named"),
    [
        ("patch_width", "--patch-size is odd"),
        ("guide_weights", "--weight is odd"),
        ("source_guides", "source_guides is odd"),
        (None, "is odd"),
    ],
)
def test_a_parameter_goes_by_its_flag(scene, capsys, raise_in_run, parameter, named):
    raise_in_run(InputError("is odd", parameter=parameter))
    assert refused(capsys, run(scene[0], "--quiet")) == f"stylit-ref: {named}"


@pytest.mark.parametrize("name", ["epsilon map.png", "seed", "votes none"])
def test_a_file_called_like_a_parameter_keeps_its_name(scene, capsys, monkeypatch, name):
    monkeypatch.chdir(scene[0])
    code = main(["run", "--style", name, "--guide", "a", "b", "--output", "o.png"])
    assert refused(capsys, code) == f"stylit-ref: {name}: no such file"


@pytest.mark.parametrize(
    ("error", "code", "said"),
    [
        (MemoryError(), 2, "there is not enough memory for images of this size"),
        (KeyboardInterrupt(), 130, "interrupted; no half-written file is left"),
    ],
    ids=["memory", "Ctrl-C"],
)
def test_what_ends_a_run_is_one_sentence(scene, capsys, raise_in_run, error, code, said):
    raise_in_run(error)
    assert run(scene[0], "--quiet") == code
    assert capsys.readouterr().err == f"stylit-ref: {said}\n"
    assert not (scene[0] / "out.png").exists()


def test_a_mask_without_a_white_pixel_is_noted(scene, capsys):
    folder = scene[0]
    write_image(folder / "mask.png", np.zeros((38, 44, 1), np.uint8))
    assert run(folder, "--mask", folder / "mask.png") == 0
    said = capsys.readouterr().err.splitlines()
    assert said[0] == "note: --mask has no white pixel, so none is left alone"
    assert len(said) == 2


@pytest.fixture
def noted(capsys):
    """What is printed of notes that a command's options heard."""

    def told(words, *notes):
        options = make_parser().parse_args(["run", *NEEDED["run"], *words])
        with notes_on_stderr(options):
            for sentence, settings in notes:
                note(sentence, **settings)
        return capsys.readouterr().err.splitlines()

    return told


def test_a_note_is_one_line_and_comes_once(noted):
    assert noted([], ("my\rmask", {}), ("my\rmask", {}), ("odd", {})) == [
        "note: my mask",
        "note: odd",
    ]


@pytest.mark.parametrize(
    ("words", "level", "printed"),
    [
        ([], logging.INFO, []),
        (["--pyramid-levels", "9"], logging.INFO, ["note: --pyramid-levels is odd"]),
        ([], logging.WARNING, ["note: --pyramid-levels is odd"]),
    ],
)
def test_a_harmless_note_about_a_default_is_no_news(noted, words, level, printed):
    assert noted(words, ("is odd", {"parameter": "levels", "level": level})) == printed


def test_a_warning_of_another_library_is_a_note(capsys):
    with notes_on_stderr(make_parser().parse_args(["doctor"])):
        warnings.warn("odd", stacklevel=1)
    assert capsys.readouterr().err == "note: odd\n"


def test_without_a_command_there_is_help(capsys):
    assert main([]) == 2
    printed = capsys.readouterr()
    assert "stylit-ref example scenes" in printed.out
    assert all(re.search(rf"\n    {name}\s", printed.out) for name in make_parser().commands)
    assert printed.err == ""


@pytest.mark.parametrize(
    ("command", "missing", "said"),
    [
        ("example scenes", "data_gen", "the scenes are not installed with this package"),
        ("oracle check", "oracle", "the oracle cannot be loaded: "),
    ],
)
def test_a_part_that_is_not_installed(
    tmp_path, monkeypatch, capsys, hidden, command, missing, said
):
    monkeypatch.chdir(tmp_path)
    hidden(missing)
    assert said in refused(capsys, main(command.split()))
    assert not list(tmp_path.iterdir())
