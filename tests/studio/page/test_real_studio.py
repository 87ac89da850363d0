"""The page and the program: what the small server of the other tests cannot show."""

import os
import re
import signal
import subprocess
import sys
import time
from types import SimpleNamespace

import numpy as np
import pytest
from studio.small_studio import SIZE, write_passes

from stylit_ref import read_image, write_image

pytestmark = pytest.mark.slow  # a browser and a server are processes of their own

LINE = "document.getElementById('banner').textContent"
COMPILED = 300
"""Seconds that kernels may take."""

NEWEST = "document.getElementById('which').textContent"
REFUSED = "ERR_CONNECTION_REFUSED", "403"


@pytest.fixture
def begin(tmp_path):
    """Starts the program; it goes on with the painting of before."""
    running, opened, browser = [], tmp_path / "opened", tmp_path / "browser"
    browser.write_text(f'#!/bin/sh\necho "$1" > {opened}.part; mv {opened}.part {opened}\n')
    browser.chmod(0o700)
    things = np.zeros((*SIZE, 3), np.uint8)
    things[8:20, 8:24] = 255
    for seed, name in enumerate(("source", "target")):
        write_passes(tmp_path / name, SIZE, ("FULL", "LDE"), seed)
        write_image(tmp_path / name / "IDMASK.png", things)

    def begun(port=0):
        command = (sys.executable, "-m", "stylit_ref", "studio", tmp_path / "target")
        options = ("--source", tmp_path / "source", "--painting", tmp_path / "painting")
        opened.unlink(missing_ok=True)
        process = subprocess.Popen(
            [*command, *options, "--port", str(port), "--threads", "1"], stdout=subprocess.PIPE,
            env={**os.environ, "PYTHONUNBUFFERED": "1", "BROWSER": f"{browser} %s"}, text=True,
        )  # fmt: skip
        running.append(process)
        first = process.stdout.readline()
        address = re.search(r"(http://127.0.0.1:(\d+)/)\?token=\S+", first)
        while not opened.exists():
            time.sleep(0.05)
        return SimpleNamespace(
            process=process, login=opened.read_text().strip(), address=address[1],
            port=int(address[2]),
        )  # fmt: skip

    yield begun
    for process in running:
        process.kill()
        process.wait()
        process.stdout.close()


def test_the_target_follows_a_stroke_and_the_painting_is_saved(begin, open_page, tmp_path):
    studio = begin()
    assert studio.login == (tmp_path / "painting" / "open_studio.html").as_uri()  # and no token
    page = open_page(studio).started(COMPILED)
    page.until(NEWEST, "fast", COMPILED)
    page.set("colour-number", "#00ff00")
    page.set("size", 60)
    before = page.pixels()
    page.stroke((4, 12), (28, 12))
    page.until(NEWEST, "fast")
    green = page.page.evaluate("""() => {
      const { width, height } = document.getElementById("picture");
      const context = document.getElementById("picture").getContext("2d");
      const { data } = context.getImageData(0, 0, width, height);
      return data.filter((value, k) => k % 4 === 1 && value > 230 && !data[k - 1]).length;
    }""")
    assert green > 0
    _until_saved(tmp_path, page.pixels())
    page.until("document.getElementById('saved').textContent.startsWith('Saved')")
    page.page.keyboard.press("z")
    assert np.array_equal(page.pixels(), before)


def test_nothing_is_lost_when_the_program_is_killed_and_started_anew(begin, open_page, tmp_path):
    studio = begin()
    old = open_page(studio).started(COMPILED)
    old.stroke((4, 6), (28, 6))
    saved = old.pixels()
    _until_saved(tmp_path, saved)
    studio.process.send_signal(signal.SIGKILL)
    old.until(f"{LINE}.startsWith('The connection is lost.')")
    old.stroke((4, 18), (28, 18))
    painted = old.pixels()

    studio = begin(studio.port)
    old.until(f"{LINE}.startsWith('The studio was started anew.')")
    new = open_page(studio, context=old.page.context).started()
    assert np.array_equal(new.pixels(), saved)
    assert "is back" in new.text("said")

    old.until(f"{LINE}.startsWith('Another page has the brush. This one holds strokes')")
    old.page.get_by_role("button", name="Take over").click()
    new.until(f"{LINE}.startsWith('Another page has the brush')")
    old.until(LINE, "")
    new.until("window.stylitStudio.sender.serial", old.sent())
    assert np.array_equal(old.pixels(), painted)
    assert np.array_equal(new.pixels(), painted)
    # The browser itself tells that nobody answers, or does not let it in.
    open_page.complaints[:] = [
        said for said in open_page.complaints if not any(text in said for text in REFUSED)
    ]


def _until_saved(folder, painting):
    """It is saved at most once a second."""
    file = folder / "painting" / "style.png"
    end = time.monotonic() + 10
    while not file.exists() or not np.array_equal(read_image(file), painting):
        assert time.monotonic() < end
        time.sleep(0.05)
