"""Holes that are filled with all cures, and without each."""

from dataclasses import replace

import numpy as np
import pytest
from small_textures import spots

from eval.methods import hole_filling
from eval.methods.hole_filling import CURES, HOLES, HoleFilling, hole_of
from eval.textures import Texture
from stylit_ref import TextureParams
from stylit_ref.texture.complete import complete_texture

SIDE = 64
PARAMS = TextureParams.preset("complete", radius=10, candidates=32, tries=1, iterations=12)


@pytest.fixture(autouse=True)
def small(monkeypatch):
    monkeypatch.setattr(hole_filling.TextureParams, "preset", lambda name: PARAMS)


def filled(hole, without=None, channels=3):
    texture = Texture("spots", spots(1, SIDE, channels), (SIDE, SIDE))
    return texture.exemplar, HoleFilling(hole, hole, without).run(texture, 0)


def test_holes_are_of_5_to_25_percent():
    shares = [hole_of(name, (256, 256)).mean() for name in HOLES]
    assert shares == sorted(shares)
    assert shares[0] > 0.045
    assert shares[-1] <= 0.25


@pytest.mark.parametrize("channels", [1, 3])
def test_with_all_cures_it_is_what_the_library_does(channels):
    image, outcome = filled("stroke", channels=channels)
    expected = complete_texture(image, hole_of("stroke", (SIDE, SIDE)), PARAMS)
    np.testing.assert_array_equal(outcome.image, expected.image)


@pytest.mark.parametrize("without", [None, *CURES])
def test_no_known_pixel_changes(without):
    image, outcome = filled("blobs", without)
    hole = hole_of("blobs", (SIDE, SIDE))
    np.testing.assert_array_equal(outcome.image[~hole], image[~hole])
    facts = outcome.history.iloc[0]
    assert facts["changed"] == 0
    assert facts["hole"] == hole.sum()
    assert facts["iterations"] == 12


@pytest.mark.parametrize("without", CURES)
def test_each_cure_matters(without):
    _, whole = filled("blobs")
    _, outcome = filled("blobs", without)
    assert (whole.coordinates != outcome.coordinates).any()


def test_what_no_patch_reached_is_counted(monkeypatch):
    begun = replace(PARAMS, iterations=0)
    monkeypatch.setattr(hole_filling.TextureParams, "preset", lambda name: begun)
    _, outcome = filled("disc")
    facts = outcome.history.iloc[0]
    assert facts["left"] == facts["hole"] > 0
    assert facts["cost"] > 100
