"""What the parser refuses, and how it names what was meant."""

import pytest

from stylit_ref.cli import main
from stylit_ref.cli.parser import EBSYNTH_PAGE


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
        ("run --levels 5", "--levels: did you mean --pyramid-levels?"),
        ("run --lambda 5000", "--lambda: did you mean --uniformity?"),
        ("run --guide-weights 5", "--guide-weights: did you mean --weight?"),
        ("run --quiet --style s -x.png", "there is no option -x.png"),
        ("run --guide a -b.png", "--guide -b.png: a name cannot begin with a dash; write ./-b.png"),
        ("example -scenes", "-scenes: a name cannot begin with a dash; write ./-scenes"),
        ("run -style s.png", f"-style: two dashes here: --style; {EBSYNTH_PAGE}"),
        ("run -patchsize 5", f"-patchsize: two dashes here: --patch-size; {EBSYNTH_PAGE}"),
        ("run -seed 5", "-seed: two dashes here: --seed"),
        ("run -extrapass3x3", f"there is no option -extrapass3x3; {EBSYNTH_PAGE}"),
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
        ("-style s.png", f"-style: name the command first: stylit-ref run --style; {EBSYNTH_PAGE}"),
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
            "--guide a b c d",
            "c: --guide takes SOURCE and TARGET; repeat --guide for each pair",
        ),
        ("--output a a", "a: --output has its value already; put a name with spaces in quotes"),
        ("--quiet extra", "extra: is neither an option nor the value of one"),
        (
            "--guide a b --output my picture.png",
            "picture.png: --output has its value already; put a name with spaces in quotes",
        ),
        ("--guide a b x", "x: --guide takes SOURCE and TARGET; repeat --guide for each pair"),
    ],
)
def test_words_that_are_left_over(capsys, words, said):
    assert refusal(capsys, f"run --style a {words}") == f"stylit-ref run: {said}"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("--guide s.exr f.1.exr f.2.exr", "f.2.exr: --guide takes one name for all frames; write"),
        ("--motion f.1.exr f.2.exr", "f.2.exr: --motion takes one name for all frames; write %04d"),
        ("--work my folder", "folder: --work has its value already; put a name with spaces in"),
    ],
)
def test_names_that_a_shell_has_made_of_a_star(capsys, words, said):
    assert refusal(capsys, f"sequence {words}").startswith(f"stylit-ref sequence: {said}")


def test_words_after_two_dashes(capsys):
    said = refusal(capsys, "example a -- b")
    assert said == "stylit-ref: unrecognized arguments: b"


def test_a_choice_that_is_none(capsys):
    said = refusal(capsys, "run --style a --preset slow")
    assert said.startswith("stylit-ref run: --preset: is 'slow'; it must be final, fast,")
    said = refusal(capsys, "run --style a --preset fats")
    assert said.endswith("; did you mean fast?")


def test_negative_numbers_and_names_with_spaces_are_values(capsys):
    command = ["run", "--style", "- a", "--guide", "a", "b", "--output", "o.png", "--seed", "-1"]
    command += ["--uniformity", "-5.5"]
    assert main(command) == 2
    assert capsys.readouterr().err.startswith("stylit-ref: --uniformity is -5.5; it must be")
    assert main(command[:-2]) == 2
    assert capsys.readouterr().err == "stylit-ref: - a: no such file\n"
