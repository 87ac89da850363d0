"""Other maps of the exemplars through the coordinates of a texture."""

import numpy as np
import pytest
from small_textures import identity, quick, spots

from stylit_ref import InputError, TextureField, replay_texture, synthesize_texture

EXEMPLARS = [spots(1), spots(2, 40)]
PLAIN = synthesize_texture(EXEMPLARS, (40, 56), quick(), shares=(1, 1))
DEFORMED = synthesize_texture(EXEMPLARS[0], (40, 56), quick(max_deformation=8))


def brute_force(field, picture, scale):
    """Bilinear, pixel by pixel, in sixteenths rounded half up."""
    height, width = field.coordinates.shape[:2]
    last_y, last_x = picture.shape[0] - 1, picture.shape[1] - 1
    made = np.empty((height * scale, width * scale, picture.shape[2]), picture.dtype)
    for row in range(height * scale):
        for column in range(width * scale):
            _, y, x = map(int, field.coordinates[row // scale, column // scale])
            y, x = y * scale + row % scale * 4, x * scale + column % scale * 4
            total = 8
            for below in (0, 1):
                for right in (0, 1):
                    weight = abs(4 * (1 - below) - y % 4) * abs(4 * (1 - right) - x % 4)
                    there = picture[min(y // 4 + below, last_y), min(x // 4 + right, last_x)]
                    total = total + there.astype(int) * weight
            made[row, column] = total // 16
    return made


def test_a_replay_of_the_exemplars_is_the_texture():
    assert np.array_equal(replay_texture(PLAIN.field, EXEMPLARS), PLAIN.image)


def test_a_deformed_texture_is_replayed_to_its_own_bytes():
    assert (DEFORMED.coordinates % 4).any()
    assert np.array_equal(replay_texture(DEFORMED.field, EXEMPLARS[:1]), DEFORMED.image)


@pytest.mark.parametrize("scale", [1, 2])
def test_a_replay_is_bilinear(scale):
    large = spots(5, 48 * scale).astype(np.uint16) * 200
    made = replay_texture(DEFORMED.field, [large])
    assert np.array_equal(made, brute_force(DEFORMED.field, large, scale))


@pytest.mark.parametrize("scale", [2, 4])
def test_an_enlargement_of_the_exemplar_makes_one_of_the_texture(scale):
    large = [each.repeat(scale, axis=0).repeat(scale, axis=1) for each in EXEMPLARS]
    expected = PLAIN.image.repeat(scale, axis=0).repeat(scale, axis=1)
    assert np.array_equal(replay_texture(PLAIN.field, large), expected)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.float32])
def test_maps_keep_their_depth(dtype):
    maps = [(each.astype(np.float64) * 100 % 200).astype(dtype) for each in EXEMPLARS]
    made = replay_texture(PLAIN.field, maps)
    assert made.dtype == dtype
    index, y, x = np.moveaxis(PLAIN.coordinates, -1, 0)
    for number, picture in enumerate(maps):
        own = index == number
        assert np.array_equal(made[own], picture[y[own] // 4, x[own] // 4])


def test_labels_are_not_blended():
    labels = np.random.default_rng(0).choice([3, 200], (48, 48)).astype(np.uint8)
    made = replay_texture(DEFORMED.field, [labels], kind="labels")
    assert made.shape == (40, 56)
    assert set(np.unique(made)) == {3, 200}


def normals(dtype):
    directions = np.random.default_rng(0).normal(size=(48, 48, 3))
    directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    if dtype == np.float32:
        return directions.astype(dtype)
    return np.rint((directions + 1) / 2 * np.iinfo(dtype).max).astype(dtype)


@pytest.mark.parametrize(("dtype", "most"), [(np.float32, 1e-6), (np.uint16, 1e-4)])
def test_normals_stay_as_long_as_normals_are(dtype, most):
    made = replay_texture(DEFORMED.field, [normals(dtype)], kind="normals").astype(np.float64)
    signed = made if dtype == np.float32 else made * 2 / np.iinfo(dtype).max - 1
    assert np.abs(np.linalg.norm(signed, axis=-1) - 1).max() < most
    blended = replay_texture(DEFORMED.field, [normals(np.float32)])
    assert np.linalg.norm(blended, axis=-1).min() < 0.9


def test_normals_at_whole_pixels_are_those_of_the_map():
    field = TextureField(identity(48, 48), ((48, 48),))
    given = normals(np.uint8)
    assert np.array_equal(replay_texture(field, [given], kind="normals"), given)


@pytest.mark.parametrize(
    ("maps", "kind", "said"),
    [
        (EXEMPLARS[:1], "colours", "exemplars of the texture: 2, maps that were given: 1"),
        (
            [EXEMPLARS[0], EXEMPLARS[1][1:]],
            "colours",
            "map 2 has 40 x 39 pixels, exemplar 2 had 40 x 40; it must be that size or a whole "
            "number of times as large, all maps as many times",
        ),
        (
            [EXEMPLARS[0], EXEMPLARS[1].astype(np.uint16)],
            "colours",
            "map 2 is uint16 with 3 channels, map 1 uint8 with 3; give maps that are alike",
        ),
        ([each[..., :2] for each in EXEMPLARS], "normals", "a map of normals has 3 channels"),
        (EXEMPLARS, "normal", "kind is 'normal'; it must be 'colours', 'labels' or 'normals'"),
        ([EXEMPLARS[0].astype(np.int64)] * 2, "colours", "map 1 is int64 of the shape (48, 48, 3)"),
    ],
)
def test_maps_that_do_not_match_are_refused(maps, kind, said):
    with pytest.raises(InputError) as error:
        replay_texture(PLAIN.field, maps, kind=kind)
    assert str(error.value).startswith(said)
