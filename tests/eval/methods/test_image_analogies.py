"""Image Analogies on input made by hand."""

import numpy as np
import pytest
from small_scene import small_scene

from eval.methods.image_analogies import ImageAnalogies, image_analogies


@pytest.mark.slow
def test_image_analogies_of_the_source_are_the_style():
    """Each pixel's neighbourhood is found again where it is."""
    rng = np.random.default_rng(2)
    guide, style = (rng.integers(0, 256, (24, 26, 3), dtype=np.uint8) for _ in range(2))
    image, nnf, omega, levels = image_analogies(style, guide, guide, ImageAnalogies(levels=2))
    np.testing.assert_array_equal(image, style)
    np.testing.assert_array_equal(nnf, np.moveaxis(np.indices((24, 26)), 0, 2))
    assert omega.tolist() == np.ones((24, 26)).tolist()
    assert [level.shape for level in levels] == [(12, 13, 3), (24, 26, 3)]


@pytest.mark.slow
def test_coherence_continues_what_was_taken_before():
    """Smooth guides leave the choice open; the larger κ, the larger the pieces."""
    style, sources, targets = small_scene()
    pieces = []
    for coherence in (0.0, 1.0, 20.0):
        params = ImageAnalogies(coherence=coherence, levels=3)
        _, nnf, _, _ = image_analogies(style, sources[0], targets[0], params)
        pieces.append((np.diff(nnf, axis=1) == (0, 1)).all(axis=2).mean())
    assert pieces == sorted(pieces)
    assert pieces[2] > pieces[0] + 0.2
