"""A sheet as it is printed, and with a painting on it."""

import numpy as np
import pytest
from paper_photo import a_painting, with_painting

from stylit_ref.studio.sheet.print_sheet import draw_sheet


@pytest.fixture(scope="session")
def rendering():
    """A grey ball on a light ground."""
    y, x = np.mgrid[-1:1:500j, -1:1:500j]
    ball = x * x + y * y < 0.4
    light = np.where(ball, 120 - 90 * x - 60 * y, 200 + 20 * y)
    return np.repeat(light[..., None], 3, axis=2).astype(np.uint8), ball


@pytest.fixture(scope="session")
def ids(rendering):
    """The ball is red, the ground green."""
    ball = rendering[1]
    return 255 * np.stack([ball, ~ball, 0 * ball], axis=2).astype(np.uint8)


@pytest.fixture(scope="session")
def sheet(rendering, ids):
    """The printed page, grey."""
    return draw_sheet(rendering[0], ids)


@pytest.fixture(scope="session")
def painting():
    """What was painted."""
    return a_painting(0)


@pytest.fixture(scope="session")
def painted(sheet, painting):
    """The page with the painting."""
    return with_painting(sheet, painting)
