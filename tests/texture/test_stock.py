"""Exemplars and their guides, laid out anew where parameters ask for more."""

from dataclasses import replace

import numpy as np
from small_textures import quick, spots

from stylit_ref.texture.stock import make_stock

IMAGES = [spots(1), spots(2, 40)]


def test_what_suffices_is_kept():
    stock = make_stock(IMAGES, quick(), None)
    assert stock.suiting(quick(radius=3, exponent=1)) is stock
    deformed = make_stock(IMAGES, quick(max_deformation=4), None)
    assert deformed.exemplars.fractions
    assert deformed.suiting(quick()) is deformed


def test_more_is_laid_out_anew():
    known = [spots(1)[:, :, 0] > 60, None]
    stock = make_stock(IMAGES, quick(), known)
    assert not stock.exemplars.fractions
    assert stock.suiting(quick(max_deformation=4)).exemplars.fractions
    assert stock.suiting(quick(), fractions=True).exemplars.fractions
    assert not stock.suiting(quick(max_deformation=4, whole_pixels=True)).exemplars.fractions
    larger = stock.suiting(quick(radius=15))
    assert larger.exemplars.largest_radius >= 15 > stock.exemplars.largest_radius
    assert larger.known is known
    counts = [np.count_nonzero(each.exemplars.clearance) for each in (stock, larger)]
    assert counts[0] == counts[1] == known[0].sum() + 40 * 40


def test_guides_lie_as_their_exemplars_do():
    stock = make_stock(IMAGES, quick(), None)
    assert stock.guide_weight(quick()) == 0
    assert stock.guide_colours.tolist() == [0]
    guided = replace(stock, guides=IMAGES)
    assert guided.guide_weight(quick()) > 0
    for each in (guided, guided.suiting(quick(radius=15, max_deformation=4))):
        assert np.array_equal(each.guide_colours, each.exemplars.colours)
