"""A full disk, and signals in the middle of the work: nothing half-written, and it goes on."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from contextlib import contextmanager, suppress
from pathlib import Path

import numpy as np
import pytest
from hostile.listed import Listed
from small_scene import small_scene

from data_gen.manifest import Manifest
from data_gen.renderer import MissingRendererError, start
from eval.documents.dzurenko.plan import preset
from eval.runs.local import compute, run
from eval.runs.store import numbers_of, read, run_file, store, store_numbers, stored
from stylit_ref import read_image, write_image

CHECKOUT = Path(__file__).parents[2]
THESIS = [
    "eval",
    "dzurenko",
    "--step",
    "7",
    "--targets",
    "hand",
    "--seeds",
    "0",
    "--output",
    "report",
]
DATA = ["data_gen", "--size", "60x46", "--samples", "4", "--scenes", "teapot", "--folder", "set"]

RUN_FULL = Listed(
    "`run` on a full disk", "…: cannot be written: it may need … MiB and … MiB are free"
)
RUN_STOPPED = Listed(
    "Ctrl-C or SIGTERM in the middle of `run`", "interrupted; no half-written file is left", 130
)
RUN_COMPILING = Listed(
    "Ctrl-C or SIGTERM while `run` compiles its kernels",
    "interrupted; no half-written file is left",
    130,
)
RUN_KILLED = Listed(
    "SIGKILL in the middle of `run`, then `run` again", "no output; the second run makes it", 0
)
DAMAGED_KERNELS = Listed("damaged files of compiled kernels", "compiled and kept anew", 0)
FULL_FOR_KERNELS = Listed("no room for compiled kernels", "compiled by every process", 0)
EXAMPLE_FULL = Listed(
    "`example` on a full disk", "new/scenes: cannot be written: No space left on device"
)
EVAL_FULL = Listed(
    "`make eval` on a full disk",
    "build/runs/…: cannot be written: it may need … MiB and … MiB are free",
)
REPORT_FULL = Listed(
    "`make eval` on a disk that is full when it writes the report", "…o space left on device…"
)
EVAL_STOPPED = Listed(
    "Ctrl-C or SIGTERM in the middle of `make eval`",
    "interrupted; finished runs are kept and not computed again",
    130,
)
EVAL_AGAIN = Listed(
    "`make eval` again, after a full disk, Ctrl-C, SIGTERM and SIGKILL",
    "it completes; no finished run is computed again",
    0,
)
FOREIGN_RUN = Listed(
    "`make eval` with a stored result of another run under a run's name", "computed again", 0
)
DATA_FULL = Listed("`make data` on a full disk", "…o space left on device…")
DATA_STOPPED = Listed(
    "Ctrl-C or SIGTERM in the middle of `make data`", "interrupted; finished pieces are kept", 130
)
DATA_AGAIN = Listed(
    "`make data` again, after a full disk, Ctrl-C, SIGTERM and SIGKILL",
    "it completes; no finished piece is made again",
    0,
)
CASES = [value for value in globals().values() if isinstance(value, Listed)]


@pytest.fixture
def small_disk(tmp_path):
    """A disk of 64 KiB, and a call that gives it another size."""
    disk = tmp_path / "disk"
    disk.mkdir()

    def mount(*options):
        call = ["mount", "-t", "tmpfs", "-o", ",".join(options), "tmpfs", str(disk)]
        return subprocess.run(call, capture_output=True).returncode == 0

    if os.geteuid() or not shutil.which("mount") or not mount("size=64k"):
        pytest.skip("a small disk can be mounted by root alone")
    yield disk, lambda size="256m": mount("remount", f"size={size}")
    subprocess.run(["umount", str(disk)], check=True)


@contextmanager
def started(module, *arguments, folder, **environment):
    """A program of the checkout at work in a folder."""
    environment = os.environ | {"PYTHONPATH": str(CHECKOUT)} | environment
    call = [sys.executable, "-m", module, *map(str, arguments)]
    process = subprocess.Popen(
        call, cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def contents(folder):
    """Every file's bytes by name."""
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def done(process):
    """Exit code, as a shell has it, and stderr.

    Where Ctrl-C strikes inside an exec, as when Numba makes a function of text, ``python -m`` ends
    by the signal, though the exception was caught.
    """
    _, said = process.communicate(timeout=500)
    code = process.returncode
    return 130 if code == -signal.SIGINT else code, said


def wait_for(condition, process):
    limit = time.monotonic() + 300
    while not condition():
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < limit
        time.sleep(0.01)


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scene")
    style, sources, targets = small_scene()
    write_image(folder / "style.png", style)
    for k in range(2):
        write_image(folder / f"source_{k}.png", sources[k])
        write_image(folder / f"target_{k}.png", targets[k])
    return folder


def command(files, folder, *more):
    guides = [["--guide", files / f"source_{k}.png", files / f"target_{k}.png"] for k in range(2)]
    return [
        "stylit_ref.cli", "run", "--style", files / "style.png", "--output", folder / "out.png",
        "--nnf", folder / "nnf.npy", *guides[0], *guides[1], "--pyramid-levels", "2", "--quiet",
        *more,
    ]  # fmt: skip


SHORT, LONG = ("--search-vote-iters", "1"), ("--search-vote-iters", "300")


def test_run_on_a_full_disk(files, small_disk):
    disk, enlarge = small_disk
    with started(*command(files, disk, *SHORT), folder=disk) as process:
        RUN_FULL.check(*done(process), disk)
    assert not list(disk.iterdir())
    enlarge()
    with started(*command(files, disk, *SHORT), folder=disk) as process:
        assert done(process)[0] == 0


def test_example_on_a_full_disk(small_disk):
    disk, enlarge = small_disk
    example = "stylit_ref.cli", "example", disk / "new" / "scenes"
    with started(*example, folder=disk) as process:
        EXAMPLE_FULL.check(*done(process), disk)
    assert not list(disk.iterdir())
    enlarge()
    with started(*example, folder=disk) as process:
        assert done(process)[0] == 0


@pytest.mark.parametrize("which", ["SIGINT", "SIGTERM", "SIGKILL"])
def test_run_is_stopped(files, tmp_path, which):
    levels = ["--save-levels", tmp_path / "levels"]
    with started(*command(files, tmp_path, *LONG, *levels), folder=tmp_path) as process:
        wait_for((tmp_path / "levels" / "level_1.png").exists, process)
        process.send_signal(getattr(signal, which))
        code, said = done(process)
    assert [path.name for path in tmp_path.iterdir()] == ["levels"]
    assert [path.name for path in (tmp_path / "levels").iterdir()] == ["level_1.png"]
    assert read_image(tmp_path / "levels" / "level_1.png").shape == (19, 22, 3)
    if which != "SIGKILL":
        RUN_STOPPED.check(code, said, tmp_path)
        return
    assert code == -signal.SIGKILL
    with started(*command(files, tmp_path, *SHORT), folder=tmp_path) as process:
        RUN_KILLED.check(*done(process), tmp_path)
    assert read_image(tmp_path / "out.png").shape == (38, 44, 3)


@pytest.mark.parametrize("which", ["SIGINT", "SIGTERM"])
@pytest.mark.parametrize("kernels", [1, 3])
def test_run_is_stopped_while_it_compiles(files, tmp_path, which, kernels):
    """A signal that strikes where the compiler calls back is not lost."""
    cache = tmp_path / "kernels"
    call = command(files, tmp_path, *LONG)
    with started(*call, folder=tmp_path, NUMBA_CACHE_DIR=str(cache)) as process:
        wait_for(lambda: len(list(cache.rglob("*.nbi"))) >= kernels, process)
        process.send_signal(getattr(signal, which))
        RUN_COMPILING.check(*done(process), tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["kernels"]


_COMPILES = """
import resource, sys
import numpy as np
from stylit_ref import replay
if len(sys.argv) > 1:
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
nnf = np.full((3, 3, 2), 1, np.int32)
assert replay(nnf, np.full((3, 3), 7, np.uint8), patch_width=3).tolist() == [[7] * 3] * 3
"""


def test_kernels_that_cannot_be_kept_or_read_are_compiled(tmp_path):
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path), "PYTHONPATH": str(CHECKOUT)}

    def compile_kernels(listed, *limit):
        call = [sys.executable, "-c", _COMPILES, *limit]
        run = subprocess.run(call, env=environment, capture_output=True, text=True)
        listed.check(run.returncode, run.stderr, tmp_path)
        return {path: path.stat().st_size for path in tmp_path.rglob("*.nb?")}

    assert not any(compile_kernels(FULL_FOR_KERNELS, "no room").values())
    kept = compile_kernels(FULL_FOR_KERNELS)
    assert kept
    for path in kept:
        path.write_bytes(b"garbage")
    assert compile_kernels(DAMAGED_KERNELS).keys() >= kept.keys()
    assert compile_kernels(DAMAGED_KERNELS) == kept


def test_eval_goes_on_after_anything(small_disk):
    disk, enlarge = small_disk
    runs = disk / "build" / "runs"

    def results():
        return set(runs.glob("[!.]*"))

    with started(*THESIS, folder=disk) as process:
        EVAL_FULL.check(*done(process), disk)
    assert not (disk / "report").exists()
    assert all(read(file) for file in results())
    enlarge()
    for which in ("SIGKILL", "SIGTERM", "SIGINT"):
        before = {file: file.read_bytes() for file in results()}
        with started(*THESIS, folder=disk) as process:
            wait_for(lambda before=before: len(results()) > len(before), process)
            process.send_signal(getattr(signal, which))
            code, said = done(process)
        if which == "SIGKILL":
            assert code == -signal.SIGKILL
        else:
            EVAL_STOPPED.check(code, said, disk)
        assert not (disk / "report").exists()
        assert all(read(file) for file in results())
        assert all(file.read_bytes() == content for file, content in before.items())
    before = {file: file.read_bytes() for file in results()}
    with started(*THESIS, folder=disk) as process:
        EVAL_AGAIN.check(*done(process), disk)
    assert all(file.read_bytes() == content for file, content in before.items())
    record = json.loads((disk / "report" / "report.json").read_text())
    written = contents(disk / "report")
    assert written.keys() == {*record["files"], "report.json"}

    (disk / "report" / "report.json").unlink()
    left_by_sigkill = disk / "report" / ".partial_1"
    left_by_sigkill.mkdir()
    enlarge(shutil.disk_usage(disk).used + 2**14)
    with started(*THESIS, folder=disk) as process:
        REPORT_FULL.check(*done(process), disk)
    del written["report.json"]
    assert contents(disk / "report") == written
    enlarge()

    taken, other = sorted(results())[:2]
    ours = read(taken)
    taken.write_bytes(other.read_bytes())
    with started(*THESIS, folder=disk) as process:
        FOREIGN_RUN.check(*done(process), disk)
    assert read(taken).key == ours.key
    np.testing.assert_array_equal(read(taken).nnf, ours.nnf)
    assert contents(disk / "report").keys() == {*written, "report.json"}


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


def made_anew(path, before):
    """Whether it is there, and not the one that a killed process left."""
    with suppress(FileNotFoundError):
        found = path.stat()
        return before is None or found.st_mtime_ns != before.st_mtime_ns
    return False


def test_data_goes_on_after_anything(small_disk):
    try:
        start()
    except MissingRendererError as error:
        pytest.skip(str(error))
    disk, enlarge = small_disk
    folder = disk / "set"
    with started(*DATA, folder=disk) as process:
        DATA_FULL.check(*done(process), disk)
    assert {path.name for path in folder.iterdir()} <= {"manifest.json"}
    enlarge()
    killed = None
    for which in ("SIGKILL", "SIGTERM", "SIGINT"):
        with started(*DATA, folder=disk) as process:
            wait_for(lambda old=killed: made_anew(folder / "partial", old), process)
            process.send_signal(getattr(signal, which))
            code, said = done(process)
        if which == "SIGKILL":
            assert code == -signal.SIGKILL
            killed = (folder / "partial").stat()
        else:
            DATA_STOPPED.check(code, said, disk)
            assert not (folder / "partial").exists()
        manifest = Manifest.read(folder)
        assert all(manifest.complete(piece) for piece in manifest.pieces)
    with started(*DATA, folder=disk) as process:
        DATA_AGAIN.check(*done(process), disk)
    manifest = Manifest.read(folder)
    assert sorted(manifest.pieces) == ["source", "teapot"]
    assert {path.name for path in folder.iterdir()} == {"manifest.json", "source", "teapot"}
