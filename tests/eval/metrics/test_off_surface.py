"""Strokes that turn with their surface, and such that keep their angle, by construction."""

import numpy as np
import pytest

from eval.metrics.off_surface import off_surface

SIDE = 80
Y, X = np.mgrid[:SIDE, :SIDE]
ONE_FACE = np.zeros((SIDE, SIDE, 1), np.uint8)


def hatched(degrees, places=None):
    """Parallel strokes on white paper; clockwise, 0 along x."""
    angle = np.radians(degrees)
    wave = np.cos(2 * np.pi * (np.cos(angle) * Y - np.sin(angle) * X) / 6)
    grey = np.uint8(np.round(190 + 60 * wave))
    grey = grey if places is None else np.where(places, grey, 250).astype(np.uint8)
    return np.repeat(grey[..., None], 3, axis=2)


def direction(degrees):
    double = np.radians(2 * degrees)
    channels = np.round(127.5 * (1 + np.array([np.cos(double), np.sin(double)])))
    return np.broadcast_to(np.uint8(channels), (SIDE, SIDE, 2))


@pytest.mark.parametrize(("drawn", "off"), [(110, 0), (90, 20), (140, 30)])
def test_strokes_are_off_by_what_they_lack_of_the_turn(drawn, off):
    """The surface turned from 85 to 105 degrees, and strokes at 90 with it."""
    directions = direction(105), direction(85)
    found = off_surface(hatched(drawn), hatched(90), directions, (ONE_FACE, ONE_FACE))
    assert found == pytest.approx(off, abs=1)


def test_each_face_has_strokes_of_its_own_and_borders_do_not_count():
    left = X < SIDE // 2
    faces = np.uint8(left)[..., None]
    picture = np.where(left[..., None], hatched(20), hatched(150))
    found = off_surface(picture, picture, (direction(0), direction(0)), (faces, faces))
    assert found < 1
    assert off_surface(hatched(20), picture, (direction(0), direction(0)), (faces, faces)) > 20


def test_blank_faces_and_crossed_strokes_have_no_direction():
    crossed = np.minimum(hatched(20), hatched(110))
    for painting in (crossed, hatched(0, places=False)):
        pair = direction(0), direction(0)
        assert off_surface(hatched(20), painting, pair, (ONE_FACE, ONE_FACE)) is None
