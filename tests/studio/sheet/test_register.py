"""The painting comes back from photographs of the sheet."""

import numpy as np
import pytest
from paper_photo import SIZE, Photo, photographed, place_of, with_painting
from PIL import Image, ImageDraw

from stylit_ref import InputError
from stylit_ref.studio.sheet.layout import MARK, layout_of
from stylit_ref.studio.sheet.register import register, register_corners


def pixels_off(photo: Photo, corners):
    """By how many of its pixels the picture is displaced at its worst corner."""
    sides = np.roll(photo.corners, -1, axis=0) - photo.corners
    shortest = np.hypot(*sides.T).min()
    return np.hypot(*(corners - photo.corners).T).max() * SIZE[0] / shortest


def inner(picture):
    """A picture without the pixels at its edges, where a frame is printed."""
    return picture[4:-4, 4:-4].astype(int)


@pytest.mark.parametrize("seed", range(8))
def test_the_picture_is_found_within_two_pixels(painted, seed):
    photo = photographed(painted, seed=seed)
    assert pixels_off(photo, register(photo.pixels, SIZE).corners) < 2


@pytest.mark.parametrize("longest", [300, 1200])
def test_a_photograph_may_be_small_or_large(painted, longest):
    photo = photographed(painted, seed=21, longest=longest)
    assert pixels_off(photo, register(photo.pixels, SIZE).corners) < 2


@pytest.mark.parametrize("turns", [1, 2, 3])
def test_a_photograph_may_lie_on_its_side(painted, turns):
    photo = photographed(painted, seed=20, turns=turns)
    assert pixels_off(photo, register(photo.pixels, SIZE).corners) < 2


def test_a_scan_gives_the_painting(painted, painting):
    found = register(np.asarray(painted.reduce(2)), SIZE)
    assert np.abs(inner(found.painting) - inner(painting)).mean() < 4


def test_light_is_undone(painted, painting):
    photo = photographed(painted, seed=3, longest=900)
    uneven = register_corners(photo.pixels, photo.corners, SIZE)
    even = photographed(painted, seed=3, longest=900, light=False)
    as_if = register_corners(even.pixels, even.corners, SIZE)
    assert np.abs(inner(uneven).mean((0, 1)) - inner(as_if).mean((0, 1))).max() < 3
    assert np.abs(inner(uneven) - inner(as_if)).mean() < 8


def test_a_sheet_without_paint_is_the_pale_rendering(sheet, rendering):
    found = register(np.asarray(sheet.convert("RGB").reduce(2)), SIZE)
    pale = 255 - 0.3 * (255 - rendering[0].astype(float))
    assert np.median(np.abs(found.painting - pale)) < 2


@pytest.mark.parametrize(
    ("first", "last"), [(0.3, 0.7), (-0.1, 1.1)], ids=["across", "over all of it"]
)
def test_paint_over_a_mark_does_no_harm(painted, first, last):
    spoilt = painted.copy()
    layout = layout_of(*SIZE)
    low, _, high, _ = layout.marks[2] + place_of(spoilt, layout)
    stroke = [*(low + first * MARK), low[0] + last * MARK, high[1] + 40]
    ImageDraw.Draw(spoilt).rectangle(stroke, (40, 60, 160))
    photo = photographed(spoilt, seed=5)
    assert pixels_off(photo, register(photo.pixels, SIZE).corners) < 2


def test_paint_over_two_marks_is_too_much(painted):
    spoilt = painted.copy()
    layout = layout_of(*SIZE)
    for mark in layout.marks[:2] + place_of(spoilt, layout):
        ImageDraw.Draw(spoilt).rectangle([*(mark[0] - 9), *(mark[2] - 60)], (200, 60, 30))
    photo = photographed(spoilt, seed=5)
    with pytest.raises(InputError, match="shows two of the four marks; take one of the whole"):
        register(photo.pixels, SIZE)


def test_paint_on_the_paper_around_does_no_harm(painted, painting):
    spoilt = painted.copy()
    draw = ImageDraw.Draw(spoilt)
    x, y = place_of(spoilt, layout_of(*SIZE))
    draw.rectangle((x - 100, y + 300, x, y + 1100), (160, 30, 60))
    draw.rectangle((x + 500, y - 120, x + 900, y), (30, 130, 60))
    found = register(np.asarray(spoilt.reduce(2)), SIZE)
    assert np.abs(inner(found.painting) - inner(painting)).mean() < 4


def test_a_mark_that_is_cut_off_is_named(painted):
    photo = photographed(painted, seed=3, aside=(-0.18, 0))
    with pytest.raises(InputError, match="lacks the mark at the upper left; take one of the whole"):
        register(photo.pixels, SIZE)


def test_a_photograph_of_something_else_is_refused(painting):
    with pytest.raises(InputError, match="shows none of the four marks; take one"):
        register(painting, SIZE)


def test_the_sheet_of_another_scene_is_refused(painted):
    with pytest.raises(InputError, match="do not lie as on the sheet for 600x400 pixels"):
        register(np.asarray(painted.reduce(2)), (600, 400))


def test_corners_may_be_shown_where_there_is_no_mark(painting):
    paper = Image.new("RGB", (700, 700), "white")
    paper.paste(Image.fromarray(painting), (100, 100))
    corners = [(100, 100), (600, 100), (600, 600), (100, 600)]
    given = register_corners(np.asarray(paper), corners, SIZE)
    assert np.abs(given.astype(int) - painting).max() <= 2


def test_a_painting_that_fills_the_photograph_keeps_its_colours(painting):
    corners = np.array([(0, 0), (500, 0), (500, 500), (0, 500)])
    same = register_corners(painting, corners, SIZE)
    assert np.abs(same.astype(int) - painting).max() <= 1


@pytest.mark.parametrize(
    "corners",
    [
        [(0, 0), (9, 0), (9, 9)],
        [(0, 0), (0, 90), (90, 90), (90, 0)],
        [(0, 0), (90, 90), (90, 0), (0, 90)],
        [(0, 0), (np.nan, 0), (90, 90), (0, 90)],
        [(0, 0), (1e9, 0), (1e9, 1e9), (0, 1e9)],
    ],
    ids=["three", "mirrored", "crossed", "NaN", "far"],
)
def test_corners_that_go_around_nothing_are_refused(painting, corners):
    with pytest.raises(InputError, match="corners must"):
        register_corners(painting, np.array(corners, float), SIZE)


def test_the_size_is_the_callers(sheet, rendering, ids):
    found = register(np.asarray(with_painting(sheet, rendering[0]).reduce(3)), (64, 64))
    assert found.painting.shape == (64, 64, 3)
    assert found.painting.dtype == np.uint8
