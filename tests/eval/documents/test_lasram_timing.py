"""Times of iterations, and what two threads can gain, on a texture of few pixels."""

import numpy as np

from eval.documents.lasram.timing import ceiling, timing


def test_every_shape_has_a_row_of_times():
    exemplar = np.random.default_rng(1).integers(0, 256, (24, 24), dtype=np.uint8)
    times = timing(exemplar, [(16, 4), (20, 5)])
    assert times["size of S"].tolist() == [16, 20]
    assert times["R"].tolist() == [4, 5]
    assert (times.filter(like="[ms]") > 0).all(axis=None)


def test_the_ceiling_is_that_of_memory_and_of_arithmetic():
    possible = ceiling()
    assert len(possible) == 2
    ratio = possible["1 thread [ms]"] / possible["2 threads [ms]"]
    np.testing.assert_allclose(possible["times as fast"], ratio, rtol=0.05)
