"""Options of ``run`` that shape the result."""

from dataclasses import dataclass

import pytest
from cli.calls import refused, run

from stylit_ref import PRESETS, InputError, Params
from stylit_ref.cli import main, make_parser
from stylit_ref.cli.method_options import chosen_params
from stylit_ref.cli.methods import OFFERS, Offer
from stylit_ref.parameters import Integer, check_fields, parameter


@pytest.fixture
def seen(monkeypatch):
    """Parameters of the runs of ``ref`` and ``stylit``, each ended where its work would start."""
    seen = []

    def spy(style, source_guides, target_guides, params, **_):
        seen.append(params)
        raise InputError("enough")

    for method in ("ref", "stylit"):
        monkeypatch.setitem(OFFERS, method, OFFERS[method]._replace(run=spy))
    return seen


def test_every_method_flag_reaches_the_parameters(scene, seen):
    folder = scene[0]
    run(
        folder, "--patch-size", 3, "--pyramid-levels", 1, "--search-vote-iters", 2,
        "--patchmatch-iters", 3, "--uniformity", 7, "--guide-influence", 4,
        "--schedule", "scanline", "--weight", 0.5,
    )  # fmt: skip
    assert seen == [
        Params(
            patch_width=3,
            levels=1,
            votes=2,
            patchmatch_iterations=3,
            uniformity=7,
            guide_influence=4,
            guide_weights=(1.0, 0.5),
            schedule="scanline",
        )
    ]


def test_presets_fill_in_what_is_not_said(scene, seen):
    folder = scene[0]
    command = ["run", "--style", f"{folder / 'style.png'}", "--output", f"{folder / 'out.png'}"]
    command += ["--guide", f"{folder / 'source_0.png'}", f"{folder / 'target_0.png'}"]
    for more in (
        [],
        ["--preset", "thesis"],
        ["--preset", "thesis", "--pyramid-levels", "all"],
        ["--preset", "fast"],
        ["--preset", "fast", "--search-vote-iters", "3,9"],
        ["--preset", "architecture"],
        ["--preset", "architecture", "--error-limit", "7", "--method", "stylit"],
    ):
        assert main([*command, *more]) == 2
    assert seen == [
        Params(**PRESETS["final"], guide_weights=(1.0,)),
        Params(guide_weights=(1.0,)),
        Params(levels="all", guide_weights=(1.0,)),
        Params(**PRESETS["fast"], guide_weights=(1.0,)),
        Params(**(PRESETS["fast"] | {"votes": (3, 9)}), guide_weights=(1.0,)),
        Params(**PRESETS["architecture"], guide_weights=(1.0,)),
        Params(**(PRESETS["architecture"] | {"error_limit": 7.0}), guide_weights=(1.0,)),
    ]


@pytest.mark.parametrize(
    ("flags", "message"),
    [
        (["--epsilon", 5], "--epsilon is for --method guide_map; the method is ref"),
        (
            ["--method", "stylit", "--uniformity", 5],
            "--uniformity is for --method ref, guide_map; the method is stylit",
        ),
        (["--method", "guide_map", "--budget", 0.5], "--budget is for --method stylit"),
        (["--method", "magic"], "--method is 'magic'; it must be"),
        (
            ["--method", "ref", "--preset", "architecture"],
            "--preset is architecture, which is not for --method ref; that has final, fast, thesis",
        ),
        (
            ["--method", "stylit", "--budget", 0],
            "--budget is 0.0; it must be a number above 0 and up to 1, or 'hyperbola'",
        ),
        (
            ["--pyramid-levels", 17],
            "--pyramid-levels is 17; it must be an integer from 1 to 16, or 'all'",
        ),
        (["--method", "stylit", "--error-limit", 0.5], "--error-limit is 0.5"),
        (["--patch-size", 6], "--patch-size is 6; it must be an odd"),
        (["--seed", -1], "--seed is -1"),
        (["--save-levels", "/proc/levels"], "/proc/levels: cannot be written"),
        (["--save-levels", "x" * 300], "cannot be used: File name too long"),
        (["--method", "stylit", "--schedule", "scanline"], "--schedule is 'scanline'; it is for"),
        (["--backend", "cuda:live", "--method", "stylit"], "has no kernels for it; choose 'cpu'"),
    ],
    ids=str,
)
def test_flags_that_do_not_go_together(scene, capsys, flags, message):
    assert message in refused(capsys, run(scene[0], *flags))


@pytest.mark.parametrize(
    ("votes", "message"),
    [
        ("a", "--search-vote-iters: is 'a'; it must be an integer, or several with commas between"),
        ("1,", "--search-vote-iters: is '1,'; it must be an integer, or"),
        ("1,0", ": --search-vote-iters is 0;"),
    ],
)
def test_votes_that_are_no_counts(capsys, votes, message):
    command = ["run", "--style", "s", "--guide", "a", "b", "--output", "o"]
    try:
        code = main([*command, "--search-vote-iters", votes])
    except SystemExit as stop:
        code = stop.code
    assert code == 2
    said = capsys.readouterr().err.strip()
    assert message in said
    assert "\n" not in said


@pytest.mark.parametrize(
    ("flag", "message"),
    [
        ("--budget", "--budget: is 'much'; it must be hyperbola or a number"),
        ("--pyramid-levels", "--pyramid-levels: is 'much'; it must be all or an integer"),
    ],
)
def test_a_word_that_is_not_the_one_beside_numbers(capsys, flag, message):
    with pytest.raises(SystemExit) as stop:
        main(["run", "--style", "s", "--guide", "a", "b", "--output", "o", flag, "much"])
    assert stop.value.code == 2
    assert message in capsys.readouterr().err


def test_the_help_names_the_default_of_the_default_preset(capsys):
    with pytest.raises(SystemExit):
        main(["run", "--help"])
    said = " ".join(capsys.readouterr().out.split())
    assert "(levels in Python, default all)" in said
    assert "(votes in Python, default 6)" in said


@pytest.mark.usefixtures("nothing_written")
class TestRefusals:
    """One sentence, exit code 2, and no file."""

    def test_even_patch(self, scene, capsys):
        assert "odd" in refused(capsys, run(scene[0], "--patch-size", 4))

    def test_patch_larger_than_the_image(self, scene, capsys):
        message = refused(capsys, run(scene[0], "--patch-size", 41))
        assert "41" in message
        assert "46x40" in message


@dataclass(frozen=True)
class Sparse:
    """Parameters of a method that is not a stylization of the thesis."""

    grid: int = parameter(3, Integer(1, 9), "spacing of the grid")
    levels: int = parameter(4, Integer(1, 9), "levels")

    def __post_init__(self):
        check_fields(self)


def test_a_method_with_parameters_of_its_own(monkeypatch, capsys):
    offer = Offer("on a grid", Sparse, ("grid", "levels"), {"quick": {"grid": 2}}, (), None, None)
    monkeypatch.setitem(OFFERS, "sparse", offer)
    call = ["run", "--style", "s", "--guide", "a", "b", "--output", "o", "--method", "sparse"]
    parser = make_parser()
    options = parser.parse_args([*call, "--preset", "quick", "--pyramid-levels", "5"])
    assert chosen_params(options) == Sparse(grid=2, levels=5)
    assert main([*call, "--preset", "quick", "--uniformity", "5"]) == 2
    assert main([*call, "--preset", "final"]) == 2
    assert main([*call[:-1], "ref", "--grid", "5"]) == 2
    assert main([*call, "--preset", "quick", "--grid", "12"]) == 2
    assert capsys.readouterr().err.splitlines() == [
        "stylit-ref: --uniformity is for --method ref, guide_map; the method is sparse",
        "stylit-ref: --preset is final, which is not for --method sparse; that has quick",
        "stylit-ref: --grid is for --method sparse; the method is ref",
        "stylit-ref: --grid is 12; it must be an integer from 1 to 9",
    ]
