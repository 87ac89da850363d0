"""``stylit-ref run`` from end to end."""

import re
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from cli.calls import refused, run

from stylit_ref import Params, read_image, stylize
from stylit_ref.cli import main


def test_run_writes_what_stylize_returns(scene):
    folder, *arrays = scene
    code = run(
        folder, "--uniformity", 3000, "--seed", 5, "--nnf", folder / "nnf.npy",
        "--save-levels", folder / "levels", "--threads", 1,
    )  # fmt: skip
    assert code == 0
    params = Params(levels=2, votes=1, patchmatch_iterations=1, uniformity=3000)
    expected = stylize(*arrays, params, seed=5)
    np.testing.assert_array_equal(read_image(folder / "out.png"), expected.image)
    np.testing.assert_array_equal(np.load(folder / "nnf.npy"), expected.nnf)
    assert read_image(folder / "levels" / "level_1.png").shape == (19, 22, 3)
    np.testing.assert_array_equal(read_image(folder / "levels" / "level_2.png"), expected.image)
    assert not [file for file in folder.iterdir() if file.name.startswith(".")]


@pytest.mark.parametrize(
    ("flags", "values"),
    [
        (["--method", "guide_map", "--epsilon", 3.5], {"method": "guide_map", "epsilon": 3.5}),
        (
            ["--method", "stylit", "--budget", 0.9, "--fixed-share", 1, "--error-limit", 5],
            {"method": "stylit", "budget": 0.9, "fixed_share": 1.0, "error_limit": 5.0},
        ),
        (["--method", "stylit", "--budget", "hyperbola"], {"method": "stylit"}),
        (["--vote-outliers", 3], {"vote_outliers": 3}),
    ],
    ids=str,
)
def test_the_methods_of_the_python_interface(scene, flags, values):
    folder, *arrays = scene
    assert run(folder, *flags) == 0
    params = Params(**({"levels": 2, "votes": 1, "patchmatch_iterations": 1} | values))
    expected = stylize(*arrays, params)
    np.testing.assert_array_equal(read_image(folder / "out.png"), expected.image)


def test_profile_names_the_stages(scene, capsys):
    assert run(scene[0], "--profile", "--quiet") == 0
    lines = capsys.readouterr().err.strip().split("\n")
    assert re.match(r"stage +seconds +share +calls", lines[0])
    assert lines[-1].startswith("elsewhere ")
    stages = {re.match(r"(.+?) {2,}\d", line).group(1): line.split()[-1] for line in lines[1:]}
    assert stages["propagation"] == str(2 * 3)  # levels by distances
    assert stages["commit"] == str(2 * 4)
    assert {"reading images", "writing images", "vote", "random_search"} <= stages.keys()


def test_fewer_levels_are_noted_where_levels_were_asked_for(scene, capsys):
    folder, style, guide = scene[0], scene[0] / "style.png", scene[0] / "source_0.png"
    command = ["run", "--style", f"{style}", "--guide", f"{guide}", f"{guide}"]
    command += ["--preset", "fast", "--output", f"{folder / 'out.png'}"]
    assert main(command) == 0
    assert "note: " not in capsys.readouterr().err
    assert main([*command, "--pyramid-levels", "9"]) == 0
    assert "note: --pyramid-levels is 9, but 4 are used" in capsys.readouterr().err


def test_nothing_is_made_before_all_is_checked(scene, capsys):
    folder = scene[0]
    levels = folder / "new" / "levels"
    refused(capsys, run(folder, "--save-levels", levels, "--threads", 0))
    assert not levels.parent.exists()


@pytest.mark.slow
def test_interruption_leaves_nothing(scene):
    """Ctrl-C in the middle of the work: code 130, one sentence, no output.

    The signal comes when the first of two equally long levels is done.
    """
    folder = scene[0]
    command = [sys.executable, "-m", "stylit_ref.cli", "run", "--style", f"{folder}/style.png"]
    command += ["--output", f"{folder}/out.png", "--nnf", f"{folder}/nnf.npy", "--quiet"]
    command += ["--guide", f"{folder}/source_0.png", f"{folder}/target_0.png"]
    command += ["--save-levels", f"{folder}/levels", "--search-vote-iters", "300"]
    command += ["--pyramid-levels", "2"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    try:
        limit = time.monotonic() + 300
        while not (folder / "levels" / "level_1.png").exists():
            assert time.monotonic() < limit, "the first level takes too long"
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=120)
    finally:
        process.kill()
    # Where Ctrl-C strikes inside an exec, as when Numba makes a function of text, `python -m` ends
    # by the signal, though the exception was caught; to a shell that is 130 too.
    assert process.returncode in (130, -signal.SIGINT)
    assert errors.strip() == "stylit-ref: interrupted; no half-written file is left"
    assert not (folder / "out.png").exists()
    assert not (folder / "nnf.npy").exists()
    assert [file.name for file in (folder / "levels").iterdir()] == ["level_1.png"]
    assert not [file for file in folder.iterdir() if file.name.startswith(".")]
