"""The thesis' tables and figures on tiny scenes: all exist, and no run is done twice."""

import json
import re

import numpy as np
import pandas as pd
import pytest
from small_scene import small_scene

import eval.runs.cluster
import eval.runs.complete
import eval.runs.local
import eval.runs.store
from eval.__main__ import main
from eval.documents.dzurenko import printed
from eval.documents.dzurenko.plan import preset
from eval.pages.claims import HELD, NOT_HELD, OPEN
from eval.runs.complete import complete
from eval.runs.store import run_file, stored
from stylit_ref import write_image

TARGETS = "hand", "teapot", "golem"
TINY = ["dzurenko", "--step", "6", "--seeds", "0", "--targets", ",".join(TARGETS)]
TINY += ["--output", "report"]


@pytest.fixture
def small_files(tmp_path):
    """A user's folder, and another painting."""
    style, sources, targets = small_scene()
    (tmp_path / "small").mkdir()
    write_image(tmp_path / "small" / "source_style.png", style)
    for name, source, target in zip(("fullgi", "id"), sources, targets, strict=True):
        write_image(tmp_path / "small" / f"source_{name}.png", source)
        write_image(tmp_path / "small" / f"target_{name}.png", target)
    write_image(tmp_path / "other.png", np.ascontiguousarray(style[::-1]))
    return tmp_path / "small", tmp_path / "other.png"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with the report on three targets, a sixth as wide as the bundled ones."""
    folder = tmp_path_factory.mktemp("thesis")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        assert main(TINY) == 0
    return folder


@pytest.mark.slow
def test_every_table_and_figure_is_there(folder):
    written = {file.name for file in (folder / "report").iterdir()}
    per_target = (
        "lambda_{}.webp", "epsilon_{}.webp", "lambda_times_{}.csv", "epsilon_times_{}.csv",
        "similarity_{}.csv", "quality_{}.csv",
    )  # fmt: skip
    expected = {name.format(target) for name in per_target for target in TARGETS}
    expected |= {"trends.webp", "energy.webp", "background.webp", "pyramid.webp"}
    expected |= {f"{pair}_{k}.webp" for pair in ("washed_out", "guide_maps") for k in (1, 2)}
    expected |= {"claims.csv", "errata.csv", "shared_memory.csv", "shared_memory_ptx.csv"}
    assert written == expected | {"report.md", "report.html", "report.json"}
    text = (folder / "report" / "report.md").read_text(encoding="utf-8")
    assert expected == set(re.findall(r"\(([a-z_0-9]+\.(?:webp|csv))\)", text))
    for number in map(list(printed.TARGETS).index, TARGETS):
        assert f"(4.{1 + number})" in text
        assert f"(5.{2 + number})" in text
    page = (folder / "report" / "report.html").read_text(encoding="utf-8")
    assert page.count("data:image/webp;base64,") == text.count("![")
    assert 'src="' not in page.replace('src="data:', "")


@pytest.mark.slow
def test_tables_have_published_and_own_numbers(folder):
    table = pd.read_csv(folder / "report" / "lambda_times_golem.csv").set_index("method")
    assert list(table.index) == ["StyLit", *(f"λ = {value}" for value in printed.UNIFORMITIES)]
    assert table.loc["λ = 10000", "published [s]"] == 122.495
    own = table["ours [s]"]
    np.testing.assert_allclose(table["ours StyLit/time"], own["StyLit"] / own)
    table = pd.read_csv(folder / "report" / "epsilon_times_hand.csv").set_index("method")
    assert table.loc["ε = 100", "published ref/time"] == 2.847
    assert not table.drop(columns="published ref/time").loc["ε = 100"].isna().any()
    claims = pd.read_csv(folder / "report" / "claims.csv")
    assert len(claims) == 14
    assert set(claims["verdict"]) <= {HELD, NOT_HELD, OPEN}
    quality = pd.read_csv(folder / "report" / "quality_golem.csv").set_index("method")
    assert (quality[["coverage", "entropy"]] <= 1).all(axis=None)
    assert quality["image_energy"].notna().sum() == 7


@pytest.mark.slow
def test_a_second_time_nothing_is_computed(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    monkeypatch.setattr(eval.runs.local, "compute", None)
    monkeypatch.setattr(eval.runs.local, "measure", None)
    before = (folder / "report" / "report.html").stat().st_mtime_ns
    assert main(TINY) == 0
    assert "is up to date" in capsys.readouterr().err
    assert (folder / "report" / "report.html").stat().st_mtime_ns == before


@pytest.mark.slow
def test_a_result_that_was_lost_or_damaged_is_computed_again_alone(folder, monkeypatch):
    monkeypatch.chdir(folder)
    plan = preset("quick", step=6, targets=TARGETS, seeds=[0])
    lost, damaged = plan.ref("hand", 5000), plan.guide_map("hand", 100)
    images = [stored(job).image for job in (lost, damaged)]
    run_file(lost).unlink()
    run_file(damaged).write_bytes(run_file(damaged).read_bytes()[:1000])
    assert stored(damaged) is None
    done = []
    compute = eval.runs.local.compute
    monkeypatch.setattr(
        eval.runs.local, "compute", lambda job, progress: done.append(job) or compute(job)
    )
    assert complete(plan.tasks) == {}
    assert [job.key for job in done] == [lost.key, damaged.key]
    for job, image in zip((lost, damaged), images, strict=True):
        np.testing.assert_array_equal(stored(job).image, image)


@pytest.mark.slow
def test_a_failing_run_is_named_and_the_others_are_kept(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    plan = preset("quick", step=7, targets=["hand"], seeds=[0])

    compute = eval.runs.local.compute

    def fail_once(job, progress):
        if job.method == plan.ref("hand", 5000).method:
            raise MemoryError("too little")
        return compute(job)

    monkeypatch.setattr(eval.runs.local, "compute", fail_once)
    arguments = [
        "dzurenko",
        "--step",
        "7",
        "--targets",
        "hand",
        "--seeds",
        "0",
        "--output",
        "failed",
    ]
    assert main(arguments) == 1
    said = capsys.readouterr().err
    assert "failed: hand_pen, ref, λ = 5000, seed 0: MemoryError: too little" in said
    assert not (folder / "failed").exists()
    assert sum(stored(job) is not None for job in plan.jobs) == len(plan.jobs) - 1


@pytest.mark.slow
def test_a_users_own_scene_has_no_published_numbers(folder, monkeypatch, small_files):
    monkeypatch.chdir(folder)
    own, style = small_files
    arguments = ["dzurenko", "--scene", str(own), "--style", str(style), "--seeds", "3"]
    assert main(arguments) == 0
    report = folder / "build" / "reports" / "small_other"
    table = pd.read_csv(report / "lambda_times_small_other.csv")
    assert list(table.columns) == ["method", "ours [s]", "ours StyLit/time"]


def test_errata_are_what_rounding_does_not_explain():
    found = printed.errata()
    assert found[["target", "row", "printed"]].to_numpy().tolist() == [
        ["teapot", "ref, lambda 0", 62.534]
    ]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--targets", "bunny"], "--targets names 'bunny', which is no target; choose from stego,"),
        (["--preset", "thesis", "--data", "nowhere"], "nowhere: does not exist; 'make data'"),
        (["--scene", "nowhere"], "nowhere: is neither a folder nor"),
    ],
)
def test_bad_arguments_are_one_sentence(arguments, said, capsys):
    assert main(["dzurenko", *arguments]) == 2
    assert said in capsys.readouterr().err


@pytest.mark.slow
def test_the_times_of_a_gpu_stand_beside_ours(folder, monkeypatch, tmp_path):
    monkeypatch.chdir(folder)
    settings = ["propose_commit, λ = 5000", "propose_commit, λ = 10000", "shared memory, λ = 10000"]
    record = {
        "scene": "hand/pen",
        "size": "50x38",
        "seconds": dict(zip(settings, (0.2, 0.3, 0.25), strict=True)),
        "identical to the CPU": dict.fromkeys(settings, True),
    }
    (tmp_path / "gpu").mkdir()
    (tmp_path / "gpu" / "GTX_660.json").write_text(json.dumps({"scenes": [record]}))
    monkeypatch.setattr("eval.pages.gpu_records.COMMITTED", tmp_path)
    assert main([*TINY[:-1], "with_gpu", "--targets", "hand"]) == 0
    table = pd.read_csv(folder / "with_gpu" / "lambda_times_hand.csv").set_index("method")
    assert table.loc["λ = 5000", "GTX_660 [s]"] == 0.2
    shared = pd.read_csv(folder / "with_gpu" / "shared_memory.csv")
    np.testing.assert_allclose(shared["GTX_660 ref/shared"], 1.2)
    claims = pd.read_csv(folder / "with_gpu" / "claims.csv").set_index("section")
    assert claims.loc["5.1.3", "verdict"] == HELD
