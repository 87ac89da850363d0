"""The numbers of sharpness on input made by hand."""

import numpy as np
import pytest
from skimage.filters import gaussian
from small_scene import small_scene

from eval.metrics.sharpness import detail, richness, sharpness
from eval.scenes import Scene
from stylit_ref import replay


def scene(**sizes):
    style, sources, targets = small_scene(**sizes)
    return Scene("small", None, ("a", "b"), style, tuple(sources), tuple(targets), 1)


def test_detail_sees_high_frequencies_only():
    ramp = np.tile(np.arange(0, 128, 2, dtype=np.uint8), (64, 1))
    board = (np.indices((64, 64)).sum(axis=0) % 2 * 100).astype(np.uint8)
    assert detail(ramp)[8:-8, 8:-8].max() < 1e-6
    assert detail(board)[8:-8, 8:-8].min() > 2000


def test_sharpness_is_one_for_a_copy_and_falls_with_blur():
    style = scene().style
    nnf = np.stack(np.mgrid[:40, :46], axis=-1)
    assert sharpness(style, style, nnf) == pytest.approx(1)
    blurred = gaussian(style, 0.8, channel_axis=2, preserve_range=True).astype(np.uint8)
    assert sharpness(blurred, style, nnf) < 0.5


def test_richness_falls_where_smooth_parts_are_preferred():
    style = scene().style.copy()
    style[:, 23:] = 128
    nnf = np.full((40, 46, 2), (20, 38), np.int32)
    smooth = replay(nnf, style)
    assert richness(style, style) == pytest.approx(1)
    assert richness(smooth, style) < 0.01
