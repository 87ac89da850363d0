"""What the parser refuses, and how it names what was meant."""

import pytest

from stylit_ref.cli import main

EBSYNTH = "docs/how_to/from_ebsynth.md has every option of ebsynth"


def refusal(capsys, command):
    """What the parser says of a command line, without the program's name before it."""
    with pytest.raises(SystemExit) as stop:
        main(command.split())
    assert stop.value.code == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    return said.strip().removesuffix(" (--help shows the options)")


@pytest.mark.parametrize(
    ("command", "said"),
    [
        ("run --ouput o.png", "there is no option --ouput; did you mean --output?"),
        ("run --style s --ouput=o.png", "there is no option --ouput; did you mean --output?"),
        ("run --patchsize 5", "--patchsize: did you mean --patch-size?"),
        ("run --frobnicate", "there is no option --frobnicate"),
        ("run -style s.png", f"-style: two dashes here: --style; {EBSYNTH}"),
        ("run -patchsize 5", f"-patchsize: two dashes here: --patch-size; {EBSYNTH}"),
        ("run -seed 5", "-seed: two dashes here: --seed"),
        ("run -extrapass3x3", f"there is no option -extrapass3x3; {EBSYNTH}"),
        ("replay --nff n.npy", "there is no option --nff; did you mean --nnf?"),
        ("oracle check --prot x", "there is no option --prot; did you mean --port?"),
    ],
)
def test_an_unknown_option_is_named_before_another_is_missed(capsys, command, said):
    program = "oracle check" if command.startswith("oracle") else command.split()[0]
    assert refusal(capsys, command) == f"stylit-ref {program}: {said}"


@pytest.mark.parametrize(
    ("command", "said"),
    [
        ("-style s.png", f"-style: name the command first: stylit-ref run --style; {EBSYNTH}"),
        ("--preset fast", "--preset: name the command first: stylit-ref run --preset"),
        ("--frobnicate", "there is no option --frobnicate"),
        ("rum --style s.png", "there is no command 'rum'; did you mean run?"),
        ("stylize", "there is no command 'stylize'"),
    ],
)
def test_without_a_command(capsys, command, said):
    assert refusal(capsys, command) == f"stylit-ref: {said}"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            "--guide a b c d --output o",
            "c: --guide takes SOURCE and TARGET; repeat --guide for each pair",
        ),
        (
            "--guide a b --output my picture.png",
            "picture.png: --output has its value already; put a name with spaces in quotes",
        ),
        ("x --guide a b --output o", "x: is neither an option nor the value of one"),
    ],
)
def test_words_that_are_left_over(capsys, words, said):
    assert refusal(capsys, f"run {words} --style s") == f"stylit-ref run: {said}"


def test_negative_numbers_and_names_with_spaces_are_values(capsys):
    command = ["run", "--style", "- a", "--guide", "a", "b", "--output", "o.png", "--seed", "-1"]
    assert main(command) == 2
    assert capsys.readouterr().err == "stylit-ref: - a: no such file\n"
