"""Lines of a drawing along the edges of a model; noise on its blank paper."""

import numpy as np
import pytest

from eval.metrics.straightness import drawn_along, straight_edges
from eval.metrics.white_ground import noise_on_white

HEIGHT, WIDTH = 100, 140


@pytest.fixture
def edges():
    """Two edges of a model, one along and one down."""
    image = np.zeros((HEIGHT, WIDTH), np.uint8)
    image[30, 20:120] = 255
    image[40:90, 70] = 255
    return image


def drawing(edges, wobble=0.0):
    """White paper with a line along each edge, which lies up to ``wobble`` pixels beside it."""
    paper = np.full((HEIGHT, WIDTH, 3), 250, np.uint8)
    for y, x in zip(*np.nonzero(edges), strict=True):
        along, phase = (0, x) if y == 30 else (1, y)
        beside = round(wobble * np.sin(phase / 4))
        paper[(y + beside, x) if along == 0 else (y, x + beside)] = 40
    return paper


def test_edges_are_found_with_both_ends(edges):
    found = straight_edges(edges)
    assert len(found) >= 2
    lengths = np.linalg.norm(found[:, 1] - found[:, 0], axis=1)
    assert lengths.max() == pytest.approx(99, abs=3)


def test_a_line_on_its_edge_is_straight_and_whole(edges):
    off, lost = drawn_along(drawing(edges), edges)
    assert off < 0.05
    assert lost == 0


def test_a_line_that_wavers_is_off_by_as_much(edges):
    off, lost = drawn_along(drawing(edges, wobble=2.0), edges)
    assert off == pytest.approx(2 / np.sqrt(2), rel=0.25)
    assert lost < 0.05


def test_a_gap_is_a_lost_line(edges):
    image = drawing(edges)
    image[:, 20:70] = 250
    _, lost = drawn_along(image, edges)
    assert lost == pytest.approx(50 / 150, abs=0.08)


def test_blank_paper_has_no_lines_and_no_edges_no_measure(edges):
    assert drawn_along(np.full((HEIGHT, WIDTH, 3), 250, np.uint8), edges) is None
    assert drawn_along(drawing(edges), np.zeros_like(edges)) is None


def test_specks_are_counted_where_the_painting_is_blank():
    """The left half is painted, the right half blank; a speck counts in the right half alone."""
    places = np.zeros((60, 120), int)
    places[:, 60:] = 1
    style = np.full((60, 120, 3), 250, np.uint8)
    style[::2, :60] = 30
    assert noise_on_white(style, style, places, places) == (0.0, 0.0)
    image = style.copy()
    image[20:30, 80:100] = 100
    noise, specks = noise_on_white(image, style, places, places)
    assert specks == pytest.approx(200 / (60 * 56))
    assert noise == pytest.approx(150 * np.sqrt(specks))
    image = style.copy()
    image[20:30, 20:40] = 250
    assert noise_on_white(image, style, places, places) == (0.0, 0.0)


def test_a_painting_without_blank_paper_gives_no_number():
    places = np.zeros((60, 120), int)
    style = np.full((60, 120, 3), 250, np.uint8)
    style[::2] = 30
    assert noise_on_white(style, style, places, places) is None
