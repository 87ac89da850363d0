"""The numbers of split delta on input made by hand."""

import numpy as np
from small_scene import small_scene

from eval.metrics.split_delta import split_delta
from eval.scenes import Scene


def scene(**sizes):
    style, sources, targets = small_scene(**sizes)
    return Scene("small", None, ("a", "b"), style, tuple(sources), tuple(targets), 1)


def test_split_delta_is_that_of_the_guides_and_that_of_the_style():
    small = scene(source_size=(14, 15), target_size=(11, 10))
    rng = np.random.default_rng(5)
    image = rng.integers(0, 256, (11, 10, 3), dtype=np.uint8)
    nnf = rng.integers(2, 12, (11, 10, 2)).astype(np.int32)
    expected = np.zeros(2)
    pairs = [*zip(small.source_guides, small.target_guides, strict=True), (small.style, image)]
    for kind, source, target in zip((0, 0, 1), *zip(*pairs, strict=True), strict=True):
        padded = np.pad(target.astype(float), ((2, 2), (2, 2), (0, 0)), mode="edge")
        for y, x in np.ndindex(11, 10):
            q_y, q_x = nnf[y, x]
            patch = source[q_y - 2 : q_y + 3, q_x - 2 : q_x + 3]
            squares = ((padded[y : y + 5, x : x + 5] - patch) ** 2).sum()
            # μ = 2 over the 4 guide channels, 1 over the 3 of the style
            expected[kind] += squares * (2 / 4, 1 / 3)[kind] / 110
    np.testing.assert_allclose(split_delta(small, image, nnf), expected, rtol=1e-4)
