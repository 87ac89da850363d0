"""The messages if the renderer is missing."""

import os
import subprocess
import sys

import pytest

import data_gen.renderer
from data_gen.__main__ import main
from data_gen.renderer import MissingRendererError, start


@pytest.fixture
def no_llvm(monkeypatch):
    monkeypatch.delenv("DRJIT_LIBLLVM_PATH", raising=False)
    monkeypatch.setattr(data_gen.renderer.ctypes.util, "find_library", lambda _: None)
    return lambda found: monkeypatch.setattr(
        data_gen.renderer, "glob", lambda pattern: [f for f in found if "/usr/lib/" in pattern]
    )


@pytest.mark.parametrize(
    ("found", "have"),
    [
        ([], "none was found"),
        (["/usr/lib/x/libLLVM-14.so.1", "/usr/lib/x/libLLVM-15.so"], "libLLVM-15.so"),
    ],
)
def test_llvm_that_is_missing_or_too_old(no_llvm, found, have):
    no_llvm(found)
    with pytest.raises(MissingRendererError) as error:
        start()
    message = str(error.value)
    assert have in message
    assert "apt install libllvm19" in message
    assert "bundled with the project work without it" in message


def test_the_newest_llvm_is_taken(no_llvm):
    no_llvm(["/usr/lib/x/libLLVM-15.so", "/usr/lib/x/libLLVM.so.19.1", "/usr/lib/x/libLLVM-9.so"])
    assert data_gen.renderer._newest_llvm() == "/usr/lib/x/libLLVM.so.19.1"


def test_mitsuba_that_is_missing(monkeypatch):
    monkeypatch.setenv("DRJIT_LIBLLVM_PATH", "libLLVM.so")
    monkeypatch.setitem(sys.modules, "mitsuba", None)
    with pytest.raises(MissingRendererError, match=r"pip install '\.\[render\]'"):
        start()


def test_one_sentence_and_nothing_written(no_llvm, tmp_path, capsys):
    no_llvm([])
    folder = tmp_path / "set"
    assert main(["--size", "30x20", "--folder", str(folder)]) == 2
    error = capsys.readouterr().err
    assert error.startswith("data_gen: rendering needs the LLVM library")
    assert error.count("\n") == 1
    assert not folder.exists()


@pytest.mark.parametrize(
    ("path", "version"),
    [
        ("/usr/lib/x86_64-linux-gnu/libLLVM-15.so.1", 15),
        ("/usr/lib/x86_64-linux-gnu/libLLVM.so.19.1", 19),
        ("/usr/lib/llvm-19/lib/libLLVM.so.1", 19),
        ("/opt/homebrew/opt/llvm@18/lib/libLLVM.dylib", 18),
        ("/opt/homebrew/opt/llvm/lib/libLLVM.dylib", data_gen.renderer.OLDEST_LLVM),
    ],
)
def test_versions_in_paths(path, version):
    assert data_gen.renderer._version(path) == version


def test_a_library_that_is_none_is_named(tmp_path):
    """In a process of its own: the renderer looks for the library once."""
    command = [sys.executable, "-m", "data_gen", "--size", "30x20", "--folder", f"{tmp_path}/set"]
    environment = os.environ | {"DRJIT_LIBLLVM_PATH": f"{tmp_path}/none.so"}
    pytest.importorskip("mitsuba")
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    last = done.stderr.strip().splitlines()[-1]
    assert last.startswith(f"data_gen: rendering cannot use {tmp_path}/none.so as LLVM library")
    assert not (tmp_path / "set").exists()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--size", "300"], "is 300; it must be WIDTHxHEIGHT"),
        (["--size", "8x8"], "16 to 8192"),
        (["--scenes", "teapot,bunny"], "there is no scene bunny; choose from"),
        (["--samples", "0"], "must be a square number"),
        (["--samples", "50"], "must be a square number"),
    ],
)
def test_bad_arguments(capsys, arguments, message):
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    assert caught.value.code == 2
    assert message in capsys.readouterr().err


def test_a_folder_of_somebody_else(tmp_path, capsys):
    (tmp_path / "mine.txt").write_text("keep")
    assert main(["--size", "30x20", "--folder", str(tmp_path)]) == 2
    assert "choose an empty folder" in capsys.readouterr().err
    assert [file.name for file in tmp_path.iterdir()] == ["mine.txt"]
