"""An exemplar as a brush, and the picture of what is about to be done."""

import numpy as np
import pytest
from small_textures import quick, spots

from stylit_ref import InputError, TextureSession, overlay, paint

EXEMPLARS = [spots(1), 255 - spots(2, 40)]
STROKE = np.zeros((50, 64), np.bool_)
STROKE[10:30, 50:] = True
STROKE[10:30, :6] = True


def begun(**named):
    """A texture of the first exemplar."""
    labels = np.ones((50, 64), np.uint8)
    session = TextureSession(EXEMPLARS, (50, 64), quick(), labels=labels, **named)
    for _ in range(4):
        session.step()
    return session


def test_a_stroke_is_filled_at_once_and_nothing_else_changes():
    session = begun()
    before = session.coordinates
    done = paint(session, STROKE, 2, iterations=6)
    assert np.array_equal(session.coordinates[~STROKE], before[~STROKE])
    assert (session.coordinates[STROKE][:, 0] == 1).all()
    assert sum(each.accepted for each in done) > 0
    assert session.cost == session.recount()


def test_later_iterations_keep_what_was_painted():
    session = begun()
    paint(session, STROKE, 2)
    for _ in range(4):
        session.step()
        assert session.cost == session.recount()
    assert (session.coordinates[STROKE][:, 0] == 1).all()
    assert (session.coordinates[~STROKE][:, 0] == 0).all()


def test_locked_pixels_are_not_painted():
    lock = np.zeros_like(STROKE)
    lock[:20] = True
    session = begun(lock=lock)
    before = session.coordinates
    paint(session, STROKE, 2)
    assert np.array_equal(session.coordinates[lock], before[lock])
    assert (session.coordinates[STROKE & ~lock][:, 0] == 1).all()


def test_a_texture_without_labels_can_be_painted():
    session = TextureSession(EXEMPLARS, (50, 64), quick())
    paint(session, STROKE, 2)
    assert (session.coordinates[STROKE][:, 0] == 1).all()
    assert session.texture.labels.size == 1


def test_an_empty_stroke_does_nothing():
    session = begun()
    assert paint(session, np.zeros_like(STROKE), 2) == []


@pytest.mark.parametrize(
    ("mask", "exemplar", "said"),
    [
        (STROKE[1:], 2, "mask is bool of the shape (49, 64)"),
        (STROKE, 0, "exemplar is 0; it must be an integer from 1 to 2"),
    ],
)
def test_strokes_that_do_not_fit_are_refused(mask, exemplar, said):
    session = begun()
    with pytest.raises(InputError) as error:
        paint(session, mask, exemplar)
    assert str(error.value).startswith(said)


@pytest.mark.parametrize("iterations", [0, -1, 2.5])
def test_iterations_are_checked_before_anything_is_painted(iterations):
    session = begun()
    before = session.coordinates.copy()
    with pytest.raises(InputError, match=r"iterations is .*; it must be an integer from 1"):
        paint(session, STROKE, 2, iterations)
    assert np.array_equal(session.coordinates, before)


def test_the_overlay_shows_seams_and_the_next_patches():
    session, other = begun(), begun()
    picture = overlay(session)
    seams = np.maximum(*session.seams) >= 16
    colours = {"red": (255, 0, 0), "green": (0, 255, 0), "blue": (0, 96, 255)}
    drawn = {name: (picture == colour).all(axis=-1) for name, colour in colours.items()}
    assert drawn["red"].any()
    assert seams[drawn["red"]].all()
    untouched = ~(drawn["red"] | drawn["green"] | drawn["blue"])
    assert np.array_equal(picture[untouched], session.image[untouched])
    accepted = session.step()
    assert accepted == other.step()
    assert drawn["green"].any() == (accepted.accepted > 0)
    assert drawn["blue"].any() == (accepted.accepted < accepted.tried)
