"""Differences of two images."""

import numpy as np
import pytest
from skimage.filters import gaussian
from small_scene import small_scene

from eval.scenes import Scene
from eval.similarity import flip, psnr, smooth_psnr, ssim


def scene(**sizes):
    style, sources, targets = small_scene(**sizes)
    return Scene("small", None, ("a", "b"), style, tuple(sources), tuple(targets), 1)


def test_psnr_and_ssim():
    image = scene().style
    shifted = np.where(image > 127, image - 10, image + 10).astype(np.uint8)
    assert psnr(image, image) == np.inf
    assert psnr(shifted, image) == pytest.approx(20 * np.log10(255 / 10))
    assert ssim(image, image) == pytest.approx(1)
    assert (
        ssim(gaussian(image, 3, channel_axis=2, preserve_range=True).astype(np.uint8), image) < 0.7
    )


def test_flip_is_none_for_the_same_image_and_one_for_the_most_different():
    """Green and blue, by which its colour difference is scaled."""
    image = np.zeros((40, 50, 3), np.uint8)
    green, blue = image + np.uint8([0, 255, 0]), image + np.uint8([0, 0, 255])
    assert flip(image, image) == 0
    assert flip(green, blue) == pytest.approx(1, abs=1e-3)
    assert 0 < flip(image + np.uint8(8), image) < flip(image + np.uint8(90), image) < 1
    assert flip(image[:, :, :1] + np.uint8(90), image[:, :, :1]) == flip(
        image + np.uint8(90), image
    )


def test_smoothed_images_differ_by_their_colours_and_not_by_their_strokes():
    strokes = np.zeros((40, 300, 3), np.uint8)
    strokes[:, ::2] = 100
    others = np.roll(strokes, 1, axis=1)
    assert psnr(strokes, others) < 10
    assert smooth_psnr(strokes, others) > 30
    assert smooth_psnr(strokes, strokes + np.uint8(20)) == pytest.approx(20 * np.log10(255 / 20))
