"""The line that shows how far a run is."""

import re
import sys
import threading

import numba
import numpy as np
import pytest
from cli.calls import run

from stylit_ref.cli import main
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.machine.kernel import kernel, rehearsal
from stylit_ref.stylization.problem import make_synthesis


@pytest.fixture
def shown(monkeypatch, capfd):
    """Call ``run`` in a terminal; returns what it has shown, each state of a line."""

    def call(*arguments):
        monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
        assert run(*arguments) == 0
        return re.split(r"[\r\n]+", capfd.readouterr().err.strip())

    return call


def test_progress_is_told_in_words(scene, shown):
    *_, last, wrote = shown(scene[0])
    assert re.fullmatch(r"100% \|.+\| [\d:<]+  level 2 of 2 \(44x38\), round 1 *", last)
    assert re.fullmatch(r"wrote .*out\.png \(44x38\) in \d+\.\d s", wrote)


def test_verbose_tells_the_energy(scene, shown):
    last = shown(scene[0], "--verbose")[-2]
    assert re.search(r"100%.*level 2 of 2 .*, round 1  φ \d+ = δ \d+ \+ λρ \d+", last)


def test_stylit_tells_what_is_placed(scene, shown):
    last = shown(scene[0], "--method", "stylit", "--verbose")[-2]
    pattern = r"100%.*level 2 of 2 .*, round 1, \d+% placed  δ \d+  retrieval \d+"
    assert re.search(pattern, last)


def test_a_bar_begins_no_thread_beside_which_nothing_forks(monkeypatch):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    before = threading.active_count()
    with ProgressLine(quiet=False) as line:
        line.look(0, 2)
        assert threading.active_count() == before


@pytest.fixture
def needed(monkeypatch):
    """Have a run need some kernels that nobody has compiled, and call the first."""

    def need(count):
        def made(number):
            @kernel(number, parallel=False)
            def store(array):
                array[0] = number

            return store

        kernels = [made(number) for number in range(count)]
        with rehearsal() as found:
            for each in kernels:
                each(np.zeros(1))

        def make(*arguments, **named):
            kernels[0](np.zeros(1))
            return make_synthesis(*arguments, **named)

        module = sys.modules["stylit_ref.stylization.stylize"]
        monkeypatch.setattr(module, "make_synthesis", make)
        monkeypatch.setattr(module, "kernels_of_run", lambda *_: found)

    return need


@pytest.mark.parametrize("count", [1, 3])
def test_compilation_is_counted_and_no_part_of_the_run(
    scene, shown, needed, tmp_path, monkeypatch, count
):
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path / "kernels"))
    needed(count)
    told = shown(scene[0])
    compiling = [line for line in told if line.startswith("compiling")]
    numbers = [
        int(re.match(rf"compiling kernels (\d+) of {count}, once \|", line)[1])
        for line in compiling
    ]
    assert numbers == sorted(numbers)  # other processes compile those that are left out
    assert numbers[0] == 1
    assert numbers[-1] <= count
    running = [line for line in told if "level" in line]
    assert told.index(running[0]) > told.index(compiling[-1])
    assert re.match(r" *\d+% \|.*\| 00:00<", running[0])
    assert running[-1].startswith("100%")


def test_a_run_goes_on_after_a_compilation(monkeypatch, capfd):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    with ProgressLine(quiet=False) as line:
        line.tell(0.5, "half")
        line.compiling(1, 1)
        line.tell(1.0, "whole")
    told = re.split(r"[\r\n]+", capfd.readouterr().err.strip())
    assert re.match(r"100% \|.+whole", told[-1])


def test_nothing_is_shown_before_there_is_something_to_tell(scene, shown):
    """So notes and refusals have their line, and the estimate knows of the run alone."""
    first = shown(scene[0], "--threads", "100000")[0]
    assert first.startswith("note: --threads is 100000, but ")


def test_quiet_says_nothing(scene, shown):
    options = "--quiet", "--threads", "100000", "--nnf", scene[0] / "nnf.npy"
    assert shown(scene[0], *options) == [""]


def test_all_files_are_named_at_the_end(scene, capfd):
    folder = scene[0]
    assert run(folder, "--nnf", folder / "n.npy", "--save-levels", folder / "levels") == 0
    said = capfd.readouterr().err
    assert f"out.png (44x38), {folder / 'n.npy'}, {folder / 'levels'} in " in said


def test_warm_up_says_what_it_compiled(capfd):
    command = ["warm-up", "--only", "run", "--guide-channels", "1", "--style-channels", "1"]
    command += ["--patch-size", "3"]
    assert main(command) == 0
    compiling = r"(compiling (a kernel|\d+ kernels), once\n)?"
    pattern = compiling + r"compiled \d+ of 13 kernels in [\d.]+ s\n"
    assert re.fullmatch(pattern, capfd.readouterr().err)
    assert main(command) == 0
    assert capfd.readouterr().err.startswith("compiled 0 of 13 kernels in ")


def test_warm_up_compiles_textures_too(monkeypatch):
    compiled = []
    monkeypatch.setattr(
        "stylit_ref.cli.warm_up.compile_missing", lambda kernels, _: compiled.extend(kernels) or 0
    )
    counts, textures = {}, {"_iterate", "_guide_costs", "_fit_dragged", "_write_dragged"}
    for only, found in (("run", set()), ("texture", textures), (None, textures)):
        compiled.clear()
        assert main(["warm-up", *(["--only", only] if only else [])]) == 0
        assert {each.dispatcher.__name__ for each in compiled} & textures == found
        counts[only] = len(compiled)
    assert counts[None] == counts["run"] + counts["texture"]


@pytest.mark.parametrize(("count", "told"), [(1, "a kernel"), (3, "3 kernels")])
def test_compilation_is_told_without_a_terminal(capfd, count, told):
    with ProgressLine(quiet=False) as line:
        for number in range(1, count + 1):
            line.compiling(number, count)
    assert capfd.readouterr().err == f"compiling {told}, once\n"


def test_it_asks_for_kernels_only_when_one_is_missing(capfd):
    with ProgressLine(quiet=True) as line:
        line.compile(lambda: pytest.fail("was asked"))
    assert capfd.readouterr().err == ""
