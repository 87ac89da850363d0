"""A patch that is dragged over a texture, and dropped."""

import numpy as np
import pytest
from small_textures import quick, spots

from stylit_ref import InputError, TextureSession, drag, drop

EXEMPLARS = [spots(1), spots(2, 40)]


@pytest.fixture
def session():
    """A texture in the midst of its synthesis."""
    session = TextureSession(EXEMPLARS, (50, 64), quick())
    for _ in range(4):
        session.step()
    return session


def test_dragging_leaves_the_texture_alone(session):
    before = session.addresses.copy(), session.cost, session.iteration
    for place in ((20, 30), (0, 0), (49, 63)):
        assert drag(session, (1, 20, 24), place).covers.any()
    assert np.array_equal(session.addresses, before[0])
    assert (session.cost, session.iteration) == before[1:]
    assert session.recount() == session.cost


@pytest.mark.parametrize("place", [(20, 30), (1, 62)])
def test_what_is_dropped_is_what_was_shown(session, place):
    patch = drag(session, (2, 20, 15), place, least_radius=4)
    before, cost = session.image, session.cost
    drop(session, patch)
    assert session.cost == cost + patch.change == session.recount()
    side = len(patch.covers)
    y, x = np.nonzero(patch.covers)
    rows, columns = (place[0] + y - side // 2) % 50, (place[1] + x - side // 2) % 64
    expected = before.copy()
    expected[rows, columns] = patch.colours[y, x]
    assert np.array_equal(session.image, expected)
    assert np.array_equal(session.coordinates[place], [1, 80, 60])


def test_what_is_dropped_is_the_same_after_a_new_layout(session):
    patch = drag(session, (2, 20, 15), (20, 30))
    session.step(quick(radius=session.params.radius + 3, iterations=0))
    assert session.exemplars is not patch.exemplars
    drop(session, patch)
    assert session.cost == session.recount()
    y, x = np.argwhere(patch.covers).T - len(patch.covers) // 2
    expected = np.stack([np.ones_like(y), 80 + 4 * y, 60 + 4 * x], axis=-1)
    assert np.array_equal(session.coordinates[20 + y, 30 + x], expected)


def test_a_least_radius_beyond_the_exemplar_is_one_sentence(session):
    with pytest.raises(InputError, match="the exemplar ends 6 pixels from there"):
        drag(session, (1, 5, 20), (20, 30), least_radius=8)


@pytest.mark.parametrize("least", [1, 5, 7])
def test_a_patch_has_at_least_the_least_radius(session, least):
    covers = drag(session, (1, 20, 24), (20, 30), least_radius=least).covers
    away = np.hypot(*(np.indices(covers.shape) - len(covers) // 2))
    assert covers[away < least - 1].all()
    assert not covers[away > 9].any()


@pytest.mark.parametrize(
    ("source", "place", "least", "said"),
    [
        ((3, 20, 20), (20, 30), 1, "exemplar is 3; it must be an integer from 1 to 2"),
        ((1, 48, 20), (20, 30), 1, "source is y = 48, x = 20; these must be integers of a"),
        ((1, 2, 20), (20, 30), 1, "source is y = 2, x = 20 of exemplar 1, too close to"),
        ((1, 20, 20), (20, 64), 1, "place is y = 20, x = 64; these must be"),
        ((1, 20, 20), (20, 30), 9, "least_radius is 9; it must be an integer from 0 to the radius"),
    ],
)
def test_positions_that_are_none_are_refused(session, source, place, least, said):
    with pytest.raises(InputError) as error:
        drag(session, source, place, least_radius=least)
    assert str(error.value).startswith(said)
