"""Signals during the work: nothing is left half-written, and the work can be resumed."""

import signal
from contextlib import suppress

import pytest
from hostile.command_line import check
from hostile.programs import done, started, wait_for
from small_scene import small_scene

from data_gen.manifest import Manifest
from data_gen.renderer import MissingRendererError, start
from eval.documents.dzurenko.plan import preset
from eval.runs.local import compute, run
from eval.runs.store import numbers_of, read, run_file, store, store_numbers, stored
from stylit_ref import read_image, write_image

INTERRUPTED = "interrupted; no half-written file is left"
SHORT, LONG = ("--search-vote-iters", "1"), ("--search-vote-iters", "300")
THESIS = [
    "eval", "dzurenko", "--step", "7", "--targets", "hand", "--seeds", "0", "--output", "report",
]  # fmt: skip
DATA = ["data_gen", "--size", "60x46", "--samples", "4", "--scenes", "teapot", "--folder", "set"]


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scene")
    style, sources, targets = small_scene()
    write_image(folder / "style.png", style)
    for k in range(2):
        write_image(folder / f"source_{k}.png", sources[k])
        write_image(folder / f"target_{k}.png", targets[k])
    return folder


def command(scene, *more):
    guides = [["--guide", scene / f"source_{k}.png", scene / f"target_{k}.png"] for k in range(2)]
    return [
        "stylit_ref.cli", "run", "--style", scene / "style.png", "--output", "out.png",
        "--nnf", "nnf.npy", *guides[0], *guides[1], "--pyramid-levels", "2", "--quiet", *more,
    ]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("which", ["SIGINT", "SIGTERM", "SIGKILL"])
def test_run_is_stopped(scene, tmp_path, which):
    """Saved files are complete, no other file is left, and the next run makes its output."""
    call = command(scene, *LONG, "--save-levels", "levels")
    with started(*call, folder=tmp_path) as process:
        wait_for((tmp_path / "levels" / "level_1.png").exists, process)
        process.send_signal(getattr(signal, which))
        code, said = done(process)
    if which == "SIGKILL":
        assert code == -signal.SIGKILL
    else:
        check(code, said, INTERRUPTED, 130)
    assert [path.name for path in tmp_path.iterdir()] == ["levels"]
    assert [path.name for path in (tmp_path / "levels").iterdir()] == ["level_1.png"]
    assert read_image(tmp_path / "levels" / "level_1.png").shape == (19, 22, 3)
    if which == "SIGKILL":
        with started(*command(scene, *SHORT), folder=tmp_path) as process:
            assert done(process)[0] == 0
        assert read_image(tmp_path / "out.png").shape == (38, 44, 3)


@pytest.mark.slow
@pytest.mark.parametrize("which", ["SIGINT", "SIGTERM"])
@pytest.mark.parametrize("kernels", [1, 3])
def test_run_is_stopped_while_it_compiles(scene, tmp_path, which, kernels):
    """A signal during a callback of the compiler is not lost and causes no crash."""
    cache = tmp_path / "kernels"
    call = command(scene, *LONG)
    with started(*call, folder=tmp_path, NUMBA_CACHE_DIR=str(cache)) as process:
        wait_for(lambda: len(list(cache.rglob("*.nbi"))) >= kernels, process)
        process.send_signal(getattr(signal, which))
        check(*done(process), INTERRUPTED, 130)
    assert [path.name for path in tmp_path.iterdir()] == ["kernels"]


@pytest.mark.slow
def test_eval_goes_on(tmp_path):
    """Finished runs are kept and not computed again; an unfinished report is not kept."""
    report = tmp_path / "report"

    def results():
        found = {file: file.read_bytes() for file in (tmp_path / "build/runs").glob("[!.]*")}
        assert all(map(read, found))
        return found

    for which in (signal.SIGKILL, signal.SIGTERM):
        before = results()
        with started(*THESIS, folder=tmp_path) as process:
            wait_for(lambda before=before: len(results()) > len(before), process)
            process.send_signal(which)
            code, said = done(process)
        if which == signal.SIGKILL:
            assert code == -signal.SIGKILL
        else:
            sentence = "interrupted; finished runs are kept and not computed again"
            check(code, said, sentence, 130)
        assert not report.exists()
        assert before.items() <= results().items()
    with started(*THESIS, folder=tmp_path) as process:
        assert done(process)[0] == 0
    assert before.items() <= results().items()

    written = {file.name: file.read_bytes() for file in report.iterdir()}
    del written["report.json"]
    (report / "report.json").unlink()
    (report / ".partial_1").mkdir()  # as SIGKILL leaves it
    with started(*THESIS, folder=tmp_path, largest_file=5000) as process:
        check(*done(process), "…ile too large…")
    assert {file.name: file.read_bytes() for file in report.iterdir()} == written


def made_anew(path, before):
    """Whether the file exists and is not the one that a killed process left."""
    with suppress(FileNotFoundError):
        found = path.stat()
        return before is None or found.st_mtime_ns != before.st_mtime_ns
    return False


@pytest.mark.slow
def test_data_goes_on(tmp_path):
    """Finished pieces are kept and not made again."""
    try:
        start()
    except MissingRendererError as error:
        pytest.skip(str(error))
    folder, killed = tmp_path / "set", None
    for which in (signal.SIGKILL, signal.SIGTERM):
        with started(*DATA, folder=tmp_path) as process:
            wait_for(lambda old=killed: made_anew(folder / "partial", old), process)
            process.send_signal(which)
            code, said = done(process)
        if which == signal.SIGKILL:
            assert code == -signal.SIGKILL
            killed = (folder / "partial").stat()
        else:
            check(code, said, "interrupted; finished pieces are kept", 130)
            assert not (folder / "partial").exists()
        manifest = Manifest.read(folder)
        assert all(map(manifest.complete, manifest.pieces))
    with started(*DATA, folder=tmp_path) as process:
        assert done(process)[0] == 0
    assert sorted(Manifest.read(folder).pieces) == ["source", "teapot"]
    assert {path.name for path in folder.iterdir()} == {"manifest.json", "source", "teapot"}


def test_results_of_another_run_are_not_taken(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    plan = preset("quick", step=7, targets=["hand"], seeds=[0])
    job, other = plan.ref("hand", 5000), plan.ref("hand", 10000)
    store(job, compute(job))
    store_numbers(job, {"usage": {"coverage": 0.5}})
    assert stored(job) is not None
    assert numbers_of(job) == {"coverage": 0.5}
    run_file(other).write_bytes(run_file(job).read_bytes())
    (numbers,) = (tmp_path / "build" / "measures").iterdir()
    numbers.with_name(f"{other.file_name}.json").write_bytes(numbers.read_bytes())
    assert stored(other) is None
    assert numbers_of(other) == {}
    assert run(other).key == other.key
    for content in ("[]", "{}", "null", '{"run": 3}', "\\0"):
        numbers.write_text(content)
        assert numbers_of(job) == {}
