"""The process in the background: the bytes of ``stylize``, and the newest wish wins."""

import os
import signal
from pathlib import Path

import numpy as np
import pytest
from small_studio import Ears, make_painting, make_scene

from stylit_ref import stylize
from stylit_ref.errors import InputError
from stylit_ref.studio.engine.background import Background, Wish
from stylit_ref.studio.engine.events import Picture, Working
from stylit_ref.studio.engine.parameters import Settings
from stylit_ref.studio.engine.scene import Scene

pytestmark = pytest.mark.slow  # a process of its own

LONG = {"guide_influence": 3}
"""Tells jobs apart that are given up from those that are not."""


@pytest.fixture(scope="module")
def heard():
    return Ears()


@pytest.fixture(scope="module")
def made():
    return []


@pytest.fixture(scope="module")
def background(heard, made):
    background = Background(heard, made.append)
    yield background
    background.close()


@pytest.fixture(autouse=True)
def _nothing_was_heard(heard, made):
    heard.all()
    made.clear()


def wish(which="fast", scene=None, serial=0, **values):
    settings = Settings(seed=3).with_parameters(values)
    return Wish(which, make_painting(), scene or make_scene(2), 0, settings, serial)


def stylized(which, scene, step=0, settings=None):
    settings = settings or Settings(seed=3)
    guides = list(scene.source.values()), list(scene.target(step).values())
    params = settings.dense_params(which, scene.buffers)
    return stylize(make_painting(), *guides, params, seed=3, threads=1)


@pytest.mark.parametrize("which", ["fast", "full"])
def test_pictures_are_those_of_stylize(background, heard, made, which):
    background.begin(wish(which, serial=9))
    picture, expected = heard.picture(which), stylized(which, make_scene(2))
    assert np.array_equal(picture.image, expected.image)
    assert picture.serial == 9
    assert picture.milliseconds > 0
    assert np.array_equal(made[0].field.nnf, expected.nnf)
    assert heard.next(Working, which=which).state == "done"


def test_another_step_is_another_picture(background, heard):
    scene, settings = make_scene(2), Settings(seed=3)
    for step in (0, 1, 0):
        background.begin(Wish("fast", make_painting(), scene, step, settings, step))
        picture = heard.picture("fast")
        assert np.array_equal(picture.image, stylized("fast", scene, step).image)


def test_the_newest_wish_wins(background, heard):
    for serial in range(8):
        background.begin(wish("full", serial=serial, **LONG))
    background.begin(wish("fast", serial=9))
    assert heard.next(Picture).serial == 9
    assert not background.is_busy or heard.next(Working, state="done")


def test_what_is_cancelled_is_not_told(background, heard):
    background.begin(wish("full", **LONG))
    heard.next(Working, state="started")
    background.cancel()
    assert not background.is_busy
    assert heard.next((Picture, Working), which="full", state="cancelled")


@pytest.mark.skipif(not hasattr(os, "getpriority"), reason="priorities are Unix's")
def test_its_priority_is_low(background, heard):
    background.begin(wish())
    heard.picture("fast")
    own, other = (os.getpriority(os.PRIO_PROCESS, pid) for pid in (0, background.process_id))
    assert other == min(own + 10, 19)


def test_it_is_begun_anew_if_it_was_killed(background, heard):
    background.begin(wish())
    heard.picture("fast")
    before = background.process_id
    os.kill(before, signal.SIGKILL)
    background.begin(wish(serial=5))
    assert heard.picture("fast").serial == 5
    assert background.process_id != before


def test_a_scene_that_cannot_be_read_is_told(background, heard):
    def lost():
        raise InputError("golem/FULL.png: no such file")

    scene = Scene("lost", "Lost", make_scene().source, [lost])
    background.begin(wish(scene=scene))
    failed = heard.next(Working, state="failed")
    assert failed.text == "golem/FULL.png: no such file"


def test_a_failure_that_nobody_foresaw_is_told_and_the_thread_goes_on(monkeypatch, caplog):
    def fail(background):
        raise RuntimeError("nobody foresaw it")

    monkeypatch.setattr(Background, "_start", fail)
    heard = Ears()
    background = Background(heard, [].append)
    for _ in range(2):
        background.begin(wish())
        failed = heard.next(Working, state="failed")
        assert failed.text == "something went wrong; the terminal says what"
    background.close()
    assert "nobody foresaw it" in caplog.text


def test_it_ends_with_its_owner():
    heard = Ears()
    background = Background(heard, [].append)
    background.begin(wish())
    heard.picture("fast")
    process = background.process_id
    background.close()
    assert not Path(f"/proc/{process}").exists() or not Path("/proc").exists()
