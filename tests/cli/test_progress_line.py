"""The line that shows how far a run is."""

import re

import numba
import pytest
from cli.calls import run

from stylit_ref.cli import main


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


def test_compilation_is_counted_and_no_part_of_the_run(scene, shown, tmp_path_factory, monkeypatch):
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path_factory.mktemp("kernels")))
    small = "--patch-size", 37, "--pyramid-levels", 1, "--schedule", "scanline"
    told = shown(scene[0], *small)
    compiling = [line for line in told if line.startswith("compiling")]
    counts = [re.match(r"compiling kernels (\d+) of (\d+), once \|", line) for line in compiling]
    numbers = [int(match[1]) for match in counts]
    (count,) = {int(match[2]) for match in counts}
    assert sorted(set(numbers)) == list(range(1, count + 1))
    first = next(line for line in told if "level 1 of 1" in line)
    assert told.index(first) > told.index(compiling[-1])
    assert "00:00<" in first


def test_quiet_says_nothing(scene, shown):
    assert shown(scene[0], "--quiet", "--nnf", scene[0] / "nnf.npy") == [""]


def test_all_files_are_named_at_the_end(scene, capfd):
    folder = scene[0]
    assert run(folder, "--nnf", folder / "n.npy", "--save-levels", folder / "levels") == 0
    said = capfd.readouterr().err
    assert f"out.png (44x38), {folder / 'n.npy'}, {folder / 'levels'} in " in said


def test_warm_up_says_what_it_compiled(capfd):
    command = ["warm-up", "--guide-channels", "1", "--style-channels", "1", "--patch-size", "3"]
    assert main(command) == 0
    assert re.fullmatch(r"compiled \d+ of 10 kernels in [\d.]+ s\n", capfd.readouterr().err)
    assert main(command) == 0
    assert capfd.readouterr().err.startswith("compiled 0 of 10 kernels in ")
