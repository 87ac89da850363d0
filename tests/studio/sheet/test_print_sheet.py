"""What is printed."""

import re

import numpy as np
import pytest
from paper_photo import place_of

from stylit_ref import InputError
from stylit_ref.studio.sheet.layout import CODES, MARK, layout_of
from stylit_ref.studio.sheet.print_sheet import draw_sheet, print_sheet

PAPERS = {"A4": (2480, 3508), "Letter": (2550, 3300)}

UNPRINTABLE = 75
"""Dots at the edges of the paper that many printers leave white: a quarter of an inch."""


@pytest.mark.parametrize(("paper", "points"), [("A4", "595.2 841.92"), ("Letter", "612.0 792.0")])
def test_the_page_has_the_size_of_the_paper(rendering, ids, paper, points):
    pdf = print_sheet(rendering[0], ids, paper=paper)
    assert pdf.startswith(b"%PDF")
    assert re.search(rb"/MediaBox \[ ?0 0 " + points.encode().replace(b".", rb"\."), pdf)
    assert len(pdf) < 2_000_000


@pytest.mark.parametrize("paper", PAPERS)
@pytest.mark.parametrize("size", [(500, 500), (600, 456), (300, 900), (16, 8192), (8192, 16)])
def test_picture_and_marks_lie_within_what_printers_print(paper, size):
    layout, page = layout_of(*size), np.array(PAPERS[paper])
    place = (page - layout) // 2
    marks = layout.marks + place
    assert marks.min() >= UNPRINTABLE
    assert (marks <= page - UNPRINTABLE).all()


def test_picture_and_marks_do_not_touch():
    layout = layout_of(500, 500)
    inside = (layout.marks > (0, 0)) & (layout.marks < layout)
    assert not inside.all(axis=-1).any()


def test_no_mark_is_taken_for_another_one_nor_for_itself_turned():
    codes = [np.array([[int(cell) for cell in row] for row in code]) for code in CODES]
    turned = [(number, turns, np.rot90(codes[number], turns))
              for number in range(4) for turns in range(4)]  # fmt: skip
    for number, code in enumerate(codes):
        for other, turns, cells in turned:
            if (other, turns) != (number, 0):
                assert np.count_nonzero(code != cells) >= 6


def test_marks_are_black_and_white_and_the_picture_is_pale(sheet, rendering):
    layout, page = layout_of(500, 500), np.asarray(sheet)
    x, y = place_of(sheet, layout)
    for mark in (layout.marks + place_of(sheet, layout)).astype(int):
        square = page[mark[0, 1] : mark[2, 1], mark[0, 0] : mark[2, 0]]
        assert square.shape == (MARK, MARK)
        assert set(np.unique(square)) == {0, 255}
    picture = page[y : y + layout.height, x : x + layout.width]
    assert picture.min() == 150
    assert np.mean(picture > 175) > 0.98


def test_the_outline_lies_where_two_things_meet(sheet, rendering):
    layout, page = layout_of(500, 500), np.asarray(sheet)
    x, y = place_of(sheet, layout)
    dark = page[y : y + layout.height, x : x + layout.width] == 150
    rows, columns = np.nonzero(dark)
    radius = np.hypot(2 * rows / layout.height - 1, 2 * columns / layout.width - 1)
    assert np.abs(radius - np.sqrt(0.4)).max() < 0.01
    assert dark.sum() > 2 * np.pi * np.sqrt(0.4) * layout.width / 2  # more than a dot wide


def test_another_paper_is_refused(rendering, ids):
    with pytest.raises(InputError, match="paper"):
        draw_sheet(rendering[0], ids, paper="A3")
