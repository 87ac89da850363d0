"""Holes that are filled, and pictures that are made to tile."""

import numpy as np
import pytest
from small_textures import identity, quick, spots

from stylit_ref import (
    InputError,
    TextureParams,
    TextureSession,
    complete_texture,
    make_tileable,
)

IMAGE = spots()
HOLE = np.zeros((48, 48), np.bool_)
HOLE[14:26, 16:34] = True
HOLE[:6, 40:] = True
"""One inside, one in a corner."""


def alone(coordinates):
    """Pixels that continue none of their four neighbours, as noise does."""
    right = (np.diff(coordinates, axis=1) == [0, 0, 4]).all(axis=-1)
    below = (np.diff(coordinates, axis=0) == [0, 4, 0]).all(axis=-1)
    continues = np.zeros(coordinates.shape[:2], np.bool_)
    continues[:, 1:] |= right
    continues[:, :-1] |= right
    continues[1:] |= below
    continues[:-1] |= below
    return ~continues


@pytest.mark.parametrize("seed", range(3))
def test_known_pixels_stay_and_holes_lose_all_they_began_with(seed):
    begun = complete_texture(IMAGE, HOLE, quick(iterations=0), seed=seed)
    result = complete_texture(IMAGE, HOLE, quick(iterations=30), seed=seed)
    assert np.array_equal(result.image[~HOLE], IMAGE[~HOLE])
    assert np.array_equal(result.coordinates[~HOLE], identity(48, 48)[~HOLE])
    assert alone(begun.coordinates)[HOLE].mean() > 0.9
    same = (result.coordinates == begun.coordinates).all(axis=-1)
    assert not (same & HOLE & alone(result.coordinates)).any()


def test_holes_are_filled_well():
    params = TextureParams.preset("complete", radius=12, radius_step=1, radius_end=4)
    result = complete_texture(np.tile(spots(side=16), (3, 3, 1)), HOLE, params)
    assert result.history[-1].cost < 0.3 * HOLE.sum()


def test_the_running_cost_is_the_recount_with_a_lock_and_free_borders():
    coordinates = complete_texture(IMAGE, HOLE, quick(iterations=0)).coordinates
    session = TextureSession(
        [IMAGE], (48, 48), quick(), known=[~HOLE], start=coordinates, lock=~HOLE, wraps=False
    )
    accepted, before = 0, session.cost
    for _ in range(10):
        accepted += session.step().accepted
        assert session.cost == session.recount() <= before
        before = session.cost
    assert accepted


def test_holes_are_filled_from_known_pixels():
    result = complete_texture(IMAGE, HOLE, quick())
    y, x = np.moveaxis(result.coordinates[HOLE][:, 1:] // 4, -1, 0)
    assert not HOLE[y, x].any()


def test_what_holes_hold_is_of_no_account():
    painted = IMAGE.copy()
    painted[HOLE] = 255
    assert np.array_equal(
        complete_texture(painted, HOLE, quick()).image, complete_texture(IMAGE, HOLE, quick()).image
    )


def test_holes_are_filled_from_other_exemplars():
    result = complete_texture(IMAGE, HOLE, quick(), exemplars=[spots(1), spots(2, 40)])
    assert np.array_equal(result.image[~HOLE], IMAGE[~HOLE])
    assert set(np.unique(result.coordinates[HOLE][:, 0])) == {1, 2}


def test_unlocked_pixels_change():
    result = complete_texture(IMAGE, HOLE, quick(), unlocked=True)
    assert (result.image != IMAGE)[~HOLE].any()


def test_a_picture_that_does_not_wrap_pays_for_no_seam_across_its_border():
    free, wrapping = (
        TextureSession([IMAGE], (48, 48), quick(), start=identity(48, 48), wraps=wraps).cost
        for wraps in (False, True)
    )
    assert free == 0 < wrapping


def test_grey_pictures_stay_flat():
    grey = spots(channels=1)[:, :, 0]
    assert complete_texture(grey, HOLE, quick()).image.shape == (48, 48)
    assert make_tileable(grey, 8, quick()).image.shape == (48, 48)


def test_a_tiling_picture_keeps_its_inside_and_loses_its_border_seams():
    result = make_tileable(IMAGE, 10, quick(iterations=40, candidates=64))
    assert np.array_equal(result.image[10:38, 10:38], IMAGE[10:38, 10:38])
    assert (result.image != IMAGE).any()
    begun = TextureSession([IMAGE], (48, 48), quick(), start=identity(48, 48))
    assert result.history[-1].cost < 0.1 * begun.cost / 256


def test_the_same_bytes_with_any_number_of_threads():
    several = [complete_texture(IMAGE, HOLE, quick(), threads=n).addresses for n in (1, 2)]
    assert np.array_equal(*several)


@pytest.mark.parametrize(
    ("hole", "said"),
    [
        (HOLE[1:], "hole is bool of the shape (47, 48); it must be bool of the image's shape"),
        (HOLE.astype(np.uint8), "hole is uint8 of the shape (48, 48)"),
        (np.ones_like(HOLE), "hole covers the whole image; leave some pixels known"),
    ],
)
def test_holes_that_cannot_be_filled_are_refused(hole, said):
    with pytest.raises(InputError) as error:
        complete_texture(IMAGE, hole)
    assert str(error.value).startswith(said)


@pytest.mark.parametrize("band", [0, 24, 2.5])
def test_bands_that_leave_nothing_alone_are_refused(band):
    with pytest.raises(InputError, match="must be an integer from 1 to 23"):
        make_tileable(IMAGE, band)
