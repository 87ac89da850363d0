"""Exemplars: the same bytes again, the size asked for, and the period that is stated."""

import hashlib

import numpy as np
import pytest

from data_gen.textures import TEXTURES, make_texture

DIGESTS = {
    "bricks": "ff900676dadaa556",
    "canes": "775259fe29e344cd",
    "flowers": "a02bedd1146bf229",
    "pebbles": "caabcfe55173a8a3",
    "glyphs": "d51fad6cdcd280b9",
    "marble": "78d8d2d7bdba1558",
    "door": "1830b9e87438e2ce",
}
PERIODIC = [name for name, recipe in TEXTURES.items() if recipe.period]


@pytest.mark.parametrize("name", TEXTURES)
def test_an_exemplar_is_the_same_bytes_again(name):
    image = make_texture(name)
    assert image.shape == (256, 256, 3)
    assert hashlib.sha256(image).hexdigest()[:16] == DIGESTS[name]


@pytest.mark.parametrize("name", TEXTURES)
@pytest.mark.parametrize("size", [96, 130])
def test_an_exemplar_has_the_size_asked_for(name, size):
    image = make_texture(name, size)
    assert image.shape == (size, size, 3)
    assert image.dtype == np.uint8


@pytest.mark.parametrize("name", TEXTURES)
def test_another_seed_makes_another_exemplar(name):
    other = make_texture(name, 128, TEXTURES[name].seed + 100)
    assert (make_texture(name, 128) != other).any()


def structure(name):
    """What exemplars of many seeds have in common: their tones and their noise average out."""
    return np.mean([make_texture(name, 160, seed).mean(axis=2) for seed in range(40)], axis=0)


@pytest.mark.parametrize("name", PERIODIC)
def test_the_structure_repeats_after_the_period_and_no_sooner(name):
    mean, (down, along) = structure(name)[1:-1, 1:-1], TEXTURES[name].period
    contrast = mean.std()

    def difference(shift_down, shift_along):
        height, width = mean.shape
        moved = mean[shift_down:, shift_along:]
        return np.sqrt(((mean[: height - shift_down, : width - shift_along] - moved) ** 2).mean())

    assert difference(down, 0) < 0.3 * contrast
    assert difference(0, along) < 0.3 * contrast
    assert all(difference(shift, 0) > 0.6 * contrast for shift in range(down // 4, down * 3 // 4))
    assert all(difference(0, shift) > 0.6 * contrast for shift in range(along // 4, along * 3 // 4))
