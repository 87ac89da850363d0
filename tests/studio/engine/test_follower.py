"""Frames that follow a painting are those of a session, and none is older than it seems."""

import numpy as np
import pytest
from small_studio import TARGET_SIZE, make_painting, make_scene

from stylit_ref.errors import InputError
from stylit_ref.realtime.packing import StagePacking, pack
from stylit_ref.realtime.replaying import replay_realtime
from stylit_ref.realtime.session import Session
from stylit_ref.studio.engine.follower import Follower
from stylit_ref.studio.engine.parameters import Settings

STROKE = np.full((6, 5, 3), 250, np.uint8)


def quick(**settings):
    values = {"levels": 3, "iterations": [1, 2]} | settings
    return Settings(seed=3).with_parameters(values)


def followed(settings=None, scene=None):
    """A follower after its first frame."""
    follower = Follower(scene or make_scene(3), make_painting(), settings or quick(), threads=1)
    refresh(follower)
    follower.frame(warm=False)
    return follower


def refresh(follower):
    follower.prepare(*[lambda *what: None] * 2)


def cold(follower, weights=None):
    """The frame of a session that knows only how the follower stands."""
    settings, scene = follower.settings, follower.scene
    session = Session(settings.live, seed=settings.seed, threads=1)
    source, labels = pack(StagePacking(), scene.source)
    target, target_labels = pack(StagePacking(), scene.target(follower.step))
    session.set_exemplar(source, follower.painting, labels)
    session.set_target(target, target_labels)
    session.set_weights(weights)
    return session.frame()


def test_a_frame_after_strokes_is_that_of_a_new_session():
    follower = followed()
    for serial, place in enumerate((3, 17, 30), 1):
        follower.paint(place, place, STROKE, serial)
        refresh(follower)
        follower.replay()
    which, image = follower.frame(warm=False)
    assert which == "coherent"
    assert follower.serial == 3
    assert np.array_equal(image, cold(follower))


def test_a_replay_is_the_painting_through_the_matches_before():
    follower = followed()
    field = follower.shown().field
    follower.paint(3, 4, STROKE, 1)
    refresh(follower)
    image = follower.replay()
    assert np.array_equal(image, replay_realtime(field, follower.painting))


def test_a_turned_target_starts_warm():
    follower = followed()
    follower.step = 1
    refresh(follower)
    assert follower.frame(warm=True)[0] == "warm"
    follower.step = 0
    refresh(follower)
    which, image = follower.frame(warm=False)
    assert which == "coherent"
    assert np.array_equal(image, cold(follower))


def test_a_stroke_is_never_warm():
    follower = followed()
    follower.paint(3, 4, STROKE, 1)
    follower.step = 1
    refresh(follower)
    assert follower.frame(warm=True)[0] == "coherent"


@pytest.mark.parametrize(
    "change",
    [
        {"step": 1},
        {"settings": quick(levels=2)},
        {"settings": quick().with_weights({"LSE": 2}, ("LSE",))},
        {"scene": make_scene()},
    ],
)
def test_what_else_changes_wants_a_frame_before_a_replay(change):
    follower = followed()
    assert follower.can_replay
    assert follower.is_searched
    for name, value in change.items():
        setattr(follower, name, value)
    assert not follower.can_replay
    assert not follower.is_searched


def test_a_stroke_wants_a_frame_but_can_be_replayed():
    follower = followed()
    follower.paint(3, 4, STROKE, 1)
    assert follower.can_replay
    assert not follower.is_searched


def test_parameters_of_the_dense_method_change_no_frame():
    follower = followed()
    follower.settings = follower.settings.with_parameters({"uniformity": 5000})
    assert follower.is_searched


def test_weights_are_those_of_the_channels():
    follower = followed()
    weights = {"FULL": 3, "LSE": 0}
    follower.settings = follower.settings.with_weights(weights, follower.scene.buffers)
    refresh(follower)
    _, image = follower.frame(warm=False)
    by_channel = [weights.get(name, 1) for name in StagePacking.channels]
    assert np.array_equal(image, cold(follower, by_channel))


def test_a_thing_that_is_not_painted_on_is_refused_until_labels_are_off():
    mask = np.full((*TARGET_SIZE, 3), (0, 0, 255), np.uint8)  # all of it is shadow
    source_has_no_shadow = make_scene(LIGHTMASK=mask)
    source_has_no_shadow.source["LIGHTMASK"][:] = (0, 255, 0)
    follower = Follower(source_has_no_shadow, make_painting(), quick(), threads=1)
    sentence = "A small stage: its LIGHTMASK has the colour 0, 0, 255 at x 0, y 0, and so a thing"
    with pytest.raises(InputError, match=sentence):
        refresh(follower)
    follower.settings = quick(labels=False)
    refresh(follower)
    follower.frame(warm=False)
    assert follower.is_searched


def test_a_picture_that_is_out_of_date_is_not_exported():
    follower = followed()
    follower.paint(3, 4, STROKE, 1)
    with pytest.raises(InputError, match="does not show the last stroke yet"):
        follower.shown()
