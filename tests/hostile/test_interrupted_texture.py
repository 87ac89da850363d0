"""Ctrl-C during a texture, in a process with a terminal."""

import os
import pty
import signal
import subprocess
import sys
import termios
from dataclasses import replace

import numpy as np
import pytest
from small_textures import quick, spots

from stylit_ref import read_image, read_texture_field, synthesize_texture, write_image

ENDLESS = 1_000_000


def interrupted(folder, *more):
    """Exit code of a synthesis that gets Ctrl-C after an iteration or more, and what it said."""
    write_image(folder / "spots.png", spots())
    terminal, its_end = pty.openpty()
    termios.tcsetwinsize(its_end, (24, 120))  # nothing is shown on a terminal without columns
    command = [
        sys.executable, "-m", "stylit_ref", "texture", "--exemplar", "spots.png", "--size",
        "56x40", "--radius", "8", "--candidates", "16", "--iterations", str(ENDLESS), "--output",
        "out.png", "--save-coordinates", "s.npy", *more,
    ]  # fmt: skip
    with subprocess.Popen(command, cwd=folder, stderr=its_end) as process:
        os.close(its_end)
        said = b""
        while b"iteration 1" not in said:
            said += os.read(terminal, 4096)
        process.send_signal(signal.SIGINT)
        try:
            while more_said := os.read(terminal, 4096):
                said += more_said
        except OSError:  # Linux, where the other end is closed
            pass
        code = process.wait(timeout=60)
    os.close(terminal)
    return code, said.decode()


@pytest.mark.slow
def test_whole_iterations_are_kept_on_request_and_can_be_resumed(tmp_path):
    code, said = interrupted(tmp_path, "--keep-interrupted")
    assert code == 0
    assert "wrote out.png (56x40), s.npy in " in said
    field = read_texture_field(tmp_path / "s.npy")
    assert 0 < field.iterations < ENDLESS
    params = quick(iterations=field.iterations)
    assert np.array_equal(
        read_image(tmp_path / "out.png"), synthesize_texture(spots(), (40, 56), params).image
    )
    later = replace(params, iterations=field.iterations + 3)
    resumed = synthesize_texture(spots(), (40, 56), later, start=field)
    whole = synthesize_texture(spots(), (40, 56), later)
    assert np.array_equal(resumed.image, whole.image)


@pytest.mark.slow
def test_nothing_is_kept_otherwise(tmp_path):
    code, said = interrupted(tmp_path)
    assert code == 130
    assert said.rstrip().endswith("stylit-ref: interrupted; no half-written file is left")
    assert [path.name for path in tmp_path.iterdir()] == ["spots.png"]
