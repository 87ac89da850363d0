"""Reports on a tiny scene: what is written, and what is not computed twice."""

import sys

import numpy as np
import pandas as pd
import pytest
from small_scene import small_scene

import eval.runs
from eval.__main__ import main
from eval.bench import timed
from eval.scenes import BUNDLED, load_scene
from stylit_ref import InputError, Params, write_image


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A scene in files, far from the reports and results of the checkout."""
    monkeypatch.chdir(tmp_path)
    style, sources, targets = small_scene()
    (tmp_path / "small").mkdir()
    write_image(tmp_path / "small" / "source_style.png", style)
    for name, source, target in zip(("fullgi", "id"), sources, targets, strict=True):
        write_image(tmp_path / "small" / f"source_{name}.png", source)
        write_image(tmp_path / "small" / f"target_{name}.png", target)
    return tmp_path / "small"


def test_scene_is_read_by_names(folder):
    scene = load_scene(folder)
    assert scene.name == "small"
    assert scene.guide_names == ("fullgi", "id")
    assert scene.size == "44x38"
    assert load_scene(folder, step=2).size == "22x19"


def test_bundled_scene_is_complete():
    scene = load_scene(BUNDLED)
    assert scene.guide_names == ("dirdif", "dirspc", "fullgi", "indirb")
    assert scene.size == "400x304"


def test_lambda_report(folder, capsys):
    assert main(["lambda", "--scene", str(folder)]) == 0
    assert "| λ" in capsys.readouterr().out
    report = folder.parent / "reports" / "lambda_small_44x38"
    written = {file.name for file in report.iterdir()}
    images = {f"lambda_{value}.png" for value in (0, 5000, 10000, 15000)}
    assert written == images | {"lambda.csv", "lambda.png", "report.md", "report.html"}
    numbers = pd.read_csv(report / "lambda.csv")
    assert list(numbers["λ"]) == [0, 5000, 10000, 15000]
    assert (numbers["distinct"].diff().dropna() > 0).all()


def test_a_run_is_computed_once(folder, monkeypatch):
    scene = load_scene(folder)
    params = Params(levels=1, votes=1, patchmatch_iterations=1)
    first = eval.runs.run(scene, params, 0)

    def refuse(*arguments, **options):
        raise AssertionError("computed again")

    monkeypatch.setattr(eval.runs, "stylize", refuse)
    again = eval.runs.run(scene, params, 0)
    np.testing.assert_array_equal(first.image, again.image)
    assert first.seconds == again.seconds
    with pytest.raises(AssertionError, match="computed again"):
        eval.runs.run(scene, params, 1)
    with pytest.raises(AssertionError, match="computed again"):
        eval.runs.run(load_scene(folder, step=2), params, 0)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["lambda", "--scene", "none"], "none: no such folder"),
        (["lambda", "--scene", "."], "is no scene"),
        (["bench", "--scene", "small", "--ebsynth", "./none"], "./none: is no program"),
    ],
    ids=lambda value: value[0] if isinstance(value, list) else "",
)
def test_bad_input(folder, capsys, arguments, message):
    assert main(arguments) == 2
    error = capsys.readouterr().err.strip().splitlines()[-1]
    assert message in error


def test_timed_accounts_for_the_process_itself():
    cost = timed([sys.executable, "-c", "x = bytearray(200 << 20); sum(range(10**6))"])
    assert cost.mebibytes > 200
    assert 0 < cost.processor_seconds < 60
    with pytest.raises(InputError, match="failed with code 3: no"):
        timed([sys.executable, "-c", "print('no'); raise SystemExit(3)"])
