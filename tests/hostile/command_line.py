"""Run commands in a folder of small images: they are refused in one sentence, or accepted."""

import io
import os
import re
from contextlib import redirect_stderr
from pathlib import Path

from stylit_ref.cli import main

QUICK = ["--pyramid-levels", "2", "--search-vote-iters", "1", "--patchmatch-iters", "1", "--quiet"]


def run(*more):
    """Arguments of a quick ``run`` in the working directory; ``more`` may replace some of them."""
    guides = [["--guide", f"source_{k}.png", f"target_{k}.png"] for k in range(2)]
    return ["run", "--style", "style.png", "--output", "out.png", *guides[0], *guides[1], *QUICK,
            *more]  # fmt: skip


def replay(content):
    """Arguments of a ``replay`` of a field's bytes."""
    Path("hostile.npy").write_bytes(content)
    return ["replay", "--style", "style.png", "--nnf", "hostile.npy", "--output", "out.png"]


def contents(folder):
    """Every file's name and bytes; of a link, the path it leads to."""
    return {
        path: os.readlink(path) if path.is_symlink() else path.is_file() and path.read_bytes()
        for path in folder.rglob("*")
    }


def outcome(arguments):
    """Exit code of a command and what it writes to stderr."""
    said = io.StringIO()
    with redirect_stderr(said):
        try:
            code = main(arguments)
        except SystemExit as stop:
            code = stop.code
    return code, said.getvalue()


def accepted(arguments):
    """The command succeeds."""
    code, said = outcome(arguments)
    assert code == 0, said


def refused(arguments, sentence):
    """The command ends with this one sentence and writes nothing."""
    before = contents(Path.cwd())
    code, said = outcome(arguments)
    check(code, said, sentence)
    assert said.count("\n") == 1
    assert contents(Path.cwd()) == before


def check(code, said, sentence, expected_code=2):
    """The exit code is as expected, and the last line of stderr is the sentence.

    ``…`` stands for any text, the working directory for nothing.
    """
    assert code == expected_code, said
    assert "Traceback" not in said
    last = said.strip().split("\n")[-1].replace(f"{Path.cwd()}/", "").replace(f"{Path.cwd()}", "")
    pattern = ".*".join(map(re.escape, sentence.split("…")))
    assert re.fullmatch(rf"[\w.-]+( run)?: {pattern}", last), last
