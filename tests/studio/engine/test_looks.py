"""What there is to look at, beside twins that anyone can read."""

import numpy as np

from stylit_ref.files.field import Field
from stylit_ref.files.realtime_field import RealtimeField
from stylit_ref.studio.engine.looks import (
    as_colours,
    hue_circle,
    nnf_picture,
    places_of,
    usage_counts,
    usage_picture,
)

STYLE = 14, 17


def sparse(spacing=3, target=(8, 10)):
    random = np.random.default_rng(1)
    grid = tuple(-(-side // spacing) for side in target)
    nnf = np.stack([random.integers(2, side - 2, grid) for side in STYLE], axis=-1)
    return RealtimeField(nnf.astype(np.int32), 5, spacing, STYLE, target)


def test_places_are_those_of_the_nearest_entry():
    field = sparse()
    places = places_of(field)
    for y in range(8):
        for x in range(10):
            a, b = min(round(y / 3), 2), min(round(x / 3), 3)
            y_there, x_there = field.nnf[a, b] + (y - 3 * a, x - 3 * b)
            assert tuple(places[y, x]) == (y_there.clip(0, 13), x_there.clip(0, 16))


def test_a_dense_field_says_its_places():
    nnf = np.random.default_rng(2).integers(2, 10, (6, 7, 2)).astype(np.int32)
    assert np.array_equal(places_of(Field(nnf, 5)), nnf)


def test_usage_counts_patches_over_each_pixel():
    field = sparse()
    expected = np.zeros((STYLE[0] + 4, STYLE[1] + 4), int)
    for y, x in places_of(field).reshape(-1, 2):
        expected[y : y + 5, x : x + 5] += 1
    assert np.array_equal(usage_counts(field, STYLE), expected[2:-2, 2:-2])


def test_usage_is_black_where_nothing_is_used_and_white_where_most_is():
    field = sparse()
    counts, picture = usage_counts(field, STYLE), usage_picture(field, STYLE)
    assert (picture[counts == 0] == 0).all()
    assert (picture[counts == counts.max()] == 255).all()


def test_hues_go_around_the_middle_of_the_source():
    circle = hue_circle((101, 101)).astype(int)
    assert (circle[50, 50] == 255).all()
    assert circle[50, 100].argmax() == 0  # red to the right
    assert (circle[0, 50, 1] > circle[0, 50, [0, 2]]).all()  # greenish at the top
    assert (circle[50, 0, 0] < circle[50, 0, 1:]).all()  # cyan to the left


def test_pixels_of_the_nnf_have_the_hue_of_their_place():
    field = sparse()
    picture, places = nnf_picture(field, STYLE), places_of(field)
    assert np.array_equal(picture[4, 5], hue_circle(STYLE)[tuple(places[4, 5])])


def test_buffers_are_shown_without_alpha():
    image = np.random.default_rng(3).integers(0, 256, (4, 5, 4), np.uint8)
    assert np.array_equal(as_colours(image), image[..., :3])
    assert np.array_equal(as_colours(image[..., :2]), image[..., :1].repeat(3, axis=2))
