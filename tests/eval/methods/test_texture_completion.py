"""Completion and label maps as reports run them, and the times of a synthesis."""

import numpy as np
import pytest
from scipy.ndimage import binary_dilation, binary_erosion
from small_textures import quick, spots

from eval.methods import texture_completion
from eval.methods.texture import TextureSynthesis
from eval.methods.texture_completion import LabelledTexture, TextureCompletion, holes
from eval.textures import Texture
from stylit_ref.texture.complete import complete_texture
from stylit_ref.texture.synthesize import synthesize_texture

TEXTURE = Texture("spots", spots(4, 64), (64, 64))


def test_holes_are_a_quarter_of_any_size():
    for shape in ((64, 64), (300, 400)):
        assert 0.2 < holes(shape).mean() < 0.3


@pytest.mark.parametrize("inverted", [False, True])
def test_what_is_white_is_filled_or_what_is_black(inverted, monkeypatch):
    monkeypatch.setattr(
        texture_completion, "complete_texture",
        lambda image, hole, seed: complete_texture(image, hole, quick(), seed=seed),
    )  # fmt: skip
    outcome = TextureCompletion("completion", inverted).run(TEXTURE, 0)
    kept = holes((64, 64)) == inverted
    np.testing.assert_array_equal(outcome.image[kept], TEXTURE.exemplar[kept])
    assert (outcome.image != TEXTURE.exemplar)[~kept].any()


def test_labels_say_where_each_exemplar_is(monkeypatch):
    monkeypatch.setattr(
        texture_completion, "synthesize_texture",
        lambda images, size, seed, labels: synthesize_texture(
            images, size, quick(), seed=seed, labels=labels
        ),
    )  # fmt: skip
    outcome = LabelledTexture("two", "bricks").run(TEXTURE, 0)
    white = holes((64, 64))
    inside = binary_erosion(white, iterations=5)
    outside = ~binary_dilation(white, iterations=5)
    assert inside.any()
    assert (outcome.coordinates[inside, 0] == 1).all()
    assert (outcome.coordinates[outside, 0] == 0).all()


def test_repeats_change_times_alone():
    once, thrice = (
        TextureSynthesis("quick", quick(iterations=4), repeats).run(TEXTURE, 0)
        for repeats in (1, 3)
    )
    np.testing.assert_array_equal(once.image, thrice.image)
    times = ["seconds", "processor_seconds"]
    assert once.history.drop(columns=times).equals(thrice.history.drop(columns=times))
    assert (thrice.history[times] > 0).all(axis=None)
    assert thrice.history["seconds"].sum() <= thrice.seconds
