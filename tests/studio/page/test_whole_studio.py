"""The command itself in a browser: what was painted comes back, however the program ended."""

import os
import re
import signal
import subprocess
import sys
from contextlib import contextmanager

import numpy as np
import pytest
from studio.small_studio import write_passes
from studio_page import StudioPage

from stylit_ref import read_image

pytestmark = pytest.mark.slow  # two programs, each a process of its own


@contextmanager
def studio(folder, port=0):
    """A studio in a folder: (process, address with its token)."""
    command = [sys.executable, "-m", "stylit_ref.cli", "studio", "robot", "--source", "sphere"]
    process = subprocess.Popen(
        [*command, "--port", str(port), "--no-browser", "--quiet"],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        yield process, re.search(r"http://\S+", process.stdout.readline()).group()
    finally:
        process.kill()
        process.communicate()


@pytest.fixture
def folder(tmp_path):
    """Render passes of two spheres."""
    layers = "FULL", "IDMASK"
    write_passes(tmp_path / "sphere", (120, 160), layers)
    write_passes(tmp_path / "robot", (90, 100), layers)
    for name in ("sphere", "robot"):
        write_passes(tmp_path / name, read_image(tmp_path / name / "FULL.png").shape[:2], ["FULL"])
    return tmp_path


def opened(context, address):
    """A page that has its painting; the picture may be compiled still."""
    page = StudioPage(context.new_page())
    page.page.goto(address)
    page.until("!!window.stylitStudio?.session.painting")
    return page


def painted(page, row):
    """Paint a line, and wait until the server has it."""
    page.stroke((20, row), (120, row))
    page.until("window.stylitStudio.sender.isBehind", False)
    return page.pixels()


def port_of(address):
    return int(re.search(r":(\d+)/", address).group(1))


def test_a_painting_comes_back_after_an_interruption_and_after_a_kill(chromium, folder):
    style = folder / "painting" / "style.png"
    context = chromium.new_context(viewport={"width": 1000, "height": 640})
    complaints = []
    context.on("weberror", lambda error: complaints.append(str(error.error)))
    with studio(folder) as (process, address):
        page = opened(context, address)
        assert "token" not in page.page.url
        before = page.pixels()
        first = painted(page, 30)
        assert not np.array_equal(first, before)
        process.send_signal(signal.SIGINT)
        assert process.wait(20) == 130
        assert process.stderr.read() == (
            "stylit-ref: interrupted; the painting is saved in painting\n"
        )
    assert np.array_equal(read_image(style), first)
    page.page.close()
    with studio(folder, port_of(address)) as (process, again):
        assert again != address
        old = context.new_page()
        assert old.goto(address).status == 403  # the token of before
        old.close()
        page = opened(context, again)
        assert np.array_equal(page.pixels(), first)
        assert "is back" in page.page.inner_text("body")
        page.until("document.getElementById('saved').textContent !== ''", False)
        second = painted(page, 60)
        page.until("document.getElementById('saved').textContent !== ''")
        third = painted(page, 90)
        process.kill()  # perhaps while it saves
        process.wait()
    page.page.close()
    saved = read_image(style)
    assert any(np.array_equal(saved, each) for each in (second, third))
    with studio(folder) as (_, address):
        page = opened(context, address)
        assert np.array_equal(page.pixels(), saved)
    context.close()
    assert complaints == []
