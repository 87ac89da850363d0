"""A session whose parameters change, or that begins with what another one made."""

import numpy as np
import pytest
from texture.small_exemplars import blobs, stripes

from stylit_ref.errors import InputError
from stylit_ref.texture.formulae.polar import make_polar
from stylit_ref.texture.painting import paint
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession

DEFORMED = TextureParams(radius=12, max_deformation=16, predicate="none", candidates=1)


def deformed_session():
    session = TextureSession([stripes()], (72, 72), DEFORMED)
    for _ in range(4):
        session.step()
    assert (session.coordinates[..., 1:] % 4).any()
    return session


def test_a_larger_radius_keeps_fractions_of_a_pixel():
    session = deformed_session()
    before = session.coordinates
    session.step(TextureParams(radius=17, iterations=0, predicate="exact"))
    assert session.cost == session.recount()
    kept = (session.coordinates == before).all(axis=2)
    assert kept.any()
    fractions = (before[..., 1:] % 4).any(axis=2)
    assert (kept & fractions).any()


def test_fractions_to_begin_with_are_kept():
    start = deformed_session().coordinates
    session = TextureSession([stripes()], (72, 72), TextureParams(radius=12), start=start)
    np.testing.assert_array_equal(session.coordinates, start)


def test_a_refused_radius_leaves_the_session_as_it_was():
    session = TextureSession([blobs()], (120, 120), TextureParams(radius=8))
    session.step()
    with pytest.raises(InputError, match="is 60, too large for the exemplar of 44 x 40 pixels; 39"):
        session.step(TextureParams(radius=60))
    assert session.params.radius == 8
    assert session.step().radius == 8


def test_every_exemplar_must_hold_a_patch():
    images = [blobs(), blobs(7, 9)]
    with pytest.raises(InputError, match="is 8, too large for the exemplar of 9 x 7 pixels; 7 is"):
        TextureSession(images, (50, 50), TextureParams(radius=8))


@pytest.mark.parametrize("radius", range(1, 141))
def test_every_edge_of_a_cut_lies_in_the_disc_whose_costs_are_computed(radius):
    polar = make_polar(radius, 2.0, 1.5, "arc_length")
    side = polar.half_width.size
    for places in (polar.cut_x, polar.cut_y, polar.step_x, polar.step_y):
        y, x = np.divmod(places.astype(int), side)
        assert (abs(x - side // 2) <= polar.half_width[y]).all()
        assert (y >= 1).all()
        assert (y < side - 1).all()


def test_a_guide_before_does_not_change_what_painting_does():
    """Leftovers of a window, from a patch without a lock, count for nothing."""
    image = np.where(np.random.default_rng(0).random((40, 40)) < 0.5, 0, 255).astype(np.uint8)
    mask = np.zeros((64, 64), bool)
    mask[20:44, 25:50] = True
    painted = []
    for leftovers in (False, True):
        session = TextureSession([image], (64, 64), TextureParams(radius=8), seed=6)
        session.step()
        if leftovers:
            for room in session._work[1]:
                room[:] = 77
        paint(session, mask, 1)
        painted.append(session.coordinates)
    np.testing.assert_array_equal(*painted)
