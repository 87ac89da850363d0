"""Where the patches of an iteration are placed."""

import numpy as np
import pytest

from stylit_ref.randomness.random_stream import GRID, random_stream
from stylit_ref.texture.cells import cells_on, grid_cells

SIZE = (100, 140)
SEAMS = np.random.default_rng(1).integers(0, 100, (2, *SIZE), dtype=np.int32)


def apart(cells, size):
    """The least distance of two cells on the torus, the larger of both axes."""
    away = np.abs(cells[:, None] - cells[None])
    away = np.minimum(away, np.array(size) - away).max(axis=-1)
    return away[~np.eye(len(cells), dtype=np.bool_)].min()


@pytest.mark.parametrize("iteration", range(4))
@pytest.mark.parametrize("radius", [3, 8, 25])
def test_cells_do_not_overlap(radius, iteration):
    stream = random_stream(5, GRID, iteration=iteration)
    everywhere = np.arange(SIZE[0] * SIZE[1])
    for cells in (
        grid_cells(SIZE, radius, stream),
        cells_on(everywhere, SEAMS, radius, stream),
    ):
        assert len(cells) > 1
        assert apart(cells, SIZE) >= 2 * radius


def test_cells_lie_on_the_pixels_alone():
    pixels = np.flatnonzero(np.random.default_rng(0).random(SIZE) < 0.02)
    cells = cells_on(pixels, SEAMS, 8, random_stream(0, GRID))
    assert np.isin(cells[:, 0] * SIZE[1] + cells[:, 1], pixels).all()


def test_one_pixel_has_one_cell():
    cells = cells_on(np.array([1234]), SEAMS, 8, random_stream(0, GRID))
    assert cells.tolist() == [[1234 // 140, 1234 % 140]]
