"""Scenes whose stylized target is known."""

import numpy as np
import pytest

from eval.scenes import BUNDLED
from eval.truth import load_truth
from stylit_ref import InputError, read_uint8

LIGHT = 5
"""Light passes of a data set."""


def test_the_style_is_the_one_of_the_data_set(layers):
    truth = load_truth("teapot/oil", layers)
    assert np.array_equal(truth.scene.style, read_uint8(layers / "source/styles/oil.png"))
    assert truth.picture.shape == truth.scene.target_guides[0].shape
    assert len(truth.scene.target_guides) == LIGHT
    assert not np.array_equal(truth.picture, truth.scene.style)


def test_the_guides_are_those_of_the_data_set(layers):
    scene = load_truth("teapot/oil", layers, guided=True).scene
    for name, image in zip(scene.guide_names, scene.target_guides, strict=True):
        assert np.array_equal(image, read_uint8(layers / f"teapot/{name}.png"))
    assert scene.guide_names[LIGHT:] == ("IDMASK",)


def test_a_wall_like_the_ground_changes_the_wall_in_the_guides_alone(layers):
    plain = load_truth("teapot/oil", layers)
    alike = load_truth("teapot/oil", layers, alike=True)
    assert np.array_equal(alike.picture, plain.picture)
    assert np.array_equal(alike.scene.style, plain.scene.style)
    wall = plain.scene.ids[1][:, :, 2] > 0
    before, after = plain.scene.target_guides[0], alike.scene.target_guides[0]
    assert np.array_equal(after[~wall], before[~wall])
    assert (after[wall] > before[wall]).mean() > 0.9
    source, ids = alike.scene.source_guides[0], alike.scene.ids[0]
    medians = [np.median(source[ids[:, :, region] > 0]) for region in (1, 2)]
    assert abs(medians[0] - medians[1]) <= 1


@pytest.mark.parametrize(
    ("name", "data", "message"),
    [
        (
            "lamp/oil",
            None,
            "lamp/oil: is no TARGET/STYLE of .*; targets there: teapot; styles: oil",
        ),
        ("teapot/oil", BUNDLED, "does not list source/passes.exr"),
    ],
    ids=["no such target", "no layers"],
)
def test_what_is_missing_is_named(layers, name, data, message):
    with pytest.raises(InputError, match=message):
        load_truth(name, data or layers)
