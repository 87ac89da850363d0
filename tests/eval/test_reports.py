"""Reports on a tiny scene: what is written, and what is not computed twice."""

import re
import shutil
import sys

import numpy as np
import pandas as pd
import pytest
from small_scene import small_scene

import eval.runs
from data_gen.manifest import Manifest
from data_gen.models import TARGETS
from eval.__main__ import main
from eval.bench import THESIS, timed
from eval.scenes import BUNDLED, load_scene
from eval.schedules_report import schedule_ratios
from stylit_ref import InputError, Params, read_uint8, write_image


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


def test_a_guide_without_its_partner_is_named(folder):
    (folder / "target_id.png").unlink()
    with pytest.raises(InputError, match="the guide 'id' lacks its target_id image"):
        load_scene(folder)


@pytest.mark.parametrize("target", [*TARGETS, "house/source"])
def test_bundled_scenes_are_complete(target):
    for style in ("crayon", "oil", "pen", "watercolour"):
        scene = load_scene(f"{target}/{style}")
        assert scene.name == f"{target.replace('/', '_')}_{style}"
        assert scene.guide_names == ("FULL", "LDE", "LSE", "LDDE", "LD12E")
        assert scene.size == "300x228"
        assert scene.style.shape == scene.shown_guide.shape == (228, 300, 3)


def test_bundled_data_is_whole():
    manifest = Manifest.read(BUNDLED)
    assert set(TARGETS) < set(manifest.targets)
    assert all(manifest.complete(piece) for piece in manifest.pieces)
    motions = [file for file in manifest.pieces["house/motion"] if file.endswith(".exr")]
    assert len(motions) == 24
    assert sum(piece.startswith("house/") for piece in manifest.pieces) == 11


def test_a_scene_that_is_not_there_is_named():
    with pytest.raises(InputError, match=r"bunny/oil: is neither a folder nor TARGET/STYLE of"):
        load_scene("bunny/oil")


def test_a_damaged_data_set_is_refused(tmp_path):
    data = tmp_path / "data"
    shutil.copytree(BUNDLED, data, ignore=shutil.ignore_patterns("house"))
    (data / "golem" / "LDE.png").write_bytes((data / "golem" / "FULL.png").read_bytes())
    with pytest.raises(InputError, match=r"LDE\.png: differs from what manifest\.json says"):
        load_scene("golem/oil", data)
    assert load_scene("teapot/oil", data).size == "300x228"


@pytest.fixture
def data(tmp_path, monkeypatch):
    """A data set of one target, a sixth as wide as the bundled one."""
    monkeypatch.chdir(tmp_path)
    data = tmp_path / "small"
    manifest = Manifest.open(data)
    manifest.restart(Manifest.read(BUNDLED).recipe)
    for piece in ("source", "teapot"):
        for file in Manifest.read(BUNDLED).pieces[piece]:
            image = read_uint8(BUNDLED / file)[::6, ::6]
            (data / file).parent.mkdir(parents=True, exist_ok=True)
            write_image(data / file, np.ascontiguousarray(image))
        manifest.add(piece)
    return data


@pytest.mark.slow
def test_scenes_report(data, tmp_path):
    assert main(["scenes", "--data", str(data)]) == 0
    report = tmp_path / "reports" / "scenes_small"
    assert {file.name for file in report.iterdir()} == {
        "passes.png", "styles.png", "stylized.png", "scenes.csv", "report.md", "report.html",
    }  # fmt: skip
    assert len(pd.read_csv(report / "scenes.csv")) == 4


@pytest.mark.slow
def test_epsilon_report(folder, monkeypatch):
    monkeypatch.setattr("eval.epsilon_report.EPSILONS", (100, 10000))
    monkeypatch.setattr("eval.epsilon_report.MAPS_SHOWN", (100,))
    assert main(["epsilon", "--scene", str(folder)]) == 0
    report = folder.parent / "reports" / "epsilon_small_44x38"
    numbers = pd.read_csv(report / "epsilon.csv").set_index("method")
    assert list(numbers.index) == [
        "ref", "ref, another seed", "ε = 0", "ε = 0.001", "ε = 100", "ε = 10000", "ε = 50000",
    ]  # fmt: skip
    assert numbers.loc["ε = 0", "SSIM"] == 1
    assert np.isinf(numbers.loc["ε = 0", "PSNR"])
    assert numbers["white"].dropna().tolist()[::4] == ["0.0%", "100.0%"]
    costs = pd.read_csv(report / "costs.csv")
    assert costs["method"].tolist()[0] == "ref"
    assert (costs[["with the bound", "without"]] > 0).all(axis=None)
    assert "byte for byte" in (report / "report.md").read_text(encoding="utf-8")
    assert (report / "epsilon.png").exists()


@pytest.mark.slow
def test_stylit_report(folder):
    assert main(["stylit", "--scene", str(folder), "--numbers"]) == 0
    report = folder.parent / "reports" / "stylit_small_44x38"
    numbers = pd.read_csv(report / "stylit.csv").set_index("method")
    assert numbers.loc["StyLit", "distinct"] > numbers.loc["ref, λ = 0", "distinct"]
    page = (report / "report.md").read_text(encoding="utf-8")
    assert re.search(r"\| 3 +\|( \d+ \(\d+\.\d%\) +\|){6}", page)
    assert not (report / "stylit.png").exists()


@pytest.mark.slow
def test_spilling_report(data, tmp_path):
    assert main(["spilling", "--data", str(data), "--scene", "teapot/oil,teapot/pen"]) == 0
    report = tmp_path / "reports" / "spilling_small"
    numbers = pd.read_csv(report / "spilling.csv")
    spilled = numbers.drop(columns="scene").map(lambda text: float(text[:-1]))
    assert (spilled["ref with the ID guide"] < spilled["ref"]).all()
    assert spilled.shape == (2, 4)
    assert (report / "spilling.png").exists()


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


@pytest.mark.slow
def test_schedules_report(folder):
    arguments = ["--uniformities", "0", "50000", "--seeds", "0", "1"]
    assert main(["schedules", "--scene", str(folder), *arguments]) == 0
    report = folder.parent / "reports" / "schedules_small_44x38"
    numbers = pd.read_csv(report / "schedules.csv")
    assert list(numbers["λ"]) == [0, 0, 50000, 50000]
    assert list(numbers["schedule"]) == ["scanline", "propose_commit"] * 2
    assert (report / "schedules.png").exists()


def test_ratios_judge_each_bar():
    columns = ["phi", "delta", "image_energy", "distinct", "distinct_in_image"]
    columns += ["sharpness", "richness"]
    rows = []
    for uniformity, phi, distinct in (("0", 1.019, 1.0), ("1", 1.021, 1.1), ("2", 0.9, 0.99)):
        rows.append({"λ": uniformity, "schedule": "scanline"} | dict.fromkeys(columns, 1.0))
        rows.append({**rows[-1], "schedule": "propose_commit", "phi": phi, "distinct": distinct})
    ratios = schedule_ratios(pd.DataFrame(rows))
    assert list(ratios["φ, δ within"]) == ["yes", "no", "yes"]
    assert list(ratios["usage, sharpness kept"]) == ["yes", "yes", "no"]


@pytest.mark.slow
def test_bench_measures_both_programs_alike(folder, capsys, monkeypatch):
    """With a program that copies the style in place of ebsynth."""
    monkeypatch.setattr("eval.bench.THESIS", {**THESIS, "levels": 1, "votes": 1})
    monkeypatch.setattr("eval.bench.EBSYNTH_DEFAULTS", {**THESIS, "levels": 1, "votes": 1})
    monkeypatch.setattr("eval.bench.SCALES", (1, 2))
    program = folder.parent / "program"
    program.write_text(
        f"#!{sys.executable}\n"
        "import sys\n"
        "from stylit_ref import read_image, write_image\n"
        "from pathlib import Path\n"
        "options = sys.argv\n"
        "Path('arguments.txt').write_text(' '.join(options))\n"
        "image = read_image(options[options.index('-style') + 1])\n"
        "write_image(options[options.index('-output') + 1], image[:38, :44])\n"
    )
    program.chmod(0o755)
    assert main(["bench", "--scene", str(folder), "--ebsynth", str(program)]) == 0
    arguments = (folder.parent / "arguments.txt").read_text()
    assert re.search(r"-guide \S+source_fullgi.png \S+target_fullgi.png -weight 1.5 ", arguments)
    assert re.search(r"source_id.png \S+target_id.png -weight 0.5 -uniformity 10000", arguments)
    assert "-pyramidlevels 1 -searchvoteiters 1 -patchmatchiters 6" in arguments
    numbers = pd.read_csv(folder.parent / "reports" / "bench_small_44x38" / "bench.csv")
    assert list(numbers["program"]) == ["stylit-ref"] + ["stylit-ref", "ebsynth"] * 2
    printed = capsys.readouterr().out
    assert "one thread takes" in printed
    assert "preset fast: ebsynth (ebsynth's defaults) takes" in printed
    assert re.search(r"compilation: the first process on a machine takes \d", printed)
    assert "44x38" in printed
    assert "88x76" in printed


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["stylit", "--scene", "none"], "none: is neither a folder nor TARGET/STYLE of"),
        (["stylit", "--scene", "."], "is no scene"),
        (["stylit", "--scene", "small", "--step", "0"], "step is 0"),
        (["spilling", "--scene", "small"], "small: is no scene of a data set"),
        (["bench", "--scene", "small", "--ebsynth", "./none"], "./none: is no program"),
    ],
    ids=lambda value: value[0] if isinstance(value, list) else "",
)
def test_bad_input(folder, capsys, arguments, message):
    assert main(arguments) == 2
    error = capsys.readouterr().err.strip().splitlines()[-1]
    assert message in error


def test_timed_accounts_for_the_process_itself():
    held_here = bytearray(200 << 20)
    small = timed([sys.executable, "-S", "-c", "sum(range(10**6))"])
    assert small.mebibytes < 100
    assert 0 < small.processor_seconds < 60
    large = timed([sys.executable, "-S", "-c", "x = bytearray(200 << 20)"])
    assert large.mebibytes > len(held_here) / 2**20
    with pytest.raises(InputError, match="failed with code 3: no"):
        timed([sys.executable, "-c", "print('no'); raise SystemExit(3)"])
